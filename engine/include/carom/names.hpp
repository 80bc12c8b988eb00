#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "carom/scene.hpp"

namespace carom {

/// A value of an enumeration and the word that scenes, options and reports write for it.
template <class Enum>
struct Name {
  Enum value;
  std::string_view word;
};

inline constexpr std::array kMethodNames{Name<Method>{Method::overlap, "overlap"},
                                         Name<Method>{Method::event, "event"}};
inline constexpr std::array kArrangementNames{
    Name<Fill::Arrangement>{Fill::Arrangement::random, "random"},
    Name<Fill::Arrangement>{Fill::Arrangement::square, "square"},
    Name<Fill::Arrangement>{Fill::Arrangement::hexagonal, "hexagonal"}};
inline constexpr std::array kOriginNames{Name<Box::Origin>{Box::Origin::corner, "corner"},
                                         Name<Box::Origin>{Box::Origin::center, "center"}};

/// Decimal digits that method `event` can compute with; 16 is double precision.
inline constexpr std::array kDigits{16, 34, 50, 100};

/// One worker thread for each ball.
inline constexpr std::string_view kPerBall = "per-ball";

/// The words of a table of names.
template <class Enum, std::size_t N>
constexpr std::array<std::string_view, N> words(const std::array<Name<Enum>, N>& names) {
  std::array<std::string_view, N> list{};
  for (std::size_t i = 0; i < N; ++i) list[i] = names[i].word;
  return list;
}

/// The known word that is the fewest typing errors away, the first of equals; empty where each is
/// more than `most` away.
std::string_view nearest_word(std::string_view unknown, std::span<const std::string_view> known,
                              std::size_t most = static_cast<std::size_t>(-1));

}  // namespace carom
