// Collisions per second and bytes per ball of the exact method, over density and number of balls.
// `carom_event BALLS PACKING [SECONDS]` measures one case, `carom_event workers BALLS PACKING
// [SECONDS]` one worker against two.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <string_view>
#include <utility>
#include <vector>

#include "carom/crew.hpp"
#include "solvers/event/tile.hpp"
#include "solvers/event/windows.hpp"

namespace {

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

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

/// Equal disks in a box they fill, moving at random, and what is to be expected of them.
struct Gas {
  carom::Box box;
  std::vector<Disk> balls;
  double rate = 0;  ///< Enskog's: collisions a second in all

  [[nodiscard]] Rules rules(const TickScale& scale) const {
    return {carom::Domain(box, false), scale, {0, 0}, true, 1, 1, {Kind{}}};
  }
};

Gas make_gas(std::size_t n, double packing) {
  const auto [columns, rows] = lattice(n);
  const double density = 4 * packing / M_PI;  // of disks of diameter 1
  const double spacing = std::sqrt(2 / (std::sqrt(3.0) * density));
  Gas gas;
  carom::Box& box = gas.box;
  box.width = columns * spacing;
  box.height = rows * spacing * std::sqrt(0.75);
  box.periodic = {true, true};
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<Disk>& balls = gas.balls;
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
  const double chi = (1 - 7 * packing / 16) / ((1 - packing) * (1 - packing));
  gas.rate = 0.5 * static_cast<double>(n) * 2 * std::sqrt(M_PI) * density * chi;
  return gas;
}

void measure(std::size_t n, double packing, double time_limit) {
  const Gas gas = make_gas(n, packing);
  const std::vector<Disk>& balls = gas.balls;
  const double rate = gas.rate;
  double energy = 0;
  for (const Disk& b : balls) energy += b.vx * b.vx + b.vy * b.vy;
  const TickScale scale(gas.box.width / 6);
  Tile<Ballistic> tile(gas.rules(scale));
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

/// The same gas in one tile, and in parts by as many workers, in turns of some 20,000 collisions:
/// the wall-clock times, and the processor time that the busiest worker of each phase needed.
void measure_workers(std::size_t n, double packing, std::size_t workers, double time_limit) {
  const Gas gas = make_gas(n, packing);
  const TickScale scale(gas.box.width / 6);
  Tile<Ballistic> tile(gas.rules(scale));
  tile.reset(gas.balls, 0);
  const Ticks settle = scale.ticks(5 * static_cast<double>(n) / gas.rate);
  tile.advance_to(settle);
  tile.rebase(settle);
  Windows<Ballistic> windows(gas.rules(scale), {workers});
  windows.reset({tile.disks().begin(), tile.disks().end()}, 0);

  std::vector<double> spent(workers);
  double critical = 0;
  std::vector<carom::Phase> phases;
  for (std::size_t k = 0; k < Windows<Ballistic>::kPhases; ++k) {
    phases.push_back({"",
                      [&, k](carom::Share share) {
                        const double from = thread_seconds();
                        windows.work(k, share);
                        spent[share.index] = thread_seconds() - from;
                      },
                      [&, k] {
                        critical += *std::max_element(spent.begin(), spent.end());
                        const double from = thread_seconds();
                        const std::size_t next = windows.finish(k);
                        critical += thread_seconds() - from;
                        return next;
                      }});
  }
  carom::Crew crew(workers, std::move(phases));
  const auto now = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  };
  std::vector<double> ratios;
  double alone = 0;
  double seconds = 0;
  const std::uint64_t before = tile.counts().ball_ball;
  for (Ticks until = scale.ticks(20000 / gas.rate); seconds < time_limit && !windows.stuck();
       until += scale.ticks(20000 / gas.rate)) {
    const double begin = now();
    const double from = thread_seconds();
    tile.advance_to(until);
    alone += thread_seconds() - from;
    const double middle = now();
    const std::size_t first = windows.aim(until);
    if (first != carom::Phase::kFrameDone) crew.do_frame(first);
    const double end = now();
    ratios.push_back((middle - begin) / (end - middle));
    seconds += end - begin;
  }
  std::size_t differ = 0;
  for (Index i = 0; i < n; ++i) {
    const Disk& a = tile.disks()[i];
    const Disk& b = windows.flight(i);
    differ += a.x == b.x && a.y == b.y && a.vx == b.vx && a.start == b.start ? 0U : 1U;
  }
  std::nth_element(ratios.begin(), ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2),
                   ratios.end());
  const auto hits = static_cast<double>(tile.counts().ball_ball - before);
  const auto count = static_cast<double>(windows.windows());
  fmt::print("{:7.1f} {:9} {:9} {:9.2f} {:9.2f} {:9.0f} {:9.2f} {:9.0f} {:9}\n", packing, n,
             workers, ratios[ratios.size() / 2], alone / critical, hits / count,
             static_cast<double>(windows.solved_again()) / count,
             static_cast<double>(windows.bytes()) / static_cast<double>(n), differ);
  std::fflush(stdout);
}

void print_workers_heading() {
  fmt::print("{:>7} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "packing", "balls",
             "workers", "wall 1:n", "cpu 1:n", "hits/win", "again/win", "bytes", "differ");
}

}  // namespace

int main(int argc, char** argv) {
  fmt::print(
      "Periodic equal disks, one core, processor time.  Targets, M collisions/s at packing 0.1 / "
      "0.5 / 0.7:\n1,000: 1.44 2.15 3.01; 10,000: 1.12 1.89 2.67; 100,000: 0.60 1.46 2.22; "
      "1,000,000: 0.52 0.98 1.32\n\n");
  fmt::print("{:>7} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "packing", "balls", "M/s",
             "best M/s", "ns", "bytes", "scans", "renewals", "/Enskog");
  if (argc > 3 && std::string_view(argv[1]) == "workers") {
    print_workers_heading();
    measure_workers(std::strtoul(argv[2], nullptr, 10), std::strtod(argv[3], nullptr), 2,
                    argc > 4 ? std::strtod(argv[4], nullptr) : 1);
    return 0;
  }
  if (argc > 2) {
    measure(std::strtoul(argv[1], nullptr, 10), std::strtod(argv[2], nullptr),
            argc > 3 ? std::strtod(argv[3], nullptr) : 1);
    return 0;
  }
  for (const std::size_t n : {1000U, 10000U, 100000U, 1000000U}) {
    for (const double packing : {0.1, 0.5, 0.7}) measure(n, packing, 1);
  }
  fmt::print(
      "\nOne worker's time against that of two, and the least that waiting for each other "
      "leaves of it\n\n");
  print_workers_heading();
  for (const std::size_t n : {10000U, 100000U}) {
    for (const double packing : {0.1, 0.3, 0.5, 0.7}) measure_workers(n, packing, 2, 2);
  }
}
