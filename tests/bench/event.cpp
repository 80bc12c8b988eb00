// Collisions per second and bytes per ball of the exact method, over density and number of balls.
// `carom_event BALLS PACKING [SECONDS]` measures one case.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <utility>
#include <vector>

#include "solvers/event/tile.hpp"

namespace {

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

using namespace carom::event;

struct Lattice {
  unsigned columns, rows;
};

Lattice lattice(std::size_t n) {
  switch (n) {
    case 1000:
      return {25, 40};
    case 10000:
      return {100, 100};
    case 100000:
      return {250, 400};
    default:
      return {1000, 1000};
  }
}

void measure(std::size_t n, double packing, double time_limit) {
  const auto [columns, rows] = lattice(n);
  const double density = 4 * packing / M_PI;  // of disks of diameter 1
  const double spacing = std::sqrt(2 / (std::sqrt(3.0) * density));
  carom::Box box;
  box.width = columns * spacing;
  box.height = rows * spacing * std::sqrt(0.75);
  box.periodic = {true, true};
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<Disk> balls;
  for (unsigned r = 0; r < rows; ++r) {
    for (unsigned c = 0; c < columns; ++c) {
      Disk ball;
      ball.x = (c + (r % 2 == 0 ? 0.25 : 0.75)) * spacing;
      ball.y = (r + 0.5) * spacing * std::sqrt(0.75);
      ball.vx = normal(random);
      ball.vy = normal(random);
      balls.push_back(ball);
    }
  }
  // In blocks of 8 by 8, as a cell order would have them.  (Not by std::stable_sort, whose buffer
  // is not aligned as the disks are.)
  const auto block = [spacing](const Disk& ball) {
    return std::pair(std::floor(ball.y / (8 * spacing)), std::floor(ball.x / (8 * spacing)));
  };
  std::sort(balls.begin(), balls.end(),
            [&](const Disk& a, const Disk& b) { return block(a) < block(b); });
  double px = 0;
  double py = 0;
  for (const Disk& b : balls) {
    px += b.vx;
    py += b.vy;
  }
  for (Disk& b : balls) {
    b.vx -= px / static_cast<double>(n);
    b.vy -= py / static_cast<double>(n);
  }
  double energy = 0;
  for (const Disk& b : balls) energy += b.vx * b.vx + b.vy * b.vy;
  const TickScale scale(box.width / 6);
  // Enskog's collision rate, collisions a second in all
  const double chi = (1 - 7 * packing / 16) / ((1 - packing) * (1 - packing));
  const double rate = 0.5 * static_cast<double>(n) * 2 * std::sqrt(M_PI) * density * chi;
  Tile<Free> tile(Rules{carom::Domain(box, false), scale, {0, 0}, true, 1, 1, {Kind{}}});
  tile.reset(balls, 0);
  const double settle = (n > 500000 ? 1.0 : 10.0) * static_cast<double>(n) / rate / 2;
  tile.advance_to(scale.ticks(settle));
  const Counts before = tile.counts();
  const double begin = processor_seconds();
  double seconds = 0;
  double total = 0;
  double best = 1e300;
  std::uint64_t seen = before.ball_ball;
  const Ticks era = scale.ticks(settle);
  tile.rebase(era);
  while (seconds < time_limit) {
    const double span = std::min(10 * static_cast<double>(n), 20000.0) / rate;
    total += span;
    const Ticks until = scale.ticks(span);
    const double from = processor_seconds();
    tile.advance_to(until);
    const double now = processor_seconds();
    tile.rebase(until);
    best = std::min(best, (now - from) / static_cast<double>(tile.counts().ball_ball - seen));
    seen = tile.counts().ball_ball;
    seconds = now - begin;
  }
  const Counts& after = tile.counts();
  const auto hits = static_cast<double>(after.ball_ball - before.ball_ball);
  const auto each = [hits](std::uint64_t now, std::uint64_t then) {
    return static_cast<double>(now - then) / hits;
  };
  fmt::print("{:7.1f} {:9} {:9.3f} {:9.3f} {:9.0f} {:9.0f} {:9.2f} {:9.2f} {:9.3f}\n", packing, n,
             hits / seconds * 1e-6, 1e-6 / best, best * 1e9,
             static_cast<double>(tile.bytes()) / static_cast<double>(n),
             each(after.scans, before.scans), each(after.renewals, before.renewals),
             hits / (total * rate) / std::sqrt(energy / 2 / static_cast<double>(n)));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  fmt::print(
      "Periodic equal disks, one core, processor time.  Targets, M collisions/s at packing 0.1 / "
      "0.5 / 0.7:\n1,000: 1.44 2.15 3.01; 10,000: 1.12 1.89 2.67; 100,000: 0.60 1.46 2.22; "
      "1,000,000: 0.52 0.98 1.32\n\n");
  fmt::print("{:>7} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "packing", "balls", "M/s",
             "best M/s", "ns", "bytes", "scans", "renewals", "/Enskog");
  if (argc > 2) {
    measure(std::strtoul(argv[1], nullptr, 10), std::strtod(argv[2], nullptr),
            argc > 3 ? std::strtod(argv[3], nullptr) : 1);
    return 0;
  }
  for (const std::size_t n : {1000U, 10000U, 100000U, 1000000U}) {
    for (const double packing : {0.1, 0.5, 0.7}) measure(n, packing, 1);
  }
}
