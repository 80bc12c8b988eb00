// Processor time of the exact method for each collision, over density and number of balls, beside
// that of a plain event loop, in turns: mean and median of the slices.
// `carom_event [BALLS PACKING [WORKERS [SECONDS]]]` measures one case.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <vector>

#include "bench/plain_gas.hpp"
#include "carom/crew.hpp"
#include "solvers/event/domains/domains.hpp"

namespace {

using namespace carom::event;
using carom::bench::PlainGas;

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Equal disks in a square, in rows like a honeycomb, moving at random, and what is to be expected
/// of them.
struct Gas {
  double side = 0;
  std::vector<PlainGas::Ball> balls;
  double rate = 0;  ///< Enskog's: collisions a second in all
};

Gas make_gas(std::size_t n, double packing) {
  Gas gas;
  const double density = 4 * packing / M_PI;  // of disks of diameter 1
  gas.side = std::sqrt(static_cast<double>(n) / density);
  std::size_t rows = 2;
  while (static_cast<double>(rows * rows) < static_cast<double>(n) * 2 / std::sqrt(3.0)) rows += 2;
  const std::size_t columns = (n + rows - 1) / rows;
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  double px = 0;
  double py = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t rows_below = k / columns;
    const auto row = static_cast<double>(rows_below);
    const double shift = rows_below % 2 == 0 ? 0.25 : 0.75;
    const double x =
        (static_cast<double>(k % columns) + shift) * gas.side / static_cast<double>(columns);
    gas.balls.push_back(
        {x, (row + 0.5) * gas.side / static_cast<double>(rows), normal(random), normal(random)});
    px += gas.balls.back().vx;
    py += gas.balls.back().vy;
  }
  for (PlainGas::Ball& ball : gas.balls) {
    ball.vx -= px / static_cast<double>(n);
    ball.vy -= py / static_cast<double>(n);
  }
  const double chi = (1 - 7 * packing / 16) / ((1 - packing) * (1 - packing));
  gas.rate = static_cast<double>(n) * std::sqrt(M_PI) * density * chi;
  return gas;
}

/// Nanoseconds of each collision, by slice.
struct Slices {
  std::vector<double> each;
  double seconds = 0;
  double collisions = 0;

  void add(double spent, std::uint64_t hits) {
    seconds += spent;
    collisions += static_cast<double>(hits);
    each.push_back(1e9 * spent / static_cast<double>(std::max<std::uint64_t>(hits, 1)));
  }
  [[nodiscard]] double mean() const { return 1e9 * seconds / collisions; }
  [[nodiscard]] double median() {
    const auto middle = each.begin() + static_cast<std::ptrdiff_t>(each.size() / 2);
    std::nth_element(each.begin(), middle, each.end());
    return *middle;
  }
};

void measure(std::size_t n, double packing, std::size_t workers, double time_limit) {
  const Gas gas = make_gas(n, packing);
  carom::Box box;
  box.width = box.height = gas.side;
  box.periodic = {true, true};
  const FixedTimeClock scale(gas.side / 6);
  Domains<Ballistic> domains({carom::Domain(box, false), scale, {0, 0}, true, 1, 1, {Species{}}});
  std::vector<Disk> disks;
  for (const PlainGas::Ball& ball : gas.balls) {
    Disk disk;
    disk.x = ball.x;
    disk.y = ball.y;
    disk.vx = ball.vx;
    disk.vy = ball.vy;
    disks.push_back(disk);
  }
  domains.set_workers(workers);
  domains.reset(disks, 0, {});
  std::vector<carom::Phase> phases;
  for (std::size_t k = 0; k < Domains<Ballistic>::kPhases; ++k) {
    phases.push_back({"", [&domains, k](carom::Share share) { domains.work(k, share); },
                      [&domains, k] { return domains.finish(k); }});
  }
  carom::Crew crew(workers, std::move(phases));
  // In pieces, as time is counted from 0 again and again.
  const auto go_on = [&](double seconds) {
    const double longest = scale.seconds(FixedTimeClock::epoch() / 2);
    for (; seconds > 0; seconds -= longest) {
      if (domains.now() >= FixedTimeClock::epoch()) domains.rebase(FixedTimeClock::epoch());
      const std::size_t first =
          domains.aim(domains.now() + scale.ticks(std::min(seconds, longest)));
      if (first != carom::Phase::kFrameDone) crew.do_frame(first);
    }
  };
  PlainGas plain(gas.side, gas.balls);

  const auto balls = static_cast<double>(n);
  const double slice = std::max(2 * balls, 20000.0) / gas.rate;
  double now = std::max(4 * balls, 100000.0) / gas.rate;  // until it has forgotten its lattice
  go_on(now);
  plain.advance_to(now);
  Slices ours;
  Slices wall;
  Slices theirs;
  const double begin = wall_seconds();
  while (wall_seconds() - begin < time_limit || ours.each.size() < 3) {
    now += slice;
    const std::uint64_t before = domains.counts().ball_ball;
    const double from = processor_seconds();
    const double from_wall = wall_seconds();
    go_on(slice);
    const std::uint64_t hits = domains.counts().ball_ball - before;
    ours.add(processor_seconds() - from, hits);
    wall.add(wall_seconds() - from_wall, hits);
    const std::uint64_t plain_before = plain.collisions();
    const double plain_from = processor_seconds();
    plain.advance_to(now);
    theirs.add(processor_seconds() - plain_from, plain.collisions() - plain_before);
  }
  fmt::print("{:7.1f} {:9} {:8} {:9.0f} {:9.0f} {:9.0f} {:9.0f} {:9.0f} {:9}\n", packing, n,
             workers, ours.mean(), ours.median(), wall.median(), theirs.mean(), theirs.median(),
             domains.bytes() / n);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  fmt::print("Periodic equal disks, nanoseconds of a collision\n\n");
  fmt::print("{:>7} {:>9} {:>8} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "packing", "balls",
             "workers", "mean", "median", "by clock", "plain", "median", "bytes");
  if (argc > 2) {
    measure(std::strtoul(argv[1], nullptr, 10), std::strtod(argv[2], nullptr),
            argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 1,
            argc > 4 ? std::strtod(argv[4], nullptr) : 1);
    return 0;
  }
  for (const std::size_t n : {1000U, 10000U, 100000U, 1000000U}) {
    for (const double packing : {0.1, 0.5, 0.7}) {
      measure(n, packing, 1, 1);
      if (n >= 100000) measure(n, packing, 2, 1);
    }
  }
}
