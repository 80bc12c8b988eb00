#pragma once

#include <cstddef>
#include <string_view>
#include <tuple>

namespace carom::scene {

/// What a number of a scene may be, beside finite.
enum class Limit { none, positive, not_negative, fraction, power_of_two };

/// How a text or a list is read and written where its type alone does not say it.
enum class Form {
  plain,
  line,      ///< a text without control characters
  decimal,   ///< a text that holds a decimal number, of any length
  digits,    ///< one of the numbers of digits that can be computed with
  unused,    ///< checked, and kept nowhere
  workers,   ///< "per-ball" or a whole number
  script,    ///< lines with a command each
  streamed,  ///< a list that is read and written item by item
};

/// One key of an object of a scene: its name, where its value is kept, and all that reading,
/// checking, writing and the schema need to know of it.
template <class Object_, class Member_, Form kForm_ = Form::plain>
struct Key {
  using Object = Object_;
  using Member = Member_;
  static constexpr Form kForm = kForm_;

  std::string_view name;
  Member Object::*slot;
  std::string_view about = {};    ///< for the schema
  std::string_view example = {};  ///< of a key that is required: how it is written
  Limit limit = Limit::none;
  double most = 0;              ///< of a whole number; 0: as much as its type takes
  bool always_written = false;  ///< else only where it differs from the default

  [[nodiscard]] constexpr bool is_required() const { return !example.empty(); }

  [[nodiscard]] constexpr Key required(std::string_view how) const {
    Key key = *this;
    key.example = how;
    return key.always();
  }
  [[nodiscard]] constexpr Key always() const {
    Key key = *this;
    key.always_written = true;
    return key;
  }
  [[nodiscard]] constexpr Key limited(Limit to) const {
    Key key = *this;
    key.limit = to;
    return key;
  }
  [[nodiscard]] constexpr Key at_most(double number) const {
    Key key = *this;
    key.most = number;
    return key;
  }
};

template <Form kForm = Form::plain, class Object, class Member>
constexpr Key<Object, Member, kForm> key(std::string_view name, Member Object::*slot,
                                         std::string_view about = {}) {
  return {name, slot, about};
}

/// The keys of an object, and what messages call it, as in "a ball".  Each kind of object of a
/// scene has its specialization in table.hpp; all other keys are refused.
template <class Object>
struct Table;

template <class Object>
concept HasTable = requires {
  Table<Object>::kKeys;
};

/// Calls `visit` with each key of the object's table, in its order.
template <class Object, class Visit>
constexpr void for_each_key(Visit&& visit) {
  std::apply([&visit](const auto&... keys) { (visit(keys), ...); }, Table<Object>::kKeys);
}

template <class Object>
inline constexpr std::size_t kKeyCount = std::tuple_size_v<decltype(Table<Object>::kKeys)>;

}  // namespace carom::scene
