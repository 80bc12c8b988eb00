#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/rest_rules.hpp"
#include "solvers/event/lanes.hpp"
#include "solvers/event/motion.hpp"
#include "trajectory/exit_bound.hpp"
#include "trajectory/pair_time.hpp"

namespace carom::event {

template <class S>
Flight<S> flight(const BallFlight<S>& disk) {
  return {{disk.x, disk.y}, {disk.vx, disk.vy}};
}

template <class P>
Motion<P>::Motion(Rules rules)
    : rules_(std::move(rules)),
      law_(P::law(rules_)),
      box_(rules_.domain),
      bends_(law_.bends() || rules_.falls),
      rests_(rules_.rests) {
  S largest = 0;
  for (const Species& species : rules_.all_species) largest = std::max(largest, species.radius);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const S period = rules_.domain.period[axis];
    // Two balls whose nearest images do not meet while each goes this far meet in no other image.
    reach_[axis] = std::min(S(period / 8), S((period / 2 - 2 * largest) * 0.4375));
    const bool solid = box_.solid(axis);
    low_side_[axis] = solid ? rules_.domain.lower[axis] : -never<double>();
    high_side_[axis] = solid ? rules_.domain.upper[axis] : never<double>();
    farthest_[axis] = box_.periodic(axis) ? static_cast<double>(reach_[axis]) : never<double>();
  }
  largest_radius_ = static_cast<double>(largest);
  plain_species_ = rules_.all_species.size();
  if (!rests_) return;
  const Vec<S>& g = law_.pull();
  pull_ = root(S(g.x * g.x + g.y * g.y));
  elastic_ = !can_rest(rules_);
  elastic_impacts_ = !(rules_.restitution < 1) && !(rules_.wall_restitution < 1);
  add_supported_species();
}

template <class P>
auto Motion<P>::place(const Disk& disk, At now) const -> Vec<S> {
  if (bends_ && fixed(disk)) return {disk.x, disk.y};
  const S elapsed = rules_.scale.seconds(now - disk.start);
  return Vec<S>{disk.x, disk.y} +
         ask(disk, [&](const auto& law) { return law.displacement(flight(disk), elapsed); });
}

template <class P>
auto Motion<P>::velocity(const Disk& disk, At now) const -> Vec<S> {
  if (!bends_ || fixed(disk)) return {disk.vx, disk.vy};
  return law_of(disk).velocity(flight(disk), rules_.scale.seconds(now - disk.start));
}

template <class P>
[[gnu::always_inline]] inline auto Motion<P>::at(const Disk& disk, At now) const -> Flight<S> {
  if (now == disk.start || fixed(disk)) return flight(disk);
  const S elapsed = rules_.scale.seconds(now - disk.start);
  return ask(disk, [&](const auto& law) { return after(law, flight(disk), elapsed); });
}

template <class P>
auto Motion<P>::way(const Vec<S>& a, const Vec<S>& b) const -> Vec<S> {
  const std::array<S, 2>& periods = box_.periods();
  return {nearest(S(b.x - a.x), periods[0], S(periods[0] / 2)),
          nearest(S(b.y - a.y), periods[1], S(periods[1] / 2))};
}

template <class P>
auto Motion<P>::wrapped(const Vec<S>& at) const -> Vec<S> {
  return box_.wrapped(at);
}

template <class P>
auto Motion<P>::pair_event(const Disk& a, const Disk& b, bool from_contact,
                           [[maybe_unused]] At until) const -> Time {
  const S reach = species(a).radius + species(b).radius;
  if (contacts_last() && stepped_together(a, b)) return P::Clock::never();
  if (bends_ && (fixed(a) || fixed(b))) {
    const Disk& ball = fixed(a) ? b : a;
    const Disk& fixed_disk = fixed(a) ? a : b;
    const Vec<S> r = way({fixed_disk.x, fixed_disk.y}, {ball.x, ball.y});
    if (from_contact && just_fits(ball, r)) return P::Clock::never();
    const S wait = law_of(ball).fixed_disk_wait(r, Vec<S>{ball.vx, ball.vy}, reach, from_contact);
    const Time ticks = rules_.scale.ticks(wait);
    return ticks == P::Clock::never() ? ticks : Time(ball.start + ticks);
  }
  const bool swap = b.start < a.start;
  const Disk& earlier = swap ? b : a;
  const Disk& later = swap ? a : b;
  if (contacts_last()) {
    const Time ticks = rules_.scale.ticks(meeting_wait(earlier, later, reach, from_contact, until));
    return ticks == P::Clock::never() ? ticks : Time(later.start + ticks);
  }
  const S elapsed = rules_.scale.seconds(later.start - earlier.start);
  Relative<S> relative = ask(later, [&](const auto& law) {
    return relative_at_later_start(law, flight(earlier), elapsed, flight(later));
  });
  const std::array<S, 2>& periods = box_.periods();
  relative.r.x = nearest(relative.r.x, periods[0], S(periods[0] / 2));
  relative.r.y = nearest(relative.r.y, periods[1], S(periods[1] / 2));
  const S wait = law_.when(pair_time(relative.r, relative.v, reach));
  const Time ticks = rules_.scale.ticks(wait);
  return ticks == P::Clock::never() ? ticks : Time(later.start + ticks);
}

template <class P>
auto Motion<P>::wall(const Disk& disk, const Vec<S>& at, Index wall) const -> Wall {
  const std::size_t axis = (wall - kWalls) / 2;
  const S& x = axis == 0 ? at.x : at.y;
  const S& radius = species(disk).radius;
  if ((wall - kWalls) % 2 == 0) {
    const S stop = box_.lowest(axis, radius);
    return {x - stop, stop};
  }
  const S stop = box_.highest(axis, radius);
  return {stop - x, stop};
}

template <class P>
auto Motion<P>::wall_event(const Disk& disk, Index wall) const -> Time {
  const std::size_t axis = (wall - kWalls) / 2;
  const int side = (wall - kWalls) % 2 == 0 ? 1 : -1;
  const S gap = this->wall(disk, {disk.x, disk.y}, wall).gap;
  const S& v = axis == 0 ? disk.vx : disk.vy;
  const Time wait = rules_.scale.ticks(law_of(disk).wall_wait(axis, side, gap, S(side * v)));
  return wait == P::Clock::never() ? wait : Time(disk.start + wait);
}

template <class P>
Meeting<P> Motion<P>::wall_meeting(const Disk& disk, std::size_t axis, bool low, bool high) const {
  const S& x = axis == 0 ? disk.x : disk.y;
  const S& v = axis == 0 ? disk.vx : disk.vy;
  const S& radius = species(disk).radius;
  const auto& law = law_of(disk);
  S wait_low = never<S>();
  S wait_high = never<S>();
  if (low) wait_low = law.wall_wait(axis, 1, S(x - box_.lowest(axis, radius)), v);
  if (high) wait_high = law.wall_wait(axis, -1, S(box_.highest(axis, radius) - x), S(-v));
  const Time wait = rules_.scale.ticks(std::min(wait_low, wait_high));
  if (wait == P::Clock::never()) return {};
  const auto side = static_cast<Index>(2 * axis) + (wait_high < wait_low ? 1U : 0U);
  if (contacts_last()) {
    // The step of its island has seen to it.
    const Index wall = kWalls + side;
    const double part = elastic_impacts_ ? kTouching : kNear;
    const S speed = absolute(v);
    if (stepped(disk) && !(this->wall(disk, {disk.x, disk.y}, wall).gap > 2 * radius * part) &&
        !(elastic_impacts_ && speed > lasting_speed(S(0), S(1)))) {
      return {};
    }
  }
  return {disk.start + wait, kWalls + side};
}

// Within time t a ball goes no farther than v t + a t^2 / 2, whatever drag makes of the two.
template <class P>
[[gnu::always_inline]] inline bool Motion<P>::stays_clear(const Disk& disk,
                                                          double wait) const requires kIsDouble<S> {
  const auto& law = law_of(disk);
  const double radius = species(disk).radius;
  const TwoLanes at{disk.x, disk.y};
  const TwoLanes v{disk.vx, disk.vy};
  TwoLanes most = with_signs(v, signs(v));
  if (bends_) {
    const TwoLanes pull{law.pull(0), law.pull(1)};
    most += with_signs(pull, signs(pull)) * (wait / 2);
  }
  const TwoLanes way = most * (wait * (1 + 0x1p-20));
  const WholeTwoLanes clear =
      (way < at - (low_side_ + radius)) & (way < (high_side_ - radius) - at) & (way < farthest_);
  return (clear[0] & clear[1]) != 0;
}

// Most walls are too far to be met before `until`.
template <class P>
Meeting<P> Motion<P>::alone(const Disk& disk, At until, const S* spin) const {
  using std::sqrt;
  Meeting<P> first{disk.start + P::Clock::longest_flight(), kCarry};
  if (spin != nullptr && (slides(disk) || support(disk) == kSpins)) {
    const Time slide = rules_.scale.ticks(
        slides(disk) ? slide_wait(disk, *spin) : S(absolute(*spin) / corner(disk, *spin).slower));
    if (slide != P::Clock::never()) first = {disk.start + slide, kSettles};
  }
  S wait = never<S>();
  if (until != P::Clock::never()) {
    wait = rules_.scale.seconds(until - disk.start + 1);
    if constexpr (kIsDouble<S>) {
      if (stays_clear(disk, wait)) return first;
    }
  }
  const S half = wait / 2;
  const S& radius = species(disk).radius;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const S& x = axis == 0 ? disk.x : disk.y;
    const S& v = axis == 0 ? disk.vx : disk.vy;
    if (box_.solid(axis)) {
      const auto reaches = [&](const S& gap, const S& speed, const S& pull) {
        const S most = larger(speed, S(0)) + larger(pull, S(0)) * half;
        return !(most * wait * (1 + 0x1p-20) < gap);
      };
      const S pull = law_of(disk).pull(axis);
      const bool low = reaches(S(x - box_.lowest(axis, radius)), S(-v), S(-pull));
      const bool high = reaches(S(box_.highest(axis, radius) - x), v, pull);
      if (!low && !high) continue;
      const Meeting<P> wall = wall_meeting(disk, axis, low, high);
      if (wall.time < first.time) first = wall;
    } else if (box_.periodic(axis)) {
      const S speed = absolute(v);
      const S pull = absolute(law_of(disk).pull(axis));
      if ((speed + pull * half) * wait * (1 + 0x1p-20) < reach_[axis]) continue;
      const S longest =
          2 * reach_[axis] / (speed + sqrt(S(speed * speed + 2 * pull * reach_[axis])));
      const Time ticks = rules_.scale.ticks(longest);
      if (ticks != P::Clock::never() && disk.start + ticks < first.time) {
        first = {disk.start + ticks, kCarry};
      }
    }
  }
  return first;
}

template <class P>
void Motion<P>::carry(Disk& disk, At now, S* spin) const {
  if (spin != nullptr) *spin = spin_at(disk, *spin, now);
  const Flight<S> here = at(disk, now);
  const Vec<S> place = wrapped(here.position);
  disk.x = place.x;
  disk.y = place.y;
  disk.vx = here.velocity.x;
  disk.vy = here.velocity.y;
  disk.start = now;
}

}  // namespace carom::event
