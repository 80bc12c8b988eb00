// Conflict groups against one event loop over all balls: the same flights and counts to the last
// bit, for any law of flight, windows, frames and workers.  Scenes are drawn at random; a failure
// names the seed.
#include "solvers/event/groups/conflict_groups.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include "solvers/event/event_loop.hpp"
#include "support/event_setting.hpp"

namespace carom::event::conflict_groups_test {
namespace {

/// Balls on a lattice of places, of any sizes, some fixed, some in step, so that several meet at
/// one instant.
Setting draw(unsigned seed, bool drags) {
  Draw draw(seed);
  const int columns = draw.whole(1, 6);
  const int rows = draw.whole(1, 6);
  const bool in_step = draw.one_in(5);
  const bool cradle = draw.one_in(6);
  Box box;
  box.width = columns + 0.5;
  box.height = rows + 0.5;
  box.periodic = {columns > 4 && draw.one_in(2), rows > 4 && draw.one_in(2)};
  Setting setting;
  Rules& rules = setting.rules;
  rules.domain = Domain(box, true);
  rules.scale = FixedTimeClock(0.25);
  rules.all_species.clear();
  rules.falls = draw.one_in(2);
  if (rules.falls) rules.gravity = {draw.one_in(2) ? 0 : draw.number(-1, 1), -9.81};
  if (drags) rules.drag_rate = draw.number(0.01, 1);
  // Drag without gravity lets nothing come to rest: losses would have no end.
  const bool loses = draw.one_in(2) && !(drags && !rules.falls);
  rules.rests = loses || (drags && rules.falls);
  rules.spins = draw.one_in(3);
  if (loses) {
    rules.restitution = draw.one_in(3) ? 1 : draw.number(0.2, 1);
    rules.wall_restitution = draw.one_in(3) ? 1 : draw.number(0.2, 1);
  }
  if (rules.spins) {
    rules.friction = draw.number(0, 0.5);
    rules.wall_friction = draw.number(0, 0.5);
  }
  rules.collisions = !draw.one_in(10);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      Disk disk;
      const bool fixed = draw.one_in(8);
      const double radius = in_step || cradle ? 0.5 : draw.number(0.1, 0.4);
      rules.all_species.push_back(
          {cradle ? 0.5 : radius / (in_step ? 2 : 1), fixed               ? 0
                                                      : in_step || cradle ? 1
                                                                          : draw.number(0.1, 10)});
      disk.species = static_cast<Index>(rules.all_species.size() - 1);
      const double off = in_step || cradle ? 0 : 0.09;
      disk.x = 0.75 + column + draw.number(-off, off) - (cradle ? 0.25 : 0);
      disk.y = 0.75 + row + draw.number(-off, off);
      if (!fixed && !(cradle && !draw.one_in(6))) {
        disk.vx = in_step ? draw.whole(-1, 1) : draw.number(-3, 3);
        disk.vy = in_step ? draw.whole(-1, 1) : draw.number(-3, 3);
      }
      setting.disks.push_back(disk);
    }
  }
  setting.time = draw.number(0.5, 3);
  return setting;
}

/// Where several balls join a contact that lasts at one instant, one event loop depends on their
/// order: then there is nothing to compare with.
template <class P>
bool depends_on_order(const Setting& setting, const EventLoop<P>& expected) {
  std::vector<Disk> disks(setting.disks.rbegin(), setting.disks.rend());
  EventLoop<P> loop(setting.rules);
  loop.reset(disks, 0);
  loop.advance_to(setting.rules.scale.ticks(setting.time));
  for (std::size_t i = 0; i < disks.size(); ++i) {
    if (!same_flight(loop.disks()[disks.size() - 1 - i], expected.disks()[i])) return true;
  }
  return false;
}

/// Whether the scene tells something.
template <class P>
bool compare(unsigned seed) {
  const Setting setting = draw(seed, P::Law::kStretches);
  const std::vector<Disk>& disks = setting.disks;
  EventLoop<P> loop(setting.rules);
  loop.reset(disks, 0);
  const FixedTime end = setting.rules.scale.ticks(setting.time);
  try {
    loop.advance_to(end);
  } catch (const std::runtime_error&) {
    return false;  // impacts without end
  }
  if (depends_on_order<P>(setting, loop)) return false;
  Draw draw(seed + 1000000);
  for (const std::size_t workers : {1U, 3U, 40U}) {
    ConflictGroups<P> groups(setting.rules);
    groups.set_workers(workers);
    groups.reset(disks, 0, {}, {});
    if (draw.one_in(2)) groups.limit_window(setting.rules.scale.ticks(draw.number(0.001, 0.3)));
    const int frames = draw.whole(1, 40);
    for (int k = 1; k < frames; ++k) advance(groups, end / frames * k, workers);
    advance(groups, end, workers);
    for (std::size_t i = 0; i < disks.size(); ++i) {
      EXPECT_TRUE(same_flight(groups.flight(i), loop.disks()[i]))
          << "seed " << seed << ", ball " << i << " of " << disks.size() << ", workers " << workers
          << ", gravity " << setting.rules.gravity[1] << ", started at "
          << setting.rules.scale.seconds(groups.flight(i).start) << " and "
          << setting.rules.scale.seconds(loop.disks()[i].start) << " of " << setting.time;
      if (setting.rules.spins) {
        EXPECT_EQ(groups.spin(i), loop.spins()[i]) << "seed " << seed;
      }
      EXPECT_EQ(groups.left(i), loop.left(static_cast<Index>(i))) << "seed " << seed;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        if (loop.turns()[axis].empty()) continue;
        EXPECT_EQ(groups.turns()[axis][i], loop.turns()[axis][i]) << "seed " << seed;
      }
    }
    EXPECT_EQ(groups.counts().ball_ball, loop.counts().ball_ball) << "seed " << seed;
    EXPECT_EQ(groups.counts().ball_wall, loop.counts().ball_wall) << "seed " << seed;
    EXPECT_EQ(groups.counts().joint_impacts, loop.counts().joint_impacts) << "seed " << seed;
    EXPECT_EQ(groups.counts().resting_contacts, loop.counts().resting_contacts) << "seed " << seed;
    EXPECT_EQ(groups.counts().max_overlap, loop.counts().max_overlap) << "seed " << seed;
    EXPECT_EQ(groups.given_ahead(end), loop.given_ahead(end)) << "seed " << seed;
  }
  return true;
}

constexpr unsigned kScenes = 200;

template <class P>
void compare_all() {
  unsigned told = 0;
  for (unsigned seed = 1; seed <= kScenes && !testing::Test::HasFailure(); ++seed) {
    told += compare<P>(seed) ? 1U : 0U;
  }
  EXPECT_GT(told, kScenes * 9 / 10);
}

TEST(ConflictGroups, HaveTheBitsOfOneEventLoop) {
  compare_all<Ballistic>();
}

/// Balls of radius 1/2 in a row at these places of a box so wide; the first one comes at 10.
Setting row_hit_from_the_left(double width, const std::vector<double>& places) {
  Setting setting;
  Box box;
  box.width = width;
  box.height = 4;
  setting.rules.domain = Domain(box, true);
  setting.rules.scale = FixedTimeClock(0.25);
  setting.rules.all_species = {{0.5, 1}};
  for (const double x : places) {
    Disk disk;
    disk.x = x;
    disk.y = 2;
    disk.vx = setting.disks.empty() ? 10 : 0;
    setting.disks.push_back(disk);
  }
  return setting;
}

// Three balls in a row, the last of which the middle one comes to only after it was hit: the group
// of two is solved, tested again and solved once more with the third.
TEST(ConflictGroups, LittleThatIsSolvedAgainWakesNoWorkers) {
  const Setting setting = row_hit_from_the_left(20, {2, 4, 6});
  const auto phases_of = [&](std::size_t workers) {
    ConflictGroups<Ballistic> groups(setting.rules);
    groups.set_workers(workers);
    groups.reset(setting.disks, 0, {}, {});
    std::size_t phases = 0;
    for (std::size_t phase = groups.aim(setting.rules.scale.ticks(0.25));
         phase != Phase::kFrameDone; phase = groups.finish(phase)) {
      for (std::size_t k = 0; k < workers; ++k) groups.work(phase, {k, workers});
      ++phases;
    }
    EXPECT_EQ(groups.counts().ball_ball, 2U);
    EXPECT_EQ(groups.windows(), 1U);
    EXPECT_EQ(groups.passes(), 3U);
    return phases;
  };
  EXPECT_EQ(phases_of(3), 3U);
  EXPECT_EQ(phases_of(1), 6U);
}

// Two balls between two walls are one group in nearly every window.
TEST(ConflictGroups, WorkersSolveTheLargestInTurn) {
  const Setting setting = row_hit_from_the_left(3, {1, 2.25});
  constexpr std::size_t kWorkers = 3;
  ConflictGroups<Ballistic> groups(setting.rules);
  groups.set_workers(kWorkers);
  groups.limit_window(setting.rules.scale.ticks(0.1));
  groups.reset(setting.disks, 0, {}, {});
  std::array<std::size_t, kWorkers> solved{};
  for (std::size_t phase = groups.aim(setting.rules.scale.ticks(6)); phase != Phase::kFrameDone;
       phase = groups.finish(phase)) {
    for (std::size_t k = 0; k < kWorkers; ++k) {
      const auto before = groups.flight(0);
      groups.work(phase, {k, kWorkers});
      const bool changed = !same_flight(groups.flight(0), before);
      if (phase == ConflictGroups<Ballistic>::kResolve && changed) ++solved.at(k);
    }
  }
  const std::size_t all = solved[0] + solved[1] + solved[2];
  EXPECT_GT(all, 20U);
  for (const std::size_t one : solved) EXPECT_GT(6 * one, all);
}

// For a sanitizer of threads: what a phase reads is not written in it.
TEST(ConflictGroups, AreSolvedByThreads) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const Setting setting = draw(seed, false);
    ConflictGroups<Ballistic> groups(setting.rules);
    constexpr std::size_t kWorkers = 4;
    groups.set_workers(kWorkers);
    groups.reset(setting.disks, 0, {}, {});
    const FixedTime end = setting.rules.scale.ticks(0.3);
    std::atomic<bool> endless = false;
    std::size_t phase = groups.aim(end);
    while (phase != Phase::kFrameDone) {
      std::vector<std::thread> workers;
      for (std::size_t k = 0; k < kWorkers; ++k) {
        workers.emplace_back([&groups, &endless, phase, k] {
          try {
            groups.work(phase, {k, kWorkers});
          } catch (const std::runtime_error&) {
            endless = true;
          }
        });
      }
      for (std::thread& worker : workers) worker.join();
      if (endless) break;
      phase = groups.finish(phase);
    }
    EXPECT_TRUE(endless || groups.now() == end);
  }
}

TEST(ConflictGroups, HaveTheBitsOfOneEventLoopWithDrag) {
  compare_all<Drag>();
}

}  // namespace
}  // namespace carom::event::conflict_groups_test
