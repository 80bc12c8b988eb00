// What the exact method's pure functions cost, nanoseconds a call; `--fixed disks N` instead holds
// N random and near-tangent flights past a fixed ball against Sturm's theorem in a hundred digits.

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "contact/pair_impact.hpp"
#include "solvers/event/pair_lanes.hpp"
#include "support/peg_truth.hpp"
#include "trajectory/pair_time.hpp"
#include "trajectory/wall_time.hpp"

namespace {

using namespace carom;
using event::Vec;

constexpr int kCalls = 1 << 14;

struct Pairs {
  event::Lanes rx, ry, vx, vy, s;
};

/// The best of a few rounds.
template <class Work>
double nanoseconds_a_call(const Work& work) {
  double best = 1e300;
  for (int round = 0; round < 9; ++round) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
    best = std::min(best, spent.count() / kCalls);
  }
  return best;
}

double textbook_time(const Vec<double>& r, const Vec<double>& v, double s) {
  const double b = r.x * v.x + r.y * v.y;
  const double vv = v.x * v.x + v.y * v.y;
  const double discriminant = b * b - vv * (r.x * r.x + r.y * r.y - s * s);
  return b < 0 && discriminant > 0 ? (-b - std::sqrt(discriminant)) / vv : event::never<double>();
}

int hold_fixed_disks(int count) {
  test::RandomNumbers random(1);
  int faults = 0;
  int hits = 0;
  for (int k = 0; k < count; ++k) {
    const auto c = test::random_fixed_disk_case(random);
    if (!c.from_contact && event::squared_gap(c.r, c.s) <= 0) continue;
    if (c.from_contact && event::sharp_dot(c.r, c.v) <= 0) continue;
    const double t = event::fixed_disk_time(c.r, c.v, c.g, c.s, c.from_contact);
    hits += t < event::never<double>() ? 1 : 0;
    if (const char* fault = test::fixed_disk_fault(c, t)) {
      ++faults;
      fmt::print("case {}: {}\n", k, fault);
    }
  }
  fmt::print("{} flights past a fixed ball, {} hits, {} faults\n", count, hits, faults);
  return faults == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::strcmp(argv[1], "--pegs") == 0)
    return hold_fixed_disks(static_cast<int>(std::strtol(argv[2], nullptr, 10)));

  test::RandomNumbers random(1);
  std::vector<Pairs> lanes(kCalls / event::kLanes);
  std::vector<test::FixedDiskCase> fixed_disks;
  for (auto& block : lanes) {
    for (std::uint32_t k = 0; k < event::kLanes; ++k) {
      const double angle = random.angle();
      const double distance = random.between(1, 2);
      block.rx[k] = distance * std::cos(angle);
      block.ry[k] = distance * std::sin(angle);
      block.vx[k] = random.between(-1, 1);
      block.vy[k] = random.between(-1, 1);
      block.s[k] = 1;
      fixed_disks.push_back(test::random_fixed_disk_case(random));
    }
  }
  std::vector<double> out(kCalls);
  const auto each = [&](const auto& function) {
    return nanoseconds_a_call([&] {
      for (std::size_t n = 0; n < kCalls; ++n) {
        const auto& block = lanes[n / event::kLanes];
        const std::size_t k = n % event::kLanes;
        out[n] = function(Vec<double>{block.rx[k], block.ry[k]},
                          Vec<double>{block.vx[k], block.vy[k]}, block.s[k]);
      }
    });
  };
  fmt::print("pair, textbook form      {:8.1f} ns\n", each(textbook_time));
  fmt::print("pair                     {:8.1f} ns\n", each(event::pair_time<double>));
  fmt::print("pair, four at a time     {:8.1f} ns\n", nanoseconds_a_call([&] {
               for (std::size_t n = 0; n < lanes.size(); ++n) {
                 const Pairs& four = lanes[n];
                 const event::Lanes times =
                     event::pair_times(four.rx, four.ry, four.vx, four.vy, four.s);
                 for (std::uint32_t k = 0; k < event::kLanes; ++k)
                   out[event::kLanes * n + k] = times[k];
               }
             }));
  fmt::print("pair impact              {:8.1f} ns\n",
             each([](const Vec<double>& r, const Vec<double>& v, double) {
               const double toward = event::sharp_dot(r, v) < 0 ? 1 : -1;
               return event::pair_impact<double>(r, {0, 0}, toward * v, 1, 1, 1).b.x;
             }));
  fmt::print("wall under gravity       {:8.1f} ns\n",
             each([](const Vec<double>& r, const Vec<double>& v, double s) {
               return event::wall_time(std::abs(r.x), v.y, -s);
             }));
  fmt::print("fixed ball under gravity {:8.1f} ns\n", nanoseconds_a_call([&] {
               for (std::size_t n = 0; n < kCalls; ++n) {
                 const auto& c = fixed_disks[n];
                 out[n] = event::fixed_disk_time(c.r, c.v, c.g, c.s, c.from_contact);
               }
             }));
  return 0;
}
