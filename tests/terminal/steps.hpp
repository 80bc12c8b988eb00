#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <string>

#include "terminal.hpp"

namespace carom::test {

/// The simulated time that the status line shows; negative if there is none.
inline double shown_time(const Terminal& terminal) {
  const std::string text = terminal.text();
  const auto unit = text.find(" s  ");  // of the status line
  if (unit == std::string::npos) return -1;
  const auto begin = text.rfind(' ', unit - 1);
  return std::strtod(text.c_str() + begin, nullptr);
}

/// The row of the status line: the last one, or the one above the line of keys.
inline int status_row(int rows) {
  return rows - (rows >= 12 ? 2 : 1);
}

/// The player ends at its key, and the terminal is as it was.
inline void expect_end_by_key(Terminal& terminal) {
  terminal.type("q");
  EXPECT_EQ(terminal.wait_for_end(), 0);
  EXPECT_TRUE(terminal.given_back());
}

/// The player stops at the stop key, and the terminal is as it was.
inline void expect_stop_by_key(Terminal& terminal) {
  terminal.type("\x1A");  // ^Z
  ASSERT_TRUE(terminal.wait_until_stopped());
  terminal.watch(std::chrono::milliseconds{50}, [] {});
  EXPECT_TRUE(terminal.given_back());
}

}  // namespace carom::test
