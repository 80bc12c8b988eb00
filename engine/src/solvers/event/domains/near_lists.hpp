#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solvers/event/huge_pages.hpp"

namespace carom::event {

/// The number of a ball within a domain.
using Slot = std::uint16_t;
inline constexpr Slot kNoSlot = 0xffff;

/// For each ball of a domain the balls near to it: half a cache line, and more only where they are
/// many.
///
/// Holds: behind the last of a list, up to the next multiple of four, there are slots of balls, so
/// that four can be read at a time.
class NearLists {
 public:
  static constexpr std::uint32_t kShort = 15;

  void reset(std::size_t balls) {
    lists_.assign(balls + 1, List{});  // the last may be read a little beyond its end
    long_.clear();
    free_.clear();
  }

  [[nodiscard]] std::uint32_t size(Slot ball) const {
    const List& list = lists_[ball];
    return list.size <= kShort ? list.size : size_of_long(list);
  }
  [[nodiscard]] const Slot* items(Slot ball) const {
    const List& list = lists_[ball];
    return list.size <= kShort ? list.item : long_[list.item[0]].data();
  }

  void add(Slot ball, Slot other) {
    List& list = lists_[ball];
    if (list.size < kShort) {
      list.item[list.size++] = other;
    } else {
      add_to_long(list, other);
    }
  }

  /// Takes `other` out of the list, where it is in it; another may take its place.
  void remove(Slot ball, Slot other) {
    List& list = lists_[ball];
    if (list.size > kShort) {
      remove_from_long(list, other);
      return;
    }
    for (std::uint32_t k = 0; k < list.size; ++k) {
      if (list.item[k] != other) continue;
      list.item[k] = list.item[--list.size];
      return;
    }
  }

  void clear(Slot ball) {
    List& list = lists_[ball];
    if (list.size > kShort) free_.push_back(list.item[0]);
    list.size = 0;
  }

  [[nodiscard]] std::size_t bytes() const { return lists_.capacity() * sizeof(List); }

 private:
  static constexpr Slot kLong = kShort + 1;
  static constexpr std::uint32_t kAhead = 4;

  struct alignas(32) List {
    Slot item[kShort]{};
    Slot size = 0;  ///< kLong: item[0] is the number of a long list
  };

  [[nodiscard]] std::uint32_t size_of_long(const List& list) const {
    return static_cast<std::uint32_t>(long_[list.item[0]].size()) - kAhead;
  }

  // A long list has kAhead slots of balls behind its last.
  [[gnu::noinline]] void add_to_long(List& list, Slot other) {
    if (list.size == kShort) {
      if (free_.empty()) {
        free_.push_back(static_cast<Slot>(long_.size()));
        long_.emplace_back();
      }
      std::vector<Slot>& items = long_[free_.back()];
      items.assign(list.item, list.item + kShort);
      items.insert(items.end(), kAhead, Slot{0});
      list.item[0] = free_.back();
      list.size = kLong;
      free_.pop_back();
    }
    std::vector<Slot>& items = long_[list.item[0]];
    items[items.size() - kAhead] = other;
    items.push_back(0);
  }

  [[gnu::noinline]] void remove_from_long(List& list, Slot other) {
    const Slot number = list.item[0];
    std::vector<Slot>& items = long_[number];
    const auto end = items.end() - kAhead;
    const auto at = std::find(items.begin(), end, other);
    if (at == end) return;
    *at = *(end - 1);
    items.pop_back();
    if (items.size() - kAhead > kShort) return;
    list.size = kShort;
    std::copy_n(items.begin(), kShort, list.item);
    free_.push_back(number);
  }

  HugeVector<List> lists_;
  std::vector<std::vector<Slot>> long_;
  std::vector<Slot> free_;  ///< long lists that are not used
};

}  // namespace carom::event
