#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/rest_rules.hpp"
#include "solvers/event/motion.hpp"
#include "trajectory/fixed_disk_time.hpp"
#include "trajectory/pair_time.hpp"

namespace carom::event {

template <class P>
void Motion<P>::add_supported_species() {
  S largest = 0;
  for (const Species& species : rules_.all_species) {
    if (species.inverse_mass > 0) largest = std::max(largest, species.radius);
  }
  for (unsigned axes = 1; axes <= kJoins; ++axes) {
    for (std::size_t k = 0; k < plain_species_; ++k) {
      Species species = rules_.all_species[k];
      species.support = axes;
      rules_.all_species.push_back(species);
    }
  }
  add_supported_laws();
  if (!(pull_ > 0)) return;
  const S fall = root(S(2 * largest / pull_));
  const bool loses = rules_.restitution < 1 || rules_.wall_restitution < 1;
  const int shorter = loses ? shorter_steps(rules_.movers) : 0;
  const Time span = rules_.scale.ticks(S(std::ldexp(kStep, shorter) * fall));
  step_shift_ = P::Clock::shift_of(std::min(span, P::Clock::epoch()));
  speed_of_step_ = pull_ * rules_.scale.seconds(P::Clock::span(1, step_shift_));
}

template <class P>
bool Motion<P>::stays_down(const S& v, const S& a, const S& restitution, const S& reach) const {
  if (restitution < 1) return bounces_out(v, a, restitution, rules_.scale.resolution());
  return barely_bounces(v, a, reach, elastic_ ? kAtOnce : kShortly);
}

template <class P>
double Motion<P>::support_on_walls(Disk& disk, S* spin) const {
  const Vec<S>& g = law_.pull();
  unsigned axes = 0;
  double lost = 0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const S& a = axis == 0 ? g.x : g.y;
    if (a == 0 || !box_.solid(axis)) continue;
    const S& radius = species(disk).radius;
    const S stop = a < 0 ? box_.lowest(axis, radius) : box_.highest(axis, radius);
    const S& x = axis == 0 ? disk.x : disk.y;
    S& v = axis == 0 ? disk.vx : disk.vy;
    const S away = a < 0 ? v : S(-v);
    if (x != stop || away < 0) continue;
    const S along = absolute(axis == 0 ? disk.vy : disk.vx);
    const bool rounding = !(away > kRounding * std::numeric_limits<S>::epsilon() * along);
    if (!rounding && !stays_down(away, absolute(a), S(rules_.wall_restitution), S(2 * radius))) {
      continue;
    }
    lost += moving_energy(disk, v);
    v = 0;
    axes |= axis == 0 ? 1U : 2U;
  }
  set_support(disk, axes);
  if (spin == nullptr || !(rules_.wall_friction > 0) || axes == 0) return lost;
  if (axes == kLying) {
    if (*spin == 0) return lost;
    // Where it climbs the one, the other carries it no more.
    const Vec<S> load = corner(disk, *spin).load;
    axes = !(load.y > 0) ? 1U : 2U;
    if (load.x > 0 && load.y > 0) axes = kSpins;
    set_support(disk, axes);
    if (axes == kSpins) return lost;
  }
  grip(disk, *spin);
  return lost + support_in_corner(disk, *spin);
}

// What slides turns, and may drive itself into another wall: friction at both slows it until it
// turns no more.
template <class P>
double Motion<P>::support_in_corner(Disk& disk, const S& spin) const {
  if (!slides(disk) || spin == 0) return 0;
  const std::size_t axis = track(axes_of(support(disk))).along;
  if (!box_.solid(axis)) return 0;
  const S& radius = species(disk).radius;
  const S& x = axis == 0 ? disk.x : disk.y;
  S& v = axis == 0 ? disk.vx : disk.vy;
  const S push = law_of(disk).push(axis, v);
  const S stop = push < 0 ? box_.lowest(axis, radius) : box_.highest(axis, radius);
  const S away = push < 0 ? v : S(-v);
  if (push == 0 || x != stop || away < 0) return 0;
  if (!stays_down(away, absolute(push), S(rules_.wall_restitution), S(2 * radius))) return 0;
  const Vec<S> load = corner(disk, spin).load;
  if (!(load.x > 0 && load.y > 0)) return 0;
  const double lost = moving_energy(disk, v);
  v = 0;
  set_support(disk, kSpins);
  return lost;
}

template <class P>
double Motion<P>::support_on_fixed_disk(Disk& disk, const Disk& fixed_disk) const {
  const Vec<S> r = way({fixed_disk.x, fixed_disk.y}, {disk.x, disk.y});
  const Vec<S> v{disk.vx, disk.vy};
  const Vec<S>& g = law_.pull();
  if (!straight_up(r, v, g)) return 0;
  const S away = root(S(v.x * v.x + v.y * v.y));
  const S reach = species(disk).radius + species(fixed_disk).radius;
  if (away > 0 && !stays_down(away, pull_, S(rules_.restitution), reach)) return 0;
  disk.vx = 0;
  disk.vy = 0;
  set_support(disk, kLying);
  return moving_energy(disk, away);
}

template <class P>
bool Motion<P>::stays_together(const Vec<S>& r, const Vec<S>& v, const S& reach) const {
  const S distance = root(S(r.x * r.x + r.y * r.y));
  return absolute(sharp_dot(r, v)) / distance * rules_.scale.resolution() <=
         reach * std::ldexp(1.0, kTogether - P::Clock::bits());
}

template <class P>
bool Motion<P>::collapses(const Disk& a, const Disk& b, At now) const {
  if (!(rules_.restitution < 1)) return false;
  const S since = rules_.scale.seconds(now - std::min(a.start, b.start));
  if (since <= rules_.scale.resolution() * kCollapse) return true;
  const Vec<S> v = velocity(b, now) - velocity(a, now);
  const S most = S(kCollapsed) * (species(a).radius + species(b).radius);
  return !(dot(v, v) * (since * since) > most * most);
}

template <class P>
bool Motion<P>::just_fits(const Disk& ball, const Vec<S>& r) const {
  const S noise = kRounding * std::numeric_limits<S>::epsilon();
  const unsigned axes = axes_of(support(ball));
  if (axes == 1) return !(absolute(r.y) > noise * absolute(r.x));
  return axes == 2 && !(absolute(r.x) > noise * absolute(r.y));
}

template <class P>
bool Motion<P>::stepped_together(const Disk& a, const Disk& b) const {
  const bool of_islands = (stepped(a) || fixed(a)) && (stepped(b) || fixed(b));
  if (!of_islands) return false;
  // What rests may have done so for long.
  const auto stays = [this](const Disk& disk) { return fixed(disk) || support(disk) == kResting; };
  if (a.start != b.start && !stays(a) && !stays(b)) return false;
  const Vec<S> r = way({a.x, a.y}, {b.x, b.y});
  const S reach = species(a).radius + species(b).radius;
  if (!near(r, reach, S(kNear))) return false;
  if (!elastic_impacts_) return true;
  const Vec<S> v{b.vx - a.vx, b.vy - a.vy};
  const S distance = root(S(r.x * r.x + r.y * r.y));
  const S closing = -sharp_dot(r, v);
  if (closing > distance * lasting_speed(S(cross(r, v) / distance), reach)) return false;
  // A hit between steps may leave what a step would have held: not all of it was one that lasts.
  const Time start = std::max(a.start, b.start);
  const Time end = P::Clock::span(P::Clock::steps(start, step_shift_) + 1, step_shift_);
  const S most = larger(S(squared_gap(r, reach) / (distance + reach)), S(0)) + left_open();
  return closing * rules_.scale.seconds(end - start) <= distance * most;
}

template <class P>
auto Motion<P>::left_open() const -> S {
  return S(kLeftOpen * largest_radius_);
}

template <class P>
bool Motion<P>::just_hit(const Disk& disk, const S& reach, const S& speed, At now,
                         const S& part) const {
  if (fixed(disk)) return true;
  const S age = rules_.scale.seconds(now - disk.start);
  return age * age * pull_ <= part * part * reach && speed * age <= part * reach;
}

template <class P>
bool Motion<P>::has_support(const Disk& disk) const {
  return !fixed(disk) && support(disk) != 0;
}

template <class P>
bool Motion<P>::is_at_wall(const Disk& disk, At now) const {
  if (fixed(disk)) return false;
  const Vec<S> at = wrapped(place(disk, now));
  for (Index wall = kWalls; wall < kWalls + 4; ++wall) {
    if (!box_.solid((wall - kWalls) / 2)) continue;
    if (!(this->wall(disk, at, wall).gap > 2 * species(disk).radius * kBriefly)) return true;
  }
  return false;
}

template <class P>
bool Motion<P>::jammed(const Disk& a, const Disk& b, At now) const {
  if (elastic_) return false;
  // A step is no hit; where contacts lose energy, what hits one of an island bounces until it is
  // slow.
  if (rules_.restitution < 1 && (stepped(a) || stepped(b))) return false;
  const bool loses = rules_.restitution < 1 || has_support(a) || has_support(b);
  const bool on_fixed = fixed(a) || fixed(b);
  const S reach = species(a).radius + species(b).radius;
  const auto both = [&](double part, const S& speed) {
    return just_hit(a, reach, speed, now, S(part)) && just_hit(b, reach, speed, now, S(part));
  };
  const S still = 0;  // most have not been hit of late, whatever their speed
  if (!both(kShortly, still)) return false;
  const Vec<S> v = velocity(b, now) - velocity(a, now);
  const S speed = -sharp_dot(way(place(a, now), place(b, now)), v) / reach;
  if (loses) return both(kShortly, speed);
  // Elastic ones that touch pass an impact on at once.
  if (a.start == now || b.start == now) return false;
  const bool takes = rules_.drag_rate > 0 || rules_.has_friction();
  if (on_fixed && takes && speed * speed <= S(kShortly * kShortly) * reach * pull_) {
    return both(kShortly, speed);
  }
  if (!both(kBriefly, speed)) return false;
  return (takes || rules_.wall_restitution < 1) && (is_at_wall(a, now) || is_at_wall(b, now));
}

template <class P>
bool Motion<P>::sticks(const Disk& a, const Disk& b, const Vec<S>& r, At now) const {
  const Vec<S> v = velocity(b, now) - velocity(a, now);
  const S distance = root(S(r.x * r.x + r.y * r.y));
  const S speed = -sharp_dot(r, v) / distance;
  // What comes straight down on a fixed ball is a ball on a floor.
  if (fixed(b) && !in_island(a) && straight_up(-r, v, law_.pull())) return false;
  if (fixed(a) && !in_island(b) && straight_up(r, v, law_.pull())) return false;
  const auto pull_on = [this](const Disk& disk) {
    return fixed(disk) ? Vec<S>{S(0), S(0)} : law_of(disk).pull();
  };
  const S pressing = -sharp_dot(r, pull_on(b) - pull_on(a)) / distance;
  if (barely_bounces(speed, pressing, S(species(a).radius + species(b).radius), kAtOnce))
    return true;
  if (elastic_) return false;
  if (jammed(a, b, now)) return true;
  if (rules_.restitution == 1 && !has_support(a) && !has_support(b)) return false;
  const auto supported = [this](const Disk& disk) { return fixed(disk) || support(disk) != 0; };
  if ((in_island(a) && supported(b)) || (supported(a) && in_island(b)))
    return speed <= speed_of_step_;
  return pressing > 0 && speed * pull_ <= pressing * speed_of_step_;
}

template <class P>
bool Motion<P>::sticks_to_wall(const Disk& disk, const S& speed, At now) const {
  if (elastic_) return barely_bounces(speed, pull_, S(2 * species(disk).radius), kAtOnce);
  if (speed <= speed_of_step_) return true;
  if (rules_.wall_restitution < 1 && stepped(disk)) return false;  // a step is no hit
  return just_hit(disk, S(2 * species(disk).radius), speed, now, S(kShortly));
}

// One of the two may be supported: then they accelerate as seen from each other.
template <class P>
auto Motion<P>::meeting_wait(const Disk& earlier, const Disk& later, const S& reach,
                             bool from_contact, At until) const -> S {
  const auto& law = law_of(earlier);
  const S elapsed = rules_.scale.seconds(later.start - earlier.start);
  Relative<S> relative = relative_at_later_start(law, flight(earlier), elapsed, flight(later));
  const std::array<S, 2>& periods = box_.periods();
  relative.r.x = nearest(relative.r.x, periods[0], S(periods[0] / 2));
  relative.r.y = nearest(relative.r.y, periods[1], S(periods[1] / 2));
  const Vec<S> pull = law_of(later).pull() - law.pull();
  if (until != P::Clock::never()) {
    // Too far to meet before: most pairs, and this is quick.
    const S wait = rules_.scale.seconds(until - later.start);
    const S speed = absolute(relative.v.x) + absolute(relative.v.y);
    const S far = (reach + (speed + pull_ * wait / 2) * wait) * 1.0625;
    if (relative.r.x * relative.r.x + relative.r.y * relative.r.y > far * far) return never<S>();
  }
  if (law.fading() != law_of(later).fading()) {
    return unlike_wait(earlier, later, relative, reach, until);
  }
  if (pull.x == 0 && pull.y == 0) return law.when(pair_time(relative.r, relative.v, reach));
  return law.under(pull).fixed_disk_wait(relative.r, relative.v, reach, from_contact);
}

template <class P>
auto Motion<P>::stepped_flight(At start, At next) const -> SteppedFlight {
  return {static_cast<double>(rules_.scale.seconds(next - start)), rules_.drag_rate};
}

// What rests has had a step's flight before each step.
template <class P>
auto Motion<P>::gravity_of(const Disk& disk, At now, At next) const -> GravityOfFlight {
  if (support(disk) == kResting && now == next) {
    const SteppedFlight flight = whole_flight();
    return {flight.owed(flight.seconds), 0};
  }
  if (support(disk) != kStepped) return {};
  const SteppedFlight flight = stepped_flight(disk.start, next);
  const auto elapsed = static_cast<double>(rules_.scale.seconds(now - disk.start));
  return {flight.owed(elapsed), flight.ahead(elapsed)};
}

template <class P>
double Motion<P>::given_ahead(const Disk& disk, At now, At next) const {
  const S span = gravity_of(disk, now, next).ahead;
  const Vec<S>& g = law_.pull();
  const Vec<S> v = velocity(disk, now);
  return static_cast<double>(S(span * (g.x * v.x + g.y * v.y) / species(disk).inverse_mass));
}

template <class P>
auto Motion<P>::lasting_speed(const S& slip, const S& reach) const -> S {
  const S turn = std::min(S(absolute(slip) * seconds_of_step() / reach), S(kTurnOfStep));
  return 2 * (speed_of_step_ + turn * turn * reach / seconds_of_step());
}

}  // namespace carom::event
