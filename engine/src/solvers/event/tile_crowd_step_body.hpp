#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "contact/crowd.hpp"
#include "contact/rest_rules.hpp"
#include "solvers/event/tile_gathering_body.hpp"
#include "state/stopwatch.hpp"

namespace carom::event {

template <class P>
void Tile<P>::step_crowds(At now) {
  const Stopwatch stopwatch(true, crowd_seconds_);
  std::vector<Index> all;
  for (Index i = 0; i < disks_.size(); ++i) {
    if (!motion_.fixed(disks_[i]) && motion_.carried(disks_[i]) >= kStepped) all.push_back(i);
  }
  std::vector<char> stepped(disks_.size(), 0);
  begin_resolution();
  for (const Index i : all) {
    if (stepped[i] != 0) continue;
    Gathering crowd;
    join(crowd, i, now);
    gather(crowd, now);
    for (const Index m : crowd.members) stepped[m] = 1;
    step_crowd(crowd, now);
  }
  begin_instant();  // what comes now takes no step back
  look_again_at_changed(now);
}

// What is slow comes to rest only where forces at its contacts hold it: what is pulled moves on. Of
// many balls, which creep until all contacts carry, slowness decides.
template <class P>
void Tile<P>::hold_still(const Gathering& crowd, std::vector<std::size_t>& set,
                         const std::vector<char>& carries, std::vector<char>& moves) const {
  const std::size_t n = crowd.members.size();
  const auto find = [&set](std::size_t k) {
    while (set[k] != k) k = set[k] = set[set[k]];
    return k;
  };
  const auto span = static_cast<double>(
      S(motion_.rules().scale.seconds(P::Clock::span(1, motion_.step_shift()))));
  const auto speed = static_cast<double>(motion_.speed_of_step());
  const Vec<double> g = in_double(motion_.law().pull());
  for (std::size_t first = 0; first < n; ++first) {
    if (find(first) != first || moves[first] != 0) continue;
    std::vector<int> number(n, -1);
    std::vector<CrowdBody> bodies;
    bool fresh = false;
    for (std::size_t m = 0; m < n; ++m) {
      if (find(m) != first) continue;
      number[m] = static_cast<int>(bodies.size());
      bodies.push_back({span * g, 0, crowd.bodies[m].inverse_mass});
      fresh = fresh || crowd.carried[m] != kResting;
    }
    if (!fresh || bodies.size() > kFewHeld) continue;
    std::vector<CrowdContact> contacts;
    for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
      CrowdContact contact = crowd.contacts[k];
      const int a = number[static_cast<std::size_t>(contact.a)];
      if (a < 0 || (carries[k] == 0 && !crowd.near[k].touches)) continue;
      contact.a = a;
      if (contact.b != kWall) contact.b = number[static_cast<std::size_t>(contact.b)];
      if (crowd.contacts[k].b != kWall && contact.b < 0) continue;
      contact.gap = 0;
      contacts.push_back(contact);
    }
    Crowd whole(bodies, contacts);
    whole.resolve(bodies, 0, kHeld / 4 * speed);
    for (const CrowdBody& body : bodies) {
      const double most =
          std::max({std::abs(body.velocity.x), std::abs(body.velocity.y), std::abs(body.turning)});
      if (most > kHeld * speed) moves[first] = 1;
    }
  }
}

template <class P>
void Tile<P>::step_crowd(Gathering& crowd, At now) {
  ++counts_.steps;
  const std::size_t n = crowd.members.size();
  const Vec<double> g = in_double(motion_.law().pull());
  const auto span = static_cast<double>(
      S(motion_.rules().scale.seconds(P::Clock::span(1, motion_.step_shift()))));
  const auto speed = static_cast<double>(motion_.speed_of_step());
  const double still = (motion_.elastic() ? kStill * kStill : kStill) * speed;
  const std::vector<CrowdBody> before = crowd.bodies;
  const double had = energy_of(crowd, 0).all();
  std::vector<CrowdContact> lasting;
  std::vector<std::size_t> number;
  for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
    if (!lasts(crowd, k)) continue;
    lasting.push_back(crowd.contacts[k]);
    number.push_back(k);
  }
  for (CrowdBody& body : crowd.bodies) body.velocity = body.velocity + span * g;
  Crowd whole(crowd.bodies, lasting);
  const double goal = (motion_.elastic() ? kSolved * kSolved : kSolved) * speed;
  const std::vector<double> pushes = whole.resolve(crowd.bodies, 1 / span, goal, true);
  std::vector<double> loads(crowd.contacts.size(), 0);
  for (std::size_t k = 0; k < number.size(); ++k) loads[number[k]] = pushes[k];

  std::vector<std::size_t> set(n);
  std::iota(set.begin(), set.end(), 0U);
  const auto find = [&set](std::size_t k) {
    while (set[k] != k) k = set[k] = set[set[k]];
    return k;
  };
  std::vector<int> loaded(n, 0);
  std::vector<char> on_balls(n, 0);
  std::vector<char> approaches(n, 0);
  std::vector<char> carries(crowd.contacts.size(), 0);
  for (const std::size_t k : number) {
    const CrowdContact& c = crowd.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    const auto b = c.b == kWall ? a : static_cast<std::size_t>(c.b);
    const double mobility =
        crowd.bodies[a].inverse_mass + (c.b == kWall ? 0 : crowd.bodies[b].inverse_mass);
    const Vec<double> other = c.b == kWall ? Vec<double>{0, 0} : before[b].velocity;
    if (dot(c.normal, other - before[a].velocity) < -still) approaches[a] = approaches[b] = 1;
    if (!(loads[k] * mobility > kLoaded * speed)) continue;
    carries[k] = 1;
    ++loaded[a];
    const bool wall = c.b == kWall && crowd.near[k].partner >= kFirstMark;
    if (!wall) on_balls[a] = 1;
    if (c.b == kWall) continue;
    ++loaded[b];
    on_balls[b] = 1;
    set[find(a)] = find(b);
  }
  std::vector<char> restless(n, 0);
  for (std::size_t m = 0; m < n; ++m) {
    const CrowdBody& body = crowd.bodies[m];
    // Who rests already is not woken by what has not been solved to the end.
    const double most = crowd.carried[m] == kResting ? 4 * still : still;
    if (std::abs(body.velocity.x) > most || std::abs(body.velocity.y) > most ||
        std::abs(body.turning) > most || loaded[m] == 0) {
      restless[m] = 1;
    }
  }
  // On a single fixed ball it rests only straight above it.
  for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
    const CrowdContact& c = crowd.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    if (carries[k] == 0 || c.b != kWall || crowd.near[k].partner >= kFirstMark) continue;
    const Vec<double> r = in_double(crowd.near[k].r);
    const double off = std::abs(cross(r, g));
    if (loaded[a] == 1 && off > 0x1p-40 * std::abs(dot(r, g))) restless[a] = 1;
  }
  std::vector<char> moves(n, 0);
  for (std::size_t m = 0; m < n; ++m) {
    if (restless[m] != 0) moves[find(m)] = 1;
  }
  hold_still(crowd, set, carries, moves);
  std::vector<char> newly(n, 0);
  for (std::size_t m = 0; m < n; ++m) {
    CrowdBody& body = crowd.bodies[m];
    if (moves[find(m)] == 0) {
      newly[m] = crowd.carried[m] != kResting ? 1 : 0;
      crowd.carried[m] = kResting;
      body.velocity = {0, 0};
      body.turning = 0;
    } else if (loaded[m] == 0 && approaches[m] == 0) {
      crowd.carried[m] = 0;
      body = before[m];
    } else {
      crowd.carried[m] = kStepped;
    }
  }
  for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
    const CrowdContact& c = crowd.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    if (carries[k] == 0) continue;
    if (newly[a] != 0 || (c.b != kWall && newly[static_cast<std::size_t>(c.b)] != 0)) {
      ++counts_.resting_contacts;
    }
    const Index wall = crowd.near[k].partner;
    if (c.b != kWall || wall < kFirstMark || !crowd.near[k].touches) continue;
    if (motion_.elastic() && c.gap > 0) continue;
    const bool x = wall - kWalls < 2;
    const Disk& disk = disks_[crowd.members[a]];
    put_at(crowd, crowd.places[a], x ? 0 : 1, motion_.wall(disk, crowd.places[a], wall).stop,
           motion_.kind(disk).inverse_mass);
    // Only walls carry it: it slides on, or rolls, if it does not come to rest.
    if (on_balls[a] != 0 || approaches[a] != 0) continue;
    const bool rests = crowd.carried[a] == kResting && !motion_.elastic();
    if (crowd.carried[a] != 0 && !rests) crowd.bodies[a] = before[a];
    (x ? crowd.bodies[a].velocity.x : crowd.bodies[a].velocity.y) = 0;
    crowd.carried[a] = 0;
  }
  keep_energy(crowd, had, span);
  const double lost = loss_of(crowd, had, span);
  note_held(crowd, lost);
  const std::size_t first_line = log_ != nullptr ? log_->impacts.size() : 0;
  if (log_ != nullptr) {
    CrowdLog log;
    log.counted.resize(loads.size(), 0);
    log.impulses = loads;
    log.lost = lost;
    log_crowd(crowd, log, now);
  }
  book_.correct(lost);
  log_loss(first_line, fly_on(crowd, now));
}

}  // namespace carom::event
