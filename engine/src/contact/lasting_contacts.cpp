#include "contact/lasting_contacts.hpp"

#include <algorithm>
#include <utility>

#include "contact/ball_gap.hpp"
#include "contact/island_account.hpp"

namespace carom::contact {

void LastingContacts::wake_all(const Balls& balls) {
  start_.make_room(balls.size(), turns_);
  sleepers_.wake_all(balls);
  islands_.reset(balls.size());
}

// Held or not, as if they had just stopped.
void LastingContacts::find_asleep(const Balls& balls, std::span<const Pair> near) {
  wake_all(balls);
  begin(balls, 0, balls.size());
  islands_.find_still(balls, near);
  IslandStep step;
  const bool spins = balls.spin.size() > 0;
  for (LastingIsland& island : islands_) {
    if (!step.holds(island.bodies, island.contacts, spins, rule_.in(island.frame))) continue;
    sleepers_.fall_asleep(island.members);
  }
  islands_.clear();
}

void LastingContacts::begin(const Balls& balls, std::size_t begin, std::size_t end) {
  start_.note(balls, turns_, begin, end);
  sleepers_.begin(begin, end);
}

void LastingContacts::end(Balls& balls, std::size_t begin, std::size_t end,
                          std::vector<std::uint32_t>& out) const {
  for (std::size_t i = begin; i < end; ++i) {
    if (asleep(i)) {
      sleepers_.put_back(balls, i);
    } else if (!balls.fixed(i) && beyond_wall(balls, i)) {
      out.push_back(static_cast<std::uint32_t>(i));
    }
  }
}

bool LastingContacts::beyond_wall(const Balls& balls, std::size_t ball) const {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!domain_.solid(axis)) continue;
    const double x = balls.position[axis][ball];
    const double radius = balls.radius[ball];
    if (x < domain_.lowest(axis, radius) || x > domain_.highest(axis, radius)) return true;
  }
  return false;
}

void LastingContacts::form(Balls& balls, std::span<const Pair> near,
                           std::span<const std::uint32_t> out) {
  islands_.clear();
  if (near.empty() && out.empty()) return;
  sleepers_.wake_struck(balls, near);
  islands_.find(balls, near, out);
}

void LastingContacts::resolve(std::size_t number, Balls& balls, bool may_sleep, IslandStep& step,
                              const ImpactLog& log) {
  LastingIsland& island = islands_[number];
  if (std::exchange(island.resolved, true)) return;
  step_.take(island, balls, may_sleep, islands_.driven(), step, log);
}

double LastingContacts::farthest_push() const {
  double farthest = 0;
  for (const LastingIsland& island : islands_) farthest = std::max(farthest, island.push);
  return farthest;
}

void LastingContacts::find_crossing(const Balls& balls, std::span<const Pair> near,
                                    std::vector<Pair>& crossing) const {
  for (const Pair& pair : near) {
    if (islands_.together(pair)) continue;
    if (!sleepers_.moves(balls, pair.first) || !sleepers_.moves(balls, pair.second)) continue;
    if (overlap(balls, pair, domain_)) crossing.push_back(pair);
  }
}

bool LastingContacts::any_driven() const {
  return std::any_of(islands_.begin(), islands_.end(),
                     [](const LastingIsland& island) { return island.driven; });
}

void LastingContacts::join(Balls& balls, std::span<const Pair> near, std::span<const Pair> crossing,
                           bool all) {
  for (const LastingIsland& island : islands_.take_out(balls, crossing, all)) {
    step_.undo(island, balls);
  }
  islands_.find_again(balls, near, crossing);
}

void LastingContacts::settle(std::span<double> lost, Count& count, ImpactLog& log) {
  sleepers_.end_step();
  for (const LastingIsland& island : islands_) {
    count.ball_ball += island.ball_ball;
    count.ball_wall += island.ball_wall;
    count.jammed += island.jammed;
    count.deepest = std::max(count.deepest, island.deepest);
    log.impacts.insert(log.impacts.end(), island.impacts.begin(), island.impacts.end());
    for (const auto& member : island.members) islands_.driven()[member.ball] = 0;
    if (!lost.empty()) lost[island.members.front().ball] += island.lost;
    if (island.sleeps) {
      sleepers_.fall_asleep(island.members);
    } else if (log.wanted) {
      note_woken(island, log);
    }
  }
}

}  // namespace carom::contact
