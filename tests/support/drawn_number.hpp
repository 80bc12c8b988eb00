#pragma once

#include <rapidcheck.h>

namespace carom::test {

/// A number that rapidcheck draws, from a million between the two.
inline double number(double least, double most) {
  return least + (most - least) * *rc::gen::inRange(0, 1 << 20) * 0x1p-20;
}

}  // namespace carom::test
