#include "contact/sleepers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/ball_gap.hpp"

namespace carom::contact {

void Sleepers::wake_all(const Balls& balls) {
  asleep_.assign(balls.size(), 0);
  woken_.assign(balls.size(), 0);
  awake_ = 0;
  sleeping_ = 0;
  awoken_ = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) awake_ += balls.fixed(i) ? 0 : 1;
}

void Sleepers::begin(std::size_t begin, std::size_t end) {
  std::fill(woken_.begin() + static_cast<std::ptrdiff_t>(begin),
            woken_.begin() + static_cast<std::ptrdiff_t>(end), 0);
}

void Sleepers::put_back(Balls& balls, std::size_t ball) const {
  const Vec2 place = start_.place(ball);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    balls.position[axis][ball] = place[axis];
    balls.velocity[axis][ball] = 0;
    if (!turns_[axis].empty()) turns_[axis][ball] = start_.turns(axis, ball);
  }
}

void Sleepers::wake(Balls& balls, std::uint32_t ball) {
  asleep_[ball] = 0;
  woken_[ball] = 1;
  ++awake_;
  ++awoken_;
  --sleeping_;
  const Vec2 place = start_.place(ball);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double flown = place[axis] + rule_.fall[axis];
    const double period = domain_.period[axis];
    const double x = period > 0 ? domain_.wrapped(axis, flown) : flown;
    if (!turns_[axis].empty()) turns_[axis][ball] += std::llrint((flown - x) / period);
    balls.position[axis][ball] = x;
    balls.velocity[axis][ball] = rule_.gain[axis];
  }
}

void Sleepers::wake_struck(Balls& balls, std::span<const Pair> near) {
  for (bool more = sleeping_ > 0; std::exchange(more, false);) {
    for (const Pair& pair : near) {
      if (asleep_[pair.first] == asleep_[pair.second]) continue;
      const bool first = asleep(pair.first);
      const std::uint32_t sleeper = first ? pair.first : pair.second;
      const std::uint32_t other = first ? pair.second : pair.first;
      if (balls.fixed(other)) continue;
      if (!woken(other) && !overlap(balls, pair, domain_)) continue;
      wake(balls, sleeper);
      more = true;
    }
  }
}

void Sleepers::fall_asleep(const std::vector<LastingIsland::Member>& members) {
  for (const LastingIsland::Member& member : members) asleep_[member.ball] = 1;
  awake_ -= members.size();
  sleeping_ += members.size();
}

void Sleepers::list_woken(std::vector<std::uint32_t>& balls) const {
  if (awoken_ == 0) return;
  for (std::uint32_t i = 0; i < woken_.size(); ++i) {
    if (woken(i)) balls.push_back(i);
  }
}

}  // namespace carom::contact
