// Domains against one event loop over all balls: the same flights and counts to the last bit, for
// any windows, frames and workers.  Scenes are drawn at random; a failure names the seed.
#include "solvers/event/domains/domains.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "solvers/event/event_loop.hpp"
#include "support/event_setting.hpp"

namespace carom::event::domains_test {
namespace {

double sum(const std::vector<double>& terms) {
  ExactSum<double> sum;
  for (const double term : terms) sum.add(term);
  return sum.rounded();
}

/// A gas that loses nothing but by drag or friction, or (`loses`) one that falls and loses energy
/// in every impact or by drag: on a lattice of places, of any sizes, some fixed, sometimes one very
/// large ball, sometimes all in step, so that several meet at one instant.
Setting draw(unsigned seed, bool drags, bool loses = false) {
  Draw draw(seed);
  const int columns = draw.whole(6, 30);
  const int rows = draw.whole(6, 30);
  const bool in_step = draw.one_in(8);
  const bool equal = in_step || draw.one_in(2);
  const double most = draw.number(0.15, 0.48);
  Box box;
  box.width = columns;
  box.height = rows;
  box.periodic = {draw.one_in(2), draw.one_in(2)};
  // Periodic axes are to be long, by its radius.
  const bool giant = !in_step && columns > 12 && rows > 12 && !box.periodic[0] &&
                     !box.periodic[1] && draw.one_in(2);
  Setting setting;
  Rules& rules = setting.rules;
  rules.domain = carom::Domain(box, !draw.one_in(5));
  rules.scale = FixedTimeClock(0.25);
  rules.falls = loses || (!drags && draw.one_in(3));
  if (loses) {
    rules.rests = true;
    rules.restitution = draw.one_in(3) ? 1 : draw.number(0.5, 1);
    rules.wall_restitution = draw.number(0.2, 1);
  }
  if (rules.falls) {
    rules.gravity = {box.periodic[0] || draw.one_in(2) ? 0 : draw.number(-1, 1),
                     box.periodic[1] ? 0 : -5.0};
  }
  if (drags) rules.drag_rate = draw.number(0.01, 1);
  rules.spins = (!drags || loses) && draw.one_in(3);
  if (rules.spins) {
    rules.friction = draw.number(0, 0.5);
    rules.wall_friction = rules.gravity[0] != 0 ? 0 : draw.number(0, 0.5);
  }
  rules.all_species = {{equal ? most : 0.12, 1}, {equal ? most : 0.12, 0}};
  if (!equal) rules.all_species.push_back({most, draw.number(0.05, 5)});
  const double fast = draw.one_in(6) ? 300 : 3;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      if (giant && column > 0 && column < 11 && row > 0 && row < 11) continue;
      Disk disk;
      disk.species = equal || draw.one_in(2) ? 0 : 2;
      const bool fixed = draw.one_in(loses ? 40 : 15);
      if (fixed) disk.species = 1;
      const double off = in_step ? 0 : 0.49 - most;
      disk.x = 0.5 + column + draw.number(-off, off);
      disk.y = 0.5 + row + draw.number(-off, off);
      if (!fixed) {
        disk.vx = in_step ? draw.whole(-1, 1) : draw.number(-3, 3);
        disk.vy = in_step ? draw.whole(-1, 1) : draw.number(-3, 3);
      }
      setting.disks.push_back(disk);
      if (rules.spins) setting.spins.push_back(fixed ? 0 : draw.number(-5, 5));
    }
  }
  setting.disks.back().vx *= fast / 3;
  if (setting.disks.back().species == 1) setting.disks.back().vx = 0;
  if (giant) {
    rules.all_species.push_back({4.9, draw.one_in(3) ? 0.0 : 0.02});
    Disk disk;
    disk.species = static_cast<Index>(rules.all_species.size() - 1);
    disk.x = disk.y = 6;
    if (!rules.all_species.back().fixed()) disk.vx = draw.number(-1, 1);
    setting.disks.push_back(disk);
    if (rules.spins) setting.spins.push_back(0);
  }
  setting.time = draw.number(0.2, 1.5);
  return setting;
}

/// Whether one event loop has other bits where its balls are in another order, or where it begins
/// again on the way: of impacts of nearly one instant it may take some together.  Then there is
/// nothing to compare with.
template <class P>
bool depends_on_order(const Setting& setting, const EventLoop<P>& expected) {
  const std::size_t n = setting.disks.size();
  EventLoop<P> loop(setting.rules);
  loop.reset({setting.disks.rbegin(), setting.disks.rend()}, 0, {},
             {setting.spins.rbegin(), setting.spins.rend()});
  const FixedTime end = setting.rules.scale.ticks(setting.time);
  for (int k = 1; k <= 8; ++k) {
    loop.advance_to(end / 8 * k);
    const std::vector<double> spins = loop.spins();
    std::vector<Index> lefts(n);
    for (std::size_t i = 0; i < n; ++i) lefts[i] = loop.left(static_cast<Index>(i));
    loop.reset({loop.disks().begin(), loop.disks().end()}, end / 8 * k, lefts, spins);
  }
  loop.advance_to(end);
  for (std::size_t i = 0; i < n; ++i) {
    if (!same_flight(loop.disks()[n - 1 - i], expected.disks()[i])) return true;
  }
  return false;
}

struct Seen {
  unsigned scenes = 0;      ///< that tell something
  std::uint64_t again = 0;  ///< domains solved again
  std::uint64_t stuck = 0;  ///< runs that are none for domains
  std::uint64_t windows = 0;
};

template <class P>
void compare(unsigned seed, bool loses, Seen& seen) {
  const Setting setting = draw(seed, P::Law::kStretches, loses);
  const std::vector<Disk>& disks = setting.disks;
  EventLoop<P> loop(setting.rules);
  loop.reset(disks, 0, {}, setting.spins);
  const FixedTime end = setting.rules.scale.ticks(setting.time);
  loop.advance_to(end);
  if (depends_on_order<P>(setting, loop)) return;
  ++seen.scenes;
  Draw draw(seed + 1000000);
  for (const std::size_t workers : {1U, 2U, 3U, 6U}) {
    Domains<P> domains(setting.rules);
    if (draw.one_in(2)) domains.limit_windows(setting.rules.scale.ticks(draw.number(0.002, 0.3)));
    if (draw.one_in(2)) domains.follow_beyond(0);  // then more are solved again
    domains.set_workers(workers);
    domains.reset(disks, 0, setting.spins);
    const int frames = draw.whole(1, 12);
    for (int k = 1; k < frames; ++k) {
      advance(domains, end / frames * k, workers);
      if (domains.stuck()) break;
      if (draw.one_in(3)) static_cast<void>(domains.flight(0));
    }
    if (!domains.stuck()) advance(domains, end, workers);
    seen.again += domains.solved_again();
    seen.windows += domains.windows();
    seen.stuck += domains.stuck() ? 1U : 0U;
    if (domains.stuck()) continue;
    for (std::size_t i = 0; i < disks.size(); ++i) {
      ASSERT_TRUE(same_flight(domains.flight(i), loop.disks()[i]))
          << "seed " << seed << ", ball " << i << " of " << disks.size() << ", workers " << workers
          << ", frames " << frames << ", started at "
          << setting.rules.scale.seconds(domains.flight(i).start) << " and "
          << setting.rules.scale.seconds(loop.disks()[i].start) << " of " << setting.time;
      if (setting.rules.spins) {
        ASSERT_EQ(domains.spin(i), loop.spins()[i]) << "seed " << seed;
      }
    }
    EXPECT_EQ(domains.counts().ball_ball, loop.counts().ball_ball) << "seed " << seed;
    EXPECT_EQ(domains.counts().ball_wall, loop.counts().ball_wall) << "seed " << seed;
    EXPECT_EQ(domains.counts().joint_impacts, loop.counts().joint_impacts) << "seed " << seed;
    EXPECT_EQ(domains.counts().max_overlap, loop.counts().max_overlap) << "seed " << seed;
    EXPECT_EQ(sum(domains.losses()), setting.rules.only_drag_takes() ? 0 : sum(loop.losses()))
        << "seed " << seed << ", workers " << workers;
  }
}

template <class P>
Seen compare_all(unsigned scenes, bool loses = false) {
  Seen seen;
  for (unsigned seed = 1; seed <= scenes && !testing::Test::HasFailure(); ++seed) {
    compare<P>(seed, loses, seen);
  }
  EXPECT_GT(seen.scenes, scenes * 9 / 10);
  return seen;
}

// All of what is rare must have come.
void expect_all_seen(const Seen& seen, unsigned scenes) {
  EXPECT_GT(seen.windows, 10 * scenes);
  EXPECT_GT(seen.again, scenes / 4);
  EXPECT_LT(seen.stuck, scenes / 2);
}

TEST(Domains, HaveTheBitsOfOneEventLoop) {
  expect_all_seen(compare_all<Ballistic>(150), 150);
}

TEST(Domains, HaveTheBitsOfOneEventLoopWithDrag) {
  expect_all_seen(compare_all<Drag>(60), 60);
}

// Until a ball comes to rest, which ends a run of domains.
TEST(Domains, HaveTheBitsOfOneEventLoopWhereBallsFallAndLoseEnergy) {
  constexpr unsigned kScenes = 100;
  const Seen seen = compare_all<Ballistic>(kScenes, true);
  EXPECT_GT(seen.windows, 10 * kScenes);
  EXPECT_GT(seen.again, kScenes / 8);
  EXPECT_GT(seen.stuck, 4U) << "nothing has come to rest";
  EXPECT_LT(seen.stuck, 4 * kScenes / 2);
}

TEST(Domains, HaveTheBitsOfOneEventLoopWhereBallsFallWithDrag) {
  constexpr unsigned kScenes = 100;
  const Seen seen = compare_all<Drag>(kScenes, true);
  EXPECT_GT(seen.windows, 10 * kScenes);
  EXPECT_GT(seen.again, kScenes / 4);
  EXPECT_LT(seen.stuck, 4 * kScenes / 2);
}

// For a sanitizer of threads: what a phase reads is not written in it.
TEST(Domains, AreSolvedByThreads) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Setting setting = draw(seed, false);
    Domains<Ballistic> domains(setting.rules);
    constexpr std::size_t kWorkers = 4;
    domains.set_workers(kWorkers);
    domains.reset(setting.disks, 0, setting.spins);
    const FixedTime end = setting.rules.scale.ticks(0.2);
    std::size_t phase = domains.aim(end);
    while (phase != Phase::kFrameDone) {
      std::vector<std::thread> workers;
      for (std::size_t k = 0; k < kWorkers; ++k) {
        workers.emplace_back([&domains, phase, k] { domains.work(phase, {k, kWorkers}); });
      }
      for (std::thread& worker : workers) worker.join();
      phase = domains.finish(phase);
    }
    EXPECT_TRUE(domains.stuck() || domains.now() == end);
  }
}

}  // namespace
}  // namespace carom::event::domains_test
