#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include "solvers/event/physics.hpp"
#include "solvers/event/rules.hpp"
#include "solvers/solver.hpp"

namespace carom::event {

/// What one event loop and a solver of windows are given alike.
struct Setting {
  Rules rules{carom::Domain(Box{}, true), FixedTimeClock(1)};
  std::vector<Disk> disks;
  std::vector<double> spins;  ///< none, or one a disk
  double time = 1;
};

/// Numbers that a setting is drawn with.
class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool one_in(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_) == 0; }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

 private:
  std::mt19937 random_;
};

/// Lets a solver of windows go on to a time; one thread does the work of all workers.
template <class Windows>
void advance(Windows& solver, FixedTime until, std::size_t workers) {
  std::size_t phase = solver.aim(until);
  while (phase != Phase::kFrameDone) {
    for (std::size_t k = 0; k < workers; ++k) solver.work(phase, {k, workers});
    phase = solver.finish(phase);
  }
}

template <class Disk>
bool same_flight(const Disk& a, const Disk& b) {
  return a.x == b.x && a.y == b.y && a.vx == b.vx && a.vy == b.vy && a.start == b.start &&
         a.species == b.species;
}

}  // namespace carom::event
