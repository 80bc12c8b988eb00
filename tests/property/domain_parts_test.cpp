// What a domain is made of, each against a slow reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "solvers/event/domains/approach.hpp"
#include "solvers/event/domains/bucket_queue.hpp"
#include "solvers/event/domains/cell_chains.hpp"
#include "solvers/event/domains/near_lists.hpp"
#include "solvers/event/domains/near_search.hpp"
#include "trajectory/pair_time.hpp"

namespace carom::event::domain_parts_test {
namespace {

double number(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
std::uint32_t below(std::mt19937& random, std::uint32_t limit) {
  return std::uniform_int_distribution<std::uint32_t>(0, limit - 1)(random);
}

TEST(BucketQueue, GivesEventsInTheOrderOfTime) {
  unsigned preceding = 0;
  unsigned missed = 0;  // as the event is beyond the present bucket
  for (unsigned seed = 1; seed <= 300; ++seed) {
    std::mt19937 random(seed);
    const std::uint32_t balls = 1 + below(random, 60);
    const FixedTime window = 1 + below(random, 1000);
    BucketQueue queue;
    std::map<Slot, FixedTime> expected;
    FixedTime now = 0;
    queue.reset(balls, window, seed % 3 == 0 ? 4 : 1);
    for (int step = 0; step < 300; ++step) {
      const auto ball = static_cast<Slot>(below(random, balls));
      switch (below(random, 4)) {
        case 0:
          queue.remove(ball);
          expected.erase(ball);
          break;
        case 1: {
          const FixedTime until = now + below(random, 1 + static_cast<std::uint32_t>(window - now));
          const auto first =
              std::min_element(expected.begin(), expected.end(),
                               [](const auto& a, const auto& b) { return a.second < b.second; });
          const Slot given = queue.first(until);
          if (expected.empty() || first->second > until) {
            ASSERT_EQ(given, kNoSlot) << seed;
            break;
          }
          ASSERT_NE(given, kNoSlot) << seed;
          ASSERT_EQ(expected.at(given), first->second) << seed;
          ASSERT_EQ(queue.time(given), first->second) << seed;
          now = first->second;
          queue.remove(given);
          expected.erase(given);
          break;
        }
        default:
          if (expected.count(ball) > 0) break;
          expected[ball] = now + below(random, 1 + static_cast<std::uint32_t>(window - now));
          queue.add(ball, expected[ball]);
      }
      ASSERT_EQ(queue.holds(ball), expected.count(ball) > 0) << seed;
      // Once the first has been asked for, nothing comes before it.
      if (queue.first(window) == kNoSlot) continue;
      const FixedTime time = now + below(random, 1 + static_cast<std::uint32_t>(window - now));
      const bool later = std::all_of(expected.begin(), expected.end(), [&](const auto& event) {
        return event.first == ball || event.second > time;
      });
      if (queue.precedes(time, ball)) {
        ++preceding;
        ASSERT_TRUE(later) << seed;
      } else if (later) {
        ++missed;
      }
    }
  }
  EXPECT_GT(preceding, 500U);
  EXPECT_LT(missed, 20 * preceding);
}

TEST(NearLists, HoldWhatWasPutIn) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    std::mt19937 random(seed);
    constexpr std::uint32_t kBalls = 60;
    NearLists lists;
    lists.reset(kBalls);
    std::vector<std::set<Slot>> expected(kBalls);
    for (int step = 0; step < 400; ++step) {
      const auto ball = static_cast<Slot>(below(random, 4));
      const auto other = static_cast<Slot>(below(random, kBalls));
      if (below(random, 60) == 0) {
        lists.clear(ball);
        expected[ball].clear();
      } else if (below(random, 3) == 0) {
        lists.remove(ball, other);
        expected[ball].erase(other);
      } else if (expected[ball].insert(other).second) {
        lists.add(ball, other);
      }
      if (below(random, 40) == 0) {
        NearLists::Gathered near;
        near.clear();
        expected[ball].clear();
        const std::uint32_t groups = below(random, 8);
        for (std::uint32_t k = 0; k < groups; ++k) {
          const std::uint32_t mask = seed % 4 == 0 ? 255 : below(random, 256);
          std::array<Slot, 8> some{};
          for (std::uint32_t b = 0; b < 8; ++b)
            some[b] = static_cast<Slot>(8 * k + (b * 3 + k) % 8);
          const bool in_row = below(random, 2) == 0;
          if (in_row) {
            near.add(8 * k, mask);
          } else {
            near.add(some.data(), mask);
          }
          for (std::uint32_t b = 0; b < 8; ++b) {
            const auto in_order = static_cast<Slot>(8 * k + b);
            if ((mask >> b & 1) != 0) expected[ball].insert(in_row ? in_order : some[b]);
          }
        }
        lists.clear(ball);
        lists.set(ball, near);
      }
      for (Slot k = 0; k < 5; ++k) {
        const std::uint32_t size = lists.size(k);
        const Slot* const items = lists.items(k);
        ASSERT_EQ(std::set<Slot>(items, items + size), expected[k]) << seed;
        ASSERT_EQ(size, expected[k].size()) << seed;
        for (std::uint32_t n = 0; n < size; n += 8) {
          for (std::uint32_t l = n; l < n + 8; ++l) ASSERT_LE(items[l], kBalls) << seed;
        }
      }
    }
  }
}

/// Places in a plane that wraps or not, some of them beyond its ends.
struct Plane {
  std::array<double, 2> half;
  std::array<double, 2> periods{0, 0};
  std::vector<std::array<double, 2>> places;

  explicit Plane(std::mt19937& random) : half{number(random, 1, 9), number(random, 1, 9)} {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (below(random, 2) == 0) periods[axis] = 2 * half[axis];
    }
    const std::uint32_t balls = 1 + below(random, 150);
    for (std::uint32_t k = 0; k < balls; ++k) {
      places.push_back({number(random, -1.3, 1.3) * half[0], number(random, -1.3, 1.3) * half[1]});
    }
  }
  [[nodiscard]] double distance(std::size_t i, std::size_t j) const {
    double square = 0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      double d = places[i][axis] - places[j][axis];
      if (periods[axis] > 0) d -= periods[axis] * std::rint(d / periods[axis]);
      square += d * d;
    }
    return std::sqrt(square);
  }
};

TEST(CellChains, GiveAllThatAreNearOnce) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    std::mt19937 random(seed);
    Plane plane(random);
    const auto n = static_cast<Slot>(plane.places.size());
    const double side = number(random, 0.2, 3);
    CellChains cells;
    cells.reset(plane.half, plane.periods, side, n);
    const auto put = [&](Slot k) {
      cells.add(k, cells.cell_at(plane.places[k][0], plane.places[k][1]));
    };
    for (Slot k = 0; k < n; ++k) put(k);
    for (int move = 0; move < 40; ++move) {
      const auto k = static_cast<Slot>(below(random, n));
      cells.remove(k);
      for (double& x : plane.places[k]) x += number(random, -1, 1);
      put(k);
    }
    for (Slot i = 0; i < n; ++i) {
      std::vector<Slot> seen;
      cells.each_near(cells.cell_of(i), [&](Slot k) { seen.push_back(k); });
      std::sort(seen.begin(), seen.end());
      ASSERT_TRUE(std::adjacent_find(seen.begin(), seen.end()) == seen.end()) << seed;
      for (Slot k = 0; k < n; ++k) {
        if (plane.distance(i, k) > side) continue;
        ASSERT_TRUE(std::binary_search(seen.begin(), seen.end(), k)) << seed;
      }
    }
  }
}

TEST(NearSearch, FindsAllThatAreNearAndFewOthers) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    std::mt19937 random(seed);
    const Plane plane(random);
    const auto n = static_cast<std::uint32_t>(plane.places.size());
    const double reach = number(random, 0.1, 1);
    std::vector<double> radii;
    NearSearch search;
    search.reset(n, plane.half, plane.periods, reach);
    for (std::uint32_t k = 0; k < n; ++k) {
      radii.push_back(number(random, 0.01, 0.5));
      search.set(k, plane.places[k][0], plane.places[k][1], radii[k]);
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t first = below(random, n);
      const std::uint32_t last = first + below(random, n - first + 1);
      std::set<std::uint32_t> seen;
      search.each_group(i, first, last, [&](std::uint32_t k, std::uint32_t mask) {
        for (; mask != 0; mask &= mask - 1) {
          seen.insert(k + static_cast<std::uint32_t>(std::countr_zero(mask)));
        }
      });
      std::vector<Slot> some;
      for (std::uint32_t k = first; k < last; ++k) {
        if (k != i) some.push_back(static_cast<Slot>(k));
      }
      std::shuffle(some.begin(), some.end(), random);
      const auto count = static_cast<std::uint32_t>(some.size());
      some.resize(some.size() + NearSearch::kAtATime);
      std::set<std::uint32_t> seen_one_by_one;
      search.each_of(i, some.data(), count, [&](const Slot* slots, std::uint32_t mask) {
        for (; mask != 0; mask &= mask - 1) seen_one_by_one.insert(slots[std::countr_zero(mask)]);
      });
      ASSERT_EQ(seen_one_by_one, seen) << seed;
      for (std::uint32_t k = 0; k < n; ++k) {
        const double gap = plane.distance(i, k) - reach - radii[i] - radii[k];
        const bool asked = k >= first && k < last && k != i;
        ASSERT_TRUE(!(gap < 0 && asked) || seen.count(k) > 0) << seed;
        ASSERT_TRUE((gap < 1e-3 && asked) || seen.count(k) == 0) << seed;
      }
    }
  }
}

// The exact time is that of pair_time(); the bound must be before it, little, and never miss it.
TEST(Approach, BoundsThePairTimeFromBelow) {
  std::mt19937 random(7);
  std::uint64_t meetings = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const bool mixed = trial % 2 == 0;
    const double period = trial % 3 == 0 ? 20 : 0;
    constexpr double kSlack = 1e-9;
    std::vector<Path> paths;
    std::vector<double> radii;
    for (int k = 0; k < 5; ++k) {
      const double v = trial % 5 == 0 ? 100 : 1;
      paths.push_back({number(random, -9, 9), number(random, -9, 9), number(random, -v, v),
                       number(random, -v, v)});
      radii.push_back(mixed ? number(random, 0.1, 2) : 1);
    }
    const Approach approach({period, 0}, 1, mixed ? radii.data() : nullptr, kSlack,
                            number(random, 0.1, 10));
    const std::array<Slot, 4> others{1, 2, 3, 4};
    const double now = number(random, 0, 1);
    const Lanes bounds =
        approach.bounds(approach.seer(paths[0], 0), paths.data(), others.data(), all(now));
    for (std::uint32_t l = 0; l < kLanes; ++l) {
      const Path& a = paths[0];
      const Path& b = paths[others[l]];
      Vec<double> r{b.x - a.x, b.y - a.y};
      if (period > 0) r.x -= period * std::rint((r.x + now * (b.vx - a.vx)) / period);
      const Vec<double> v{b.vx - a.vx, b.vy - a.vy};
      const double s = radii[0] + radii[others[l]];
      const double t = pair_time(Vec<double>{r.x + now * v.x, r.y + now * v.y}, v, s);
      if (t == never<double>()) continue;
      ++meetings;
      ASSERT_LE(bounds[l], now + t) << trial;
      // Overlapping ones have met before.
      if (t > 0) {
        const double speed = std::hypot(v.x, v.y);
        const double deep = -(r.x * v.x + r.y * v.y) / speed - speed * (now + t);
        // Of those that graze, the slack shows more.
        ASSERT_GE(bounds[l], now + t - 4 * kSlack * s / std::max(deep, 1e-3) / speed) << trial;
      }
    }
  }
  EXPECT_GT(meetings, 5000U);
}

TEST(Approach, FindsTheTwoEarliestOfMany) {
  std::mt19937 random(11);
  unsigned found = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    constexpr std::size_t kBalls = 24;
    std::vector<Path> paths;
    for (std::size_t k = 0; k < kBalls; ++k) {
      paths.push_back({number(random, -9, 9), number(random, -9, 9), number(random, -1, 1),
                       number(random, -1, 1)});
    }
    const Approach approach({0, 0}, 1, nullptr, 1e-9, 1);
    std::array<Slot, kBalls> others{};
    for (Slot& other : others) other = static_cast<Slot>(below(random, kBalls));
    const std::uint32_t count = below(random, 20);
    const Approach::Seer me = approach.seer(paths[0], 0);
    const auto earliest = approach.earliest(me, paths.data(), others.data(), count, Lanes{});
    std::vector<double> times(2, never<double>());
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::array<Slot, 4> same{others[k], others[k], others[k], others[k]};
      times.push_back(approach.bounds(me, paths.data(), same.data(), Lanes{})[0]);
      if (times.back() != earliest.first) continue;
      found += times.back() < never<double>() ? 1 : 0;
    }
    std::sort(times.begin(), times.end());
    ASSERT_EQ(earliest.first, times[0]) << trial;
    ASSERT_EQ(earliest.second, times[1]) << trial;
    if (times[0] == never<double>()) continue;
    const std::array<Slot, 4> same{earliest.ball, earliest.ball, earliest.ball, earliest.ball};
    ASSERT_EQ(approach.bounds(me, paths.data(), same.data(), Lanes{})[0], times[0]) << trial;
  }
  EXPECT_GT(found, 1000U);
}

}  // namespace
}  // namespace carom::event::domain_parts_test
