#pragma once

#include <cmath>

#include "contact/dissipation.hpp"
#include "contact/rest_rules.hpp"
#include "numbers/monotone_root.hpp"
#include "solvers/event/motion.hpp"

namespace carom::event {

template <class P>
void Motion<P>::add_supported_laws() {
  for (unsigned code = 0; code <= kJoins; ++code) {
    if (code <= kLying || code >= kSpins) {
      supported_laws_.push_back(event::supported(law_, std::min(code, kLying)));
      continue;
    }
    const unsigned axes = axes_of(code);
    const auto law = event::supported(law_, axes);
    if (code >= kRolls) {
      supported_laws_.push_back(law.rolling());
      continue;
    }
    const Track wall = track(axes);
    Vec<S> pull = law.pull();
    S& along = wall.along == 0 ? pull.x : pull.y;
    along = code % 2 == 1 ? S(along - wall.grip) : S(along + wall.grip);
    supported_laws_.push_back(law.under(pull));
  }
}

template <class P>
auto Motion<P>::track(unsigned axes) const -> Track {
  const Vec<S>& g = law_.pull();
  if (axes == 1) return {1, g.x > 0 ? 1 : -1, S(S(rules_.wall_friction) * absolute(g.x))};
  return {0, g.y < 0 ? 1 : -1, S(S(rules_.wall_friction) * absolute(g.y))};
}

// A uniform disk rolls where friction can give it a third of what pulls it along the wall.
template <class P>
void Motion<P>::grip(Disk& disk, S& spin) const {
  const unsigned axes = support(disk);
  const Track wall = track(axes);
  const S& radius = species(disk).radius;
  const S& v = wall.along == 0 ? disk.vx : disk.vy;
  const S surface = wall.turns * radius * spin;
  const S slip = v + surface;
  const S pull = law_.push(wall.along, v);
  int sign = slip > 0 ? 1 : -1;
  const S noise = kRounding * std::numeric_limits<S>::epsilon() * (absolute(v) + absolute(surface));
  if (!(absolute(slip) > noise)) {
    settle(disk, spin);
    if (!(absolute(pull) > 3 * wall.grip)) {
      set_support(disk, kRolls + axes - 1);
      return;
    }
    sign = pull > 0 ? 1 : -1;
  }
  set_support(disk, kSlides + 2 * (axes - 1) + (sign > 0 ? 1U : 0U));
}

// A ball that turns and touches two walls has friction at both: with q = 1 where the one of x turns
// it away from the one of y, N_x = g_x + q mu N_y and N_y = g_y - q mu N_x.
template <class P>
auto Motion<P>::corner(const Disk& disk, const S& spin) const -> Corner {
  const Vec<S>& g = law_.pull();
  const S& radius = species(disk).radius;
  const int x_side = disk.x == box_.lowest(0, radius) ? -1 : 1;
  const int y_side = disk.y == box_.lowest(1, radius) ? -1 : 1;
  const int turns = x_side * y_side * (spin > 0 ? 1 : -1);
  const S mu = rules_.wall_friction;
  const S x = x_side * g.x;
  const S y = y_side * g.y;
  const S part = 1 + mu * mu;
  Vec<S> load{S((x + turns * mu * y) / part), S((y - turns * mu * x) / part)};
  // What fills the box touches both walls, and is pressed to one of them.
  if (box_.lowest(0, radius) == box_.highest(0, radius)) load.x = absolute(load.x);
  if (box_.lowest(1, radius) == box_.highest(1, radius)) load.y = absolute(load.y);
  return {load, S(2 * mu * (load.x + load.y) / radius)};
}

template <class P>
void Motion<P>::settle(const Disk& disk, S& spin) const {
  if (support(disk) == kSpins) {
    spin = 0;
    return;
  }
  const Track wall = track(axes_of(support(disk)));
  spin = 0 - wall.turns * (wall.along == 0 ? disk.vx : disk.vy) / species(disk).radius;
}

template <class P>
void Motion<P>::put_at_end(Disk& disk) const {
  if (!slides(disk)) return;
  const std::size_t axis = track(axes_of(support(disk))).along;
  if (!box_.solid(axis)) return;
  S& x = axis == 0 ? disk.x : disk.y;
  const S& radius = species(disk).radius;
  for (const S& stop : {box_.lowest(axis, radius), box_.highest(axis, radius)}) {
    if (!(absolute(S(x - stop)) > 2 * std::numeric_limits<S>::epsilon() * absolute(stop))) x = stop;
  }
}

template <class P>
auto Motion<P>::spin_at(const Disk& disk, const S& spin, At now) const -> S {
  const unsigned code = support(disk);
  if (code < kSlides || code >= kResting || now == disk.start) return spin;
  if (code == kSpins) {
    const S left =
        absolute(spin) - corner(disk, spin).slower * rules_.scale.seconds(now - disk.start);
    return left > 0 ? S(spin > 0 ? left : S(-left)) : S(0);
  }
  const Track wall = track(axes_of(code));
  if (code >= kRolls) {
    const Vec<S> v = velocity(disk, now);
    return 0 - wall.turns * (wall.along == 0 ? v.x : v.y) / species(disk).radius;
  }
  const S elapsed = rules_.scale.seconds(now - disk.start);
  return spin - 2 * slide_sign(disk) * wall.turns * wall.grip * elapsed / species(disk).radius;
}

// The slip along its sign; it rises at most once and falls then for good.
template <class P>
auto Motion<P>::slide_wait(const Disk& disk, const S& spin) const -> S {
  const Track wall = track(axes_of(support(disk)));
  const int sign = slide_sign(disk);
  const auto& law = law_of(disk);
  const S surface = wall.turns * species(disk).radius * spin;
  const S& start = wall.along == 0 ? disk.vx : disk.vy;
  const auto slip = [&](const S& t) {
    const Vec<S> v = law.velocity(flight(disk), t);
    const S& along = wall.along == 0 ? v.x : v.y;
    return Tangent<S>{sign * (along + surface) - 2 * wall.grip * t,
                      sign * law.push(wall.along, along) - 2 * wall.grip};
  };
  const S first = sign * (start + surface);
  const S slope = sign * law.push(wall.along, start) - 2 * wall.grip;
  const S rate = law.fading();
  if (rate == 0) return slope < 0 ? S(larger(first, S(0)) / -slope) : never<S>();
  S low = 0;
  if (slope > 0) {
    using std::log1p;
    low = log1p(S(slope / (2 * wall.grip))) / rate;
  } else if (!(first > 0)) {
    return S(0);
  }
  S high = larger(S(2 * low), S(larger(first, S(0)) / (2 * wall.grip)));
  for (int k = 0; !(slip(high).value < 0); ++k) {
    if (k == 2000) return never<S>();
    high = 2 * high;
  }
  return monotone_root(slip, low, high, false, S(4 * std::numeric_limits<S>::epsilon()), high);
}

template <class P>
auto Motion<P>::slides_of(const Disk& disk, const S* spin, At now) const -> std::vector<Slide> {
  if (spin == nullptr || fixed(disk) || now == disk.start) return {};
  const S elapsed = rules_.scale.seconds(now - disk.start);
  const S mass = 1 / species(disk).inverse_mass;
  const Vec<S>& g = law_.pull();
  const Index x_wall = kWalls + (g.x > 0 ? 1U : 0U);
  const Index y_wall = kWalls + 2 + (g.y > 0 ? 1U : 0U);
  if (support(disk) == kSpins) {
    const S was = species(disk).radius * *spin;
    const S is = species(disk).radius * spin_at(disk, *spin, now);
    // It stops turning within its flight, and has no friction from then on.
    const S longest = absolute(*spin) / corner(disk, *spin).slower;
    const S friction_body = longest < elapsed ? longest : elapsed;
    const Vec<S> load = corner(disk, *spin).load;
    const S lost = mass / 4 * ((was - is) * (was + is));
    const auto slide = [&](Index wall, const S& pressing) {
      const S impulse = mass * pressing * friction_body;
      const S tangential = S(rules_.wall_friction) * impulse;
      return Slide{wall, static_cast<double>(impulse),
                   static_cast<double>(S(*spin > 0 ? tangential : S(-tangential))),
                   static_cast<double>(S(lost * (pressing / (load.x + load.y))))};
    };
    return {
        slide(disk.x == box_.lowest(0, species(disk).radius) ? kWalls : kWalls + 1, load.x),
        slide(disk.y == box_.lowest(1, species(disk).radius) ? kWalls + 2 : kWalls + 3, load.y)};
  }
  if (!slides(disk)) return {};
  const Track wall = track(axes_of(support(disk)));
  const Vec<S> way = law_of(disk).displacement(flight(disk), elapsed);
  const S& along = wall.along == 0 ? way.x : way.y;
  const S surface = wall.turns * species(disk).radius * *spin;
  const int sign = slide_sign(disk);
  const S slipped = sign * (along + surface * elapsed) - wall.grip * elapsed * elapsed;
  const S normal = mass * absolute(wall.along == 0 ? g.y : g.x) * elapsed;
  return {{wall.along == 0 ? y_wall : x_wall, static_cast<double>(normal),
           static_cast<double>(S(sign * wall.turns * mass * wall.grip * elapsed)),
           static_cast<double>(S(mass * wall.grip * slipped))}};
}

template <class P>
double Motion<P>::flight_loss(const Disk& disk, const S* spin, At now) const {
  if (fixed(disk) || now == disk.start) return 0;
  const auto seconds = static_cast<double>(rules_.scale.seconds(now - disk.start));
  const auto& law = law_of(disk);
  double lost = 0;
  if (rules_.drag_rate > 0) {
    const double mass = 1 / static_cast<double>(species(disk).inverse_mass);
    const DragLoss loss(static_cast<double>(S(law.fading())), seconds);
    lost = loss.along(static_cast<double>(disk.vx), static_cast<double>(S(law.pull(0)))) +
           loss.along(static_cast<double>(disk.vy), static_cast<double>(S(law.pull(1))));
    const bool rolls = support(disk) >= kRolls && support(disk) < kSpins;
    lost *= rolls ? 1.5 * mass : mass;
  }
  for (const Slide& slide : slides_of(disk, spin, now)) lost += slide.lost;
  return lost;
}

// From below: within time t the gap shrinks by no more than its speed says, and the most that the
// two accelerate, which fades.
template <class P>
auto Motion<P>::unlike_wait(const Disk& one, const Disk& other, const Relative<S>& relative,
                            const S& reach, At until) const -> S {
  using std::exp;
  const auto& law = law_of(one);
  const auto& other_law = law_of(other);
  const Disk& later = one.start < other.start ? other : one;
  const S elapsed_one = rules_.scale.seconds(later.start - one.start);
  const S elapsed_other = rules_.scale.seconds(later.start - other.start);
  const Flight<S> from_one = after(law, flight(one), elapsed_one);
  const Flight<S> from_other = after(other_law, flight(other), elapsed_other);
  const auto size_of_push = [](const auto& by, const Vec<S>& v) {
    const S x = by.push(0, v.x);
    const S y = by.push(1, v.y);
    return root(S(x * x + y * y));
  };
  const S push =
      size_of_push(law, from_one.velocity) + size_of_push(other_law, from_other.velocity);
  const S fading = law.fading() < other_law.fading() ? S(law.fading()) : S(other_law.fading());
  S horizon = rules_.scale.seconds(P::Clock::longest_flight());
  if (until != P::Clock::never()) horizon = rules_.scale.seconds(until - later.start + 1);
  const S touching = 4 * std::numeric_limits<S>::epsilon() * reach;
  S t = 0;
  for (int k = 0; k < 4096 && t <= horizon; ++k) {
    const Vec<S> way = law.displacement(from_one, t);
    const Vec<S> other_way = other_law.displacement(from_other, t);
    const Vec<S> r = relative.r + (other_way - way);
    const Vec<S> v = other_law.velocity(from_other, t) - law.velocity(from_one, t);
    const S distance = root(S(r.x * r.x + r.y * r.y));
    const S gap = larger(S(squared_gap(r, reach) / (distance + reach)), S(0));
    const S opening = sharp_dot(r, v) / distance;
    if (!(gap > touching) && opening < 0) return t;
    const S most = push * exp(S(-fading * t));
    if (!(most > 0)) {
      if (!(opening < 0)) return never<S>();
      t = t + gap / -opening;
      continue;
    }
    // gap + opening t - most t^2 / 2 = 0
    const S square = root(S(opening * opening + 2 * most * gap));
    const S step = opening < 0 ? S(2 * gap / (square - opening)) : S((opening + square) / most);
    if (!(step > rules_.scale.resolution())) {
      if (!(gap > touching)) return opening > 0 ? S(t + rules_.scale.resolution()) : t;
      t = t + rules_.scale.resolution();
      continue;
    }
    t = t + step;
  }
  return t <= horizon ? t : never<S>();
}

}  // namespace carom::event
