#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace carom::scene {

/// A JSON pointer that is put together only where something is told of it: of millions of balls
/// nearly all are right.
///
/// Holds: as long as what it was made from.
class Place {
 public:
  constexpr Place(std::string_view pointer) : step_(pointer) {}  // NOLINT: as a text
  constexpr Place(const char* pointer) : step_(pointer) {}       // NOLINT

  /// A member, or an item, of what is at this place.
  [[nodiscard]] constexpr Place operator/(std::string_view key) const { return {*this, key}; }
  [[nodiscard]] constexpr Place operator/(std::size_t index) const { return {*this, index}; }

  [[nodiscard]] std::string text() const {
    if (outer_ == nullptr) return std::string(step_);
    return step_.data() == nullptr ? fmt::format("{}/{}", outer_->text(), index_)
                                   : fmt::format("{}/{}", outer_->text(), step_);
  }

 private:
  constexpr Place(const Place& outer, std::string_view key) : outer_(&outer), step_(key) {}
  constexpr Place(const Place& outer, std::size_t index) : outer_(&outer), index_(index) {}

  const Place* outer_ = nullptr;
  std::string_view step_;  // none: an index
  std::size_t index_ = 0;
};

}  // namespace carom::scene
