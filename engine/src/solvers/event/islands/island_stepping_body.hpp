#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "contact/cone_island.hpp"
#include "contact/rest_rules.hpp"
#include "numbers/exact_sum.hpp"
#include "solvers/event/islands/island_part.hpp"
#include "solvers/event/islands/island_rest.hpp"
#include "solvers/event/islands/island_stepping.hpp"
#include "solvers/event/islands/open_axes.hpp"
#include "solvers/event/islands/put_on_wall.hpp"

namespace carom::event {

// No more than this part of what moves is given by contacts that turn, in a step.
inline constexpr double kTurns = 0x1p-7;

template <class P>
auto IslandStepping<P>::scale() const -> Scale {
  const auto speed = static_cast<double>(motion_.speed_of_step());
  const bool elastic = motion_.elastic();
  return {in_double(motion_.law().pull()), motion_.whole_flight(), speed,
          (elastic ? kStill * kStill : kStill) * speed,
          (elastic ? kSolved * kSolved : kSolved) * speed};
}

// What hardly moves is known as much better, or what is left unsolved would hold it.
template <class P>
double IslandStepping<P>::goal_of(const Island& island, std::size_t moving,
                                  const Scale& scale) const {
  if (moving > kFewHeld || motion_.elastic()) return scale.goal;
  double fastest = kStill / 4 * scale.speed;
  for (const ConeBody& body : island.bodies) {
    fastest = std::max(
        {fastest, std::abs(body.velocity.x), std::abs(body.velocity.y), std::abs(body.turning)});
  }
  return scale.goal * std::min(fastest / scale.speed, 1.0);
}

template <class P>
auto IslandStepping<P>::press(Island& island, const std::vector<char>& stands,
                              const Scale& scale) const -> Pressed {
  const std::size_t contacts = island.contacts.size();
  Pressed pressed{std::vector<double>(contacts, 0), std::vector<char>(contacts, 0), {}};
  for (std::size_t k = 0; k < contacts; ++k) pressed.lasts[k] = impulses_.lasts(island, k) ? 1 : 0;
  IslandPart part(island, stands, pressed.lasts);
  for (std::size_t k = 0; k < part.bodies.size(); ++k) {
    const double given = island.gravity[part.body_number[k]].owed + scale.next.given();
    part.bodies[k].velocity = part.bodies[k].velocity + given * scale.pull;
  }
  // A part of many is in order as they are.
  ConeIsland cones(part.bodies, part.contacts,
                   part.bodies.size() < stands.size() ? kFewOfPart : island.few);
  const std::vector<double> pushes =
      cones.resolve(part.bodies, 1 / scale.next.way(), goal_of(island, part.bodies.size(), scale),
                    impulses_.opens());
  part.pass_on(island);
  for (std::size_t k = 0; k < pushes.size(); ++k) {
    pressed.loads[part.contact_number[k]] = pushes[k];
  }
  for (std::size_t k = 0; k < contacts; ++k) {
    pressed.presses.push_back(pressed.loads[k] > 0 || island.touches[k] != 0 ? 1 : 0);
  }
  return pressed;
}

// Of what gravity and the contacts have changed in this step the part that was owed.  Where nothing
// that never moves takes up what balls give each other, each keeps all of that.
template <class P>
std::vector<ConeBody> IslandStepping<P>::at_end(const Island& island,
                                                const std::vector<ConeBody>& before,
                                                const Scale& scale) const {
  std::vector<ConeBody> ends = before;
  const OpenAxes open = motion_.elastic_impacts() ? OpenAxes{false, false} : open_axes(island);
  for (std::size_t m = 0; m < ends.size(); ++m) {
    const double owed = island.gravity[m].owed;
    if (owed == 0) continue;
    const double part = owed / (owed + scale.next.given());
    const ConeBody& after = island.bodies[m];
    ends[m].velocity = ends[m].velocity + part * (after.velocity - ends[m].velocity);
    const Vec<double> whole = after.velocity - scale.next.given() * scale.pull;
    if (open.x) ends[m].velocity.x = whole.x;
    if (open.y) ends[m].velocity.y = whole.y;
    ends[m].turning += part * (after.turning - ends[m].turning);
  }
  return ends;
}

template <class P>
auto IslandStepping<P>::carrying(const Island& island, const std::vector<ConeBody>& before,
                                 const Pressed& pressed, const Scale& scale) const -> Carrying {
  const std::size_t n = island.members.size();
  Carrying result{std::vector<char>(island.contacts.size(), 0),
                  std::vector<int>(n, 0),
                  std::vector<char>(n, 0),
                  std::vector<char>(n, 0),
                  {}};
  result.sets.reset(n);
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (pressed.lasts[k] == 0) continue;
    const ConeContact& c = island.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    const auto b = c.b == kWall ? a : static_cast<std::size_t>(c.b);
    const double mobility =
        island.bodies[a].inverse_mass + (c.b == kWall ? 0 : island.bodies[b].inverse_mass);
    const Vec<double> other = c.b == kWall ? Vec<double>{0, 0} : before[b].velocity;
    if (dot(c.normal, other - before[a].velocity) < -scale.still) {
      result.approaches[a] = result.approaches[b] = 1;
    }
    if (!(pressed.loads[k] * mobility > kLoaded * scale.speed)) continue;
    result.carries[k] = 1;
    ++result.loaded[a];
    const bool wall = is_at_wall(island, k);
    if (!wall) result.on_balls[a] = 1;
    if (c.b == kWall) continue;
    ++result.loaded[b];
    result.on_balls[b] = 1;
    result.sets.merge(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
  }
  return result;
}

template <class P>
std::vector<char> IslandStepping<P>::moving(const Island& island,
                                            const std::vector<ConeBody>& before,
                                            const Pressed& pressed, Carrying& carrying,
                                            const std::vector<char>& stands,
                                            const std::vector<char>& pulled,
                                            const Scale& scale) const {
  const std::size_t n = island.members.size();
  const bool large = !motion_.elastic() && is_large(island);
  const auto find = [&](std::size_t k) {
    return carrying.sets.find(static_cast<std::uint32_t>(k));
  };
  std::vector<char> moves(n, 0);
  for (std::size_t m = 0; m < n; ++m) {
    if (stands[m] != 0) continue;
    // A ball that rests already is not woken by what has not been solved to the end.
    const bool rests = island.support[m] == kResting;
    const double most = rests && !large ? 4 * scale.still : scale.still;
    // Of many what turns round is slow for a moment.
    const bool slow = is_slow(island.bodies[m], most) && (!large || is_slow(before[m], most));
    if (!slow || carrying.loaded[m] == 0) moves[m] = 1;
  }
  // On a single fixed ball it rests only straight above it.
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    if (carrying.carries[k] == 0 || c.b != kWall || is_at_wall(island, k)) continue;
    const Vec<double> r = in_double(island.near[k].r);
    const double off = std::abs(cross(r, scale.pull));
    if (carrying.loaded[a] == 1 && off > 0x1p-40 * std::abs(dot(r, scale.pull))) moves[a] = 1;
  }
  std::vector<char> sets_move(n, 0);
  for (std::size_t m = 0; m < n; ++m) {
    // What stands belongs to more than is seen here.
    if (moves[m] != 0 || stands[m] != 0) sets_move[find(m)] = 1;
  }
  const std::vector<char> moved = sets_move;
  hold_still(island, {scale.pull, scale.next.way(), scale.speed}, carrying.sets, pressed.presses,
             sets_move);
  for (std::size_t m = 0; m < n; ++m) {
    if (pulled[m] != 0) sets_move[find(m)] = 1;
  }
  if (large) {
    for (std::size_t m = 0; m < n; ++m) {
      if (sets_move[find(m)] != moved[find(m)] || pulled[m] != 0) moves[m] = 1;
    }
    const std::vector<char> fast = moves;
    spread_motion(island, kMovesAlong, moves);
    for (std::size_t m = 0; m < n; ++m) {
      if (fast[m] == 0 && carrying.loaded[m] > 0 && carrying.on_balls[m] == 0) moves[m] = 0;
    }
    return moves;
  }
  // Where energy is lost, what comes nearer to what rests, or leaves, would hit the island at once.
  if (!motion_.elastic()) pass_on_motion(island, carrying.sets, sets_move);
  for (std::size_t m = 0; m < n; ++m) moves[m] = sets_move[find(m)];
  return moves;
}

template <class P>
std::uint64_t IslandStepping<P>::give_support(Island& island, const std::vector<ConeBody>& ends,
                                              const Carrying& carrying,
                                              const std::vector<char>& moves,
                                              const std::vector<char>& stands,
                                              const std::vector<char>& stays) const {
  const std::size_t n = island.members.size();
  std::vector<char> newly(n, 0);
  for (std::size_t m = 0; m < n; ++m) {
    ConeBody& body = island.bodies[m];
    if (moves[m] == 0) {
      newly[m] = island.support[m] != kResting ? 1 : 0;
      island.support[m] = kResting;
      body.velocity = {0, 0};
      body.turning = 0;
    } else if (stands[m] == 0 && carrying.loaded[m] == 0 && carrying.approaches[m] == 0 &&
               stays[m] == 0) {
      island.support[m] = 0;
      body = ends[m];
    } else {
      island.support[m] = kStepped;
    }
  }
  std::uint64_t rest = 0;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    if (carrying.carries[k] == 0) continue;
    if (newly[static_cast<std::size_t>(c.a)] != 0 ||
        (c.b != kWall && newly[static_cast<std::size_t>(c.b)] != 0)) {
      ++rest;
    }
  }
  return rest;
}

template <class P>
void IslandStepping<P>::put_on_walls(Island& island, const std::vector<ConeBody>& ends,
                                     const Carrying& carrying, const std::vector<char>& stays,
                                     const Scale& scale) const {
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    const Index wall = island.near[k].partner;
    if (!is_at_wall(island, k)) continue;
    // It does not go into a wall that takes speed, not even by what has been left unsolved.
    const bool takes = motion_.rules().wall_restitution < 1 && island.support[a] == kStepped;
    if (carrying.carries[k] == 0 || island.touches[k] == 0) {
      const double most = c.gap / scale.next.way();
      if (takes && approach(island, k) < most + 4 * scale.goal) stop_at(island.bodies[a], c, most);
      continue;
    }
    if (motion_.elastic() && c.gap > 0) continue;
    island.lifted += put_on_wall(motion_, disks_[island.members[a]], wall, island.places[a]);
    if (takes && approach(island, k) < 4 * scale.goal) stop_at(island.bodies[a], c);
    // Only walls carry it: it slides on, or rolls, if it does not come to rest.
    if (carrying.on_balls[a] != 0 || carrying.approaches[a] != 0 || stays[a] != 0) continue;
    const bool rests = island.support[a] == kResting && !motion_.elastic();
    if (island.support[a] != 0 && !rests) island.bodies[a] = ends[a];
    Vec<double>& v = island.bodies[a].velocity;
    (wall - kWalls < 2 ? v.x : v.y) = 0;
    island.support[a] = 0;
  }
}

// The normal of a contact that slides turns: it parts before a step by about what it closes after.
// That is little of what the two move with.
template <class P>
double IslandStepping<P>::given_by_parting(const Island& island,
                                           const std::vector<ConeBody>& before,
                                           const std::vector<double>& loads, double still,
                                           double span) {
  ExactSum<double> given;
  ExactSum<double> moves;
  for (const ConeBody& body : before) {
    moves.add(dot(body.velocity, body.velocity) / body.inverse_mass);
  }
  for (std::size_t k = 0; k < loads.size(); ++k) {
    if (!(loads[k] > 0)) continue;
    const ConeContact& c = island.contacts[k];
    const ConeBody& a = before[static_cast<std::size_t>(c.a)];
    const ConeBody b = c.b == kWall ? ConeBody{} : before[static_cast<std::size_t>(c.b)];
    if (is_slow(a, still) && is_slow(b, still)) continue;
    // It turns by no more than they go past each other.
    const Vec<double> past = a.velocity - b.velocity;
    const double slip = cross(c.normal, past);
    const double reach = std::sqrt(static_cast<double>(S(dot(island.near[k].r, island.near[k].r))));
    const bool wall = is_at_wall(island, k);
    const double turns = wall ? 0 : slip * slip * span / reach;
    const double parts = std::min(-sharp_dot(c.normal, past) - approach(island, k), turns);
    if (parts > 0) given.add(loads[k] * parts);
  }
  return std::min(given.rounded(), kTurns * moves.rounded());
}

// Where nothing moved, and what a step made was all taken as energy that there is not, it was what
// had been left unsolved: balls that gravity moves gain what they fall.
template <class P>
void IslandStepping<P>::rest_if_stopped(Island& island, const std::vector<ConeBody>& before,
                                        const std::vector<char>& pulled, const Scale& scale) {
  const double most = kHeld / 2 * scale.speed;
  for (std::size_t m = 0; m < before.size(); ++m) {
    if (island.support[m] == kResting) continue;
    if (pulled[m] != 0 || !is_slow(before[m], most) || !is_slow(island.bodies[m], most)) return;
  }
  for (std::size_t m = 0; m < before.size(); ++m) {
    if (island.support[m] != kStepped) continue;
    island.bodies[m].velocity = {0, 0};
    island.bodies[m].turning = 0;
  }
  std::replace(island.support.begin(), island.support.end(), kStepped, kResting);
}

template <class P>
IslandChange IslandStepping<P>::step(Island& island, bool whole) const {
  IslandChange change;
  change.counts.steps = 1;
  const Scale scale = this->scale();
  const std::vector<ConeBody> before = island.bodies;
  const SteppedEnergy& energy = impulses_.energy();
  const double had = energy.so_far(island);
  std::vector<char> stands(before.size(), 0);
  if (!whole && !motion_.elastic() && is_large(island)) {
    for (std::size_t m = 0; m < stands.size(); ++m) {
      stands[m] = island.support[m] == kResting ? 1 : 0;
    }
  }
  Pressed pressed = press(island, stands, scale);
  if (reaches_standing(island, stands, scale.still)) {
    island.bodies = before;
    std::fill(stands.begin(), stands.end(), 0);
    pressed = press(island, stands, scale);
  }
  Carrying carrying = this->carrying(island, before, pressed, scale);
  const std::vector<char> pulled = motion_.elastic_impacts()
                                       ? std::vector<char>(before.size(), 0)
                                       : pulled_along(island, scale.pull, pressed.presses);
  const std::vector<char> moves = moving(island, before, pressed, carrying, stands, pulled, scale);
  const double given =
      given_by_parting(island, before, pressed.loads, scale.still, scale.next.seconds);
  const std::vector<ConeBody> ends = at_end(island, before, scale);
  const std::vector<char> stays =
      motion_.elastic() ? std::vector<char>(before.size(), 0) : met(island, ends);
  const std::vector<unsigned> were = island.support;
  change.counts.resting_contacts = give_support(island, ends, carrying, moves, stands, stays);
  put_on_walls(island, ends, carrying, stays, scale);
  energy.leave_out(island, before, scale.next);
  double keeps = had;
  if (!motion_.keeps_energy()) keeps += energy.of_leaving(island, before, were) + given;
  if (energy.keep(island, keeps, scale.next, impulses_.loses())) {
    impulses_.keep_gaps(island, keeps, scale.next, scale.goal, pressed.loads);
  }
  if (!motion_.elastic()) rest_if_stopped(island, before, pulled, scale);
  const double lost = energy.loss(island, had, scale.next);
  if (energy.is_held(island, lost)) change.counts.jammed = 1;
  change.carried = {std::move(pressed.loads), std::vector<char>(island.contacts.size(), 0), lost};
  return change;
}

}  // namespace carom::event
