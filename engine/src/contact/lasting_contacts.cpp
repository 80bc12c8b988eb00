#include "contact/lasting_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/ball_contact.hpp"
#include "contact/island_account.hpp"
#include "contact/island_energy.hpp"
#include "contact/pushes.hpp"
#include "contact/wall_contacts.hpp"

namespace carom::contact {
namespace {

// What is slow, as a part of the speed that the acceleration makes in a step.  Balls that roll on
// each other like gears lose nothing: islands fall asleep sooner than a ball alone, which may
// glide.
constexpr double kStill = 0x1p-6;
constexpr double kStillAlone = 0x1p-10;
// Closer than this after the flight balls are linked, as a part of how far the acceleration takes
// a ball in a step.
constexpr double kLinked = 3;
constexpr double kUnequal = 16;  // masses: the heavier ball lies on the lighter one for long

Vec2 column(const std::array<std::vector<double>, 2>& columns, std::size_t ball) {
  return {columns[0][ball], columns[1][ball]};
}

Vec2 velocity(const Balls& balls, std::size_t ball) {
  return {balls.velocity[0][ball], balls.velocity[1][ball]};
}

}  // namespace

bool contacts_last(const Effects& effects, const Balls& balls) {
  const bool pulled = effects.gravity && effects.gravity->acceleration != Vec2{0, 0};
  const bool collide = effects.collisions && effects.collisions->on;
  const bool walls = effects.walls && effects.walls->on;
  if (!pulled || !(collide || walls)) return false;
  if (loses_energy(effects) || (effects.friction && walls)) return true;
  if (!collide) return false;
  double least = 0;
  double most = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (balls.fixed(i)) continue;
    const double mass = balls.mass[i];
    least = least == 0 ? mass : std::min(least, mass);
    most = std::max(most, mass);
  }
  return most > kUnequal * least;
}

void LastingContacts::wake_all(const Balls& balls) {
  asleep_.assign(balls.size(), 0);
  slept_.assign(balls.size(), 0);
  driven_.assign(balls.size(), 0);
  sets_.make_room(balls.size());
  island_of_.assign(balls.size(), -1);
  member_of_.assign(balls.size(), -1);
  islands_.clear();
  place_.assign(balls.size(), -1);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    start_[axis].resize(balls.size());
    before_[axis].resize(balls.size());
  }
  awake_ = 0;
  sleepers_ = 0;
  woken_ = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) awake_ += balls.fixed(i) ? 0 : 1;
}

void LastingContacts::begin(const Balls& balls, std::size_t begin, std::size_t end) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto from = static_cast<std::ptrdiff_t>(begin);
    std::copy(balls.position[axis].data() + begin, balls.position[axis].data() + end,
              start_[axis].begin() + from);
    std::copy(balls.velocity[axis].data() + begin, balls.velocity[axis].data() + end,
              before_[axis].begin() + from);
  }
  for (std::size_t i = begin; i < end; ++i) slept_[i] = asleep_[i];
}

void LastingContacts::end(Balls& balls, std::size_t begin, std::size_t end,
                          std::vector<std::uint32_t>& out) const {
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t k = i;
    if (asleep_[i] != 0) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        balls.position[axis][k] = start_[axis][i];
        balls.velocity[axis][k] = 0;
      }
      continue;
    }
    if (balls.inverse_mass[k] == 0) continue;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (!domain_.solid(axis)) continue;
      const double x = balls.position[axis][k];
      const double radius = balls.radius[k];
      if (x < domain_.lowest(axis, radius) || x > domain_.highest(axis, radius)) {
        out.push_back(static_cast<std::uint32_t>(i));
        break;
      }
    }
  }
}

bool LastingContacts::closer(const Balls& balls, const Pair& pair, double gap) const {
  const double reach = balls.radius[pair.first] + balls.radius[pair.second] + gap;
  return nearest_image(balls.at(pair.second) - balls.at(pair.first), domain_).squaredNorm() <
         reach * reach;
}

void LastingContacts::wake(Balls& balls, std::uint32_t ball) {
  asleep_[ball] = 0;
  ++awake_;
  ++woken_;
  --sleepers_;
  const std::size_t k = ball;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    double x = start_[axis][ball] + rule_.fall[axis];
    if (domain_.period[axis] > 0) x = domain_.wrapped(axis, x);
    balls.position[axis][k] = x;
    balls.velocity[axis][k] = rule_.gain[axis];
  }
}

// Who is awake and comes into a ball that sleeps wakes all that lie together with it.
void LastingContacts::wake_struck(Balls& balls, std::span<const Pair> near) {
  std::vector<char> woken(balls.size(), 0);
  for (bool more = true; std::exchange(more, false);) {
    for (const Pair& pair : near) {
      if (asleep_[pair.first] == asleep_[pair.second]) {
        continue;
      }
      const bool first = asleep_[pair.first] != 0;
      const std::uint32_t sleeper = first ? pair.first : pair.second;
      const std::uint32_t other = first ? pair.second : pair.first;
      if (balls.fixed(other)) continue;
      if (woken[other] == 0 && !overlap(balls, pair)) continue;
      wake(balls, sleeper);
      woken[sleeper] = 1;
      more = true;
    }
  }
}

void LastingContacts::form(Balls& balls, std::span<const Pair> near,
                           std::span<const std::uint32_t> out) {
  for (const Island& island : islands_) {
    for (const Member& member : island.members) member_of_[member.ball] = -1;
  }
  islands_.clear();
  linked_.clear();
  if (near.empty() && out.empty()) return;
  seeds_.assign(out.begin(), out.end());
  if (sleepers_ > 0) wake_struck(balls, near);
  if (sleepers_ > 0 || woken_ > 0) {
    for (std::uint32_t i = 0; i < slept_.size(); ++i) {
      if (slept_[i] != asleep_[i]) seeds_.push_back(i);  // it is solved, wherever it lies
    }
  }
  const double gap = kLinked * rule_.acceleration.norm() * rule_.step * rule_.step;
  foresee_links(balls, near, out, gap);
  assemble(balls, near, gap);
}

// What overlaps after the flight will be pushed back by as much, and pushes what is in its way.
void LastingContacts::foresee_links(const Balls& balls, std::span<const Pair> near,
                                    std::span<const std::uint32_t> out, double gap) {
  pushes_.resize(balls.size());
  std::vector<Pair> pairs;
  std::vector<double> gaps;
  for (const Pair& pair : near) pushes_[pair.first] = pushes_[pair.second] = 0;
  for (const std::uint32_t ball : out) {
    double& push = pushes_[ball];
    push = 0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (!domain_.solid(axis)) continue;
      const double x = balls.position[axis][ball];
      const double radius = balls.radius[ball];
      push = std::max({push, domain_.lowest(axis, radius) - x, x - domain_.highest(axis, radius)});
    }
  }
  bool any = !out.empty();
  for (const Pair& pair : near) {
    const bool first = moves(balls, pair.first);
    const bool second = moves(balls, pair.second);
    if (!first && !second) continue;
    const double reach = balls.radius[pair.first] + balls.radius[pair.second];
    const Vec2 r = nearest_image(balls.at(pair.second) - balls.at(pair.first), domain_);
    const double apart = r.norm() - reach;
    if (apart < 0) {
      any = true;
      if (first) pushes_[pair.first] = std::max(pushes_[pair.first], -apart);
      if (second) pushes_[pair.second] = std::max(pushes_[pair.second], -apart);
    }
    if (!first || !second) continue;
    pairs.push_back(pair);
    gaps.push_back(apart);
  }
  if (!any) return;
  pass_on_pushes(pairs, gaps, pushes_);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double push = std::max(pushes_[pairs[k].first], pushes_[pairs[k].second]);
    if (gaps[k] < gap + push) linked_.push_back(pairs[k]);
  }
}

// The islands of the seeds and of balls that overlap, among balls that are of no island yet.
void LastingContacts::assemble(const Balls& balls, std::span<const Pair> near, double gap) {
  const auto open = [&](std::uint32_t i) { return moves(balls, i) && member_of_[i] < 0; };
  std::vector<std::uint32_t> touched = seeds_;
  std::vector<Pair> links;
  for (const Pair& pair : near) {
    const bool first = open(pair.first);
    const bool second = open(pair.second);
    if (first && second) {
      if (!closer(balls, pair, gap) && !std::binary_search(linked_.begin(), linked_.end(), pair))
        continue;
      links.push_back(pair);
      touched.push_back(pair.first);
      touched.push_back(pair.second);
      if (overlap(balls, pair)) seeds_.push_back(pair.first);
    } else if ((first && !moves(balls, pair.second)) || (second && !moves(balls, pair.first))) {
      if (!overlap(balls, pair)) continue;
      touched.push_back(first ? pair.first : pair.second);
      seeds_.push_back(touched.back());
    }
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  for (const std::uint32_t i : touched) {
    sets_.isolate(i);
    island_of_[i] = -1;
  }
  for (const Pair& pair : links) {
    sets_.merge(pair.first, pair.second);
  }
  const std::size_t first_island = islands_.size();
  for (const std::uint32_t i : seeds_) {
    int& island = island_of_[sets_.find(i)];
    if (!open(i) || island >= 0) continue;
    island = static_cast<int>(islands_.size());
    islands_.emplace_back();
  }
  for (const std::uint32_t i : touched) {
    const int island = island_of_[sets_.find(i)];
    if (island >= 0) add_member(islands_[static_cast<std::size_t>(island)], balls, i);
  }
  number_members(first_island);
  for (const Pair& pair : near) {
    const bool first = moves(balls, pair.first);
    const bool second = moves(balls, pair.second);
    if (!first && !second) continue;
    const int number = member_of_[first ? pair.first : pair.second];
    if (number < static_cast<int>(first_island)) continue;
    if (first && second && member_of_[pair.second] != number) continue;
    const int a = first ? place_[pair.first] : -1;
    const int b = second ? place_[pair.second] : -1;
    add_pair(islands_[static_cast<std::size_t>(number)], balls, a, b, pair);
  }
  for (std::size_t k = first_island; k < islands_.size(); ++k) {
    Island& island = islands_[k];
    if (has_walls())
      add_wall_contacts(island, domain_, {rule_.wall_restitution, rule_.wall_friction}, driven_);
    island.lay_out(rule_.acceleration, rule_.step);
  }
}

void LastingContacts::find_crossing(const Balls& balls, std::span<const Pair> near,
                                    std::vector<Pair>& crossing) const {
  for (const Pair& pair : near) {
    if (member_of_[pair.first] == member_of_[pair.second]) continue;
    if (!moves(balls, pair.first) || !moves(balls, pair.second)) continue;
    if (overlap(balls, pair)) crossing.push_back(pair);
  }
}

void LastingContacts::join(Balls& balls, std::span<const Pair> near, std::span<const Pair> crossing,
                           bool all) {
  std::vector<char> opened(islands_.size(), all ? 1 : 0);
  const auto open = [&](std::uint32_t ball) {
    if (member_of_[ball] >= 0) opened[static_cast<std::size_t>(member_of_[ball])] = 1;
    if (moves(balls, ball)) seeds_.push_back(ball);
  };
  seeds_.clear();
  for (const Pair& pair : crossing) {
    open(pair.first);
    open(pair.second);
  }
  std::vector<Island> kept;
  for (std::size_t k = 0; k < islands_.size(); ++k) {
    Island& island = islands_[k];
    if (opened[k] == 0 && !island.driven) {
      for (const Member& member : island.members) {
        member_of_[member.ball] = static_cast<int>(kept.size());
      }
      kept.push_back(std::move(island));
      continue;
    }
    undo(balls, island);
    for (const Member& member : island.members) {
      member_of_[member.ball] = -1;
      seeds_.push_back(member.ball);
    }
  }
  islands_ = std::move(kept);
  linked_.insert(linked_.end(), crossing.begin(), crossing.end());
  std::sort(linked_.begin(), linked_.end());
  // What is near may be come to next.
  assemble(balls, near, std::numeric_limits<double>::infinity());
}

void LastingContacts::add_member(Island& island, const Balls& balls, std::uint32_t ball) {
  const std::size_t k = ball;
  Member member;
  member.ball = ball;
  member.start = column(start_, ball);
  member.before = column(before_, ball);
  member.flown = balls.at(ball);
  member.flown_velocity = velocity(balls, ball);
  member.flight = nearest_image(member.flown - member.start, domain_);
  member.inverse_mass = balls.inverse_mass[k];
  member.radius = balls.radius[k];
  member.woken = slept_[ball] != 0;
  if (balls.spin.size() > 0) member.spin = balls.spin[k];
  island.members.push_back(member);
}

void LastingContacts::number_members(std::size_t first_island) {
  for (std::size_t number = first_island; number < islands_.size(); ++number) {
    const Island& island = islands_[number];
    for (std::size_t k = 0; k < island.members.size(); ++k) {
      member_of_[island.members[k].ball] = static_cast<int>(number);
      place_[island.members[k].ball] = static_cast<int>(k);
    }
  }
}

void LastingContacts::add_pair(Island& island, const Balls& balls, int a, int b,
                               const Pair& pair) const {
  std::uint32_t from = pair.first;
  std::uint32_t to = pair.second;
  if (a < 0) {
    std::swap(a, b);
    std::swap(from, to);
  }
  const double radius = balls.radius[from];
  const double other = balls.radius[to];
  const Vec2 r = nearest_image(column(start_, to) - column(start_, from), domain_);
  const Vec2 end = nearest_image(balls.at(to) - balls.at(from), domain_);
  IslandContact contact = ball_contact(r, nearest_image(end - r, domain_), radius + other);
  contact.a = a;
  contact.b = b;
  contact.friction = rule_.friction;
  contact.restitution = rule_.restitution;
  island.add_contact(contact, {std::min(radius, other), to, false});
}

IslandStep::Rule LastingContacts::step_rule(const Frame& frame) const {
  IslandStep::Rule rule;
  rule.step = rule_.step;
  rule.acceleration = frame.into(rule_.acceleration);
  rule.rest_speed = rule_.rest_speed;
  rule.speed = rule_.acceleration.norm() * rule_.step;
  rule.fading = rule_.fading;
  rule.keeps_energy = rule_.keeps_energy;
  return rule;
}

void LastingContacts::put(Balls& balls, Member& member, const Vec2& place, const Vec2& velocity,
                          double spin) {
  const std::size_t k = member.ball;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::size_t i = axis;
    const double period = domain_.period[axis];
    double x = place[i];
    if (domain_.solid(axis)) {
      x = std::clamp(x, domain_.lowest(axis, balls.radius[k]),
                     domain_.highest(axis, balls.radius[k]));
    } else if (period > 0) {
      x = domain_.wrapped(axis, x);
      if (!turns_[axis].empty()) {
        const double flown =
            member.start[i] + nearest_image(member.flown[i] - member.start[i], period);
        const auto turns =
            std::llrint((place[i] - x) / period) - std::llrint((flown - member.flown[i]) / period);
        turns_[axis][member.ball] += turns - member.turned[axis];
        member.turned[axis] = turns;
      }
    }
    balls.position[axis][k] = x;
    balls.velocity[axis][k] = velocity[i];
  }
  if (balls.spin.size() > 0) balls.spin[k] = spin;
}

void LastingContacts::resolve(std::size_t number, Balls& balls, bool may_sleep, IslandStep& step,
                              const ImpactLog& log) {
  thread_local IslandOutcome outcome;
  Island& island = islands_[number];
  if (std::exchange(island.resolved, true)) return;
  const IslandStep::Rule rule = step_rule(island.frame);
  const bool spins = balls.spin.size() > 0;
  step.take(island.bodies, island.contacts, spins, rule, outcome);
  const double still = (island.members.size() > 1 ? kStill : kStillAlone) * rule.speed;
  bool slow = may_sleep;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    slow = slow && outcome.bounced[k] == 0;
    if (outcome.bounced[k] == 0) continue;
    ++(island.sources[k].wall ? island.ball_wall : island.ball_ball);
  }
  for (std::size_t m = 0; m < island.members.size() && slow; ++m) {
    const Vec2& v = outcome.after[m];
    slow =
        std::abs(v.x()) < still && std::abs(v.y()) < still && std::abs(outcome.turning[m]) < still;
  }
  island.sleeps = slow && step.holds(island.bodies, island.contacts, spins, rule);
  if (has_walls() && !island.sleeps) {
    const WallEnds ends = ends_at_walls(island, outcome.mean, rule_.step, domain_);
    for (const std::uint32_t ball : ends.beyond_far) {
      island.driven = island.driven || driven_[ball] == 0;
      driven_[ball] = 1;
    }
    if (ends.out > kExact * rule.speed) {
      confine(island.bodies, rule, ends.inside, outcome);
    } else if (ends.out > 0 && rule.keeps_energy) {
      pay_for_rounding(rule, ends.inside, outcome);
    }
  }
  island.turn_back(outcome);
  for (std::size_t m = 0; m < island.members.size(); ++m) {
    Member& member = island.members[m];
    if (island.sleeps) {
      put(balls, member, member.start, {0, 0}, 0);
      continue;
    }
    const Vec2 place = member.start + rule_.step * outcome.mean[m];
    put(balls, member, place, outcome.after[m], outcome.turning[m] / member.radius);
    const Vec2 pushed = rule_.step * outcome.mean[m] - member.flight;
    island.push = std::max(island.push, pushed.norm());
  }
  for (std::size_t k = 0; k < island.contacts.size() && !island.sleeps; ++k) {
    const IslandContact& c = island.contacts[k];
    if (c.b < 0) continue;
    const Member& a = island.members[static_cast<std::size_t>(c.a)];
    const Member& b = island.members[static_cast<std::size_t>(c.b)];
    const double reach = balls.radius[a.ball] + balls.radius[b.ball];
    const double distance = nearest_image(balls.at(b.ball) - balls.at(a.ball), domain_).norm();
    island.deepest = std::max(island.deepest, (reach - distance) / island.sources[k].smaller);
  }
  island.lost = lost_by(island, balls, domain_, rule_.acceleration);
  if (!log.wanted) return;
  ImpactLog noted{true, log.time, {}};
  note_contacts(island, balls, outcome, noted);
  island.impacts = std::move(noted.impacts);
}

double LastingContacts::farthest_push() const {
  double farthest = 0;
  for (const Island& island : islands_) farthest = std::max(farthest, island.push);
  return farthest;
}

bool LastingContacts::any_driven() const {
  return std::any_of(islands_.begin(), islands_.end(),
                     [](const Island& island) { return island.driven; });
}

void LastingContacts::undo(Balls& balls, const Island& island) {
  for (const Member& member : island.members) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      balls.position[axis][member.ball] = member.flown[axis];
      balls.velocity[axis][member.ball] = member.flown_velocity[axis];
      if (!turns_[axis].empty()) turns_[axis][member.ball] -= member.turned[axis];
    }
    if (balls.spin.size() > 0) balls.spin[member.ball] = member.spin;
  }
}

void LastingContacts::settle(std::span<double> lost, Count& count, ImpactLog& log) {
  woken_ = 0;
  for (const Island& island : islands_) {
    count.ball_ball += island.ball_ball;
    count.ball_wall += island.ball_wall;
    count.deepest = std::max(count.deepest, island.deepest);
    log.impacts.insert(log.impacts.end(), island.impacts.begin(), island.impacts.end());
    for (const Member& member : island.members) driven_[member.ball] = 0;
    if (!lost.empty()) lost[island.members.front().ball] += island.lost;
    if (!island.sleeps) {
      if (log.wanted) note_woken(island, log);
      continue;
    }
    for (const Member& member : island.members) asleep_[member.ball] = 1;
    awake_ -= island.members.size();
    sleepers_ += island.members.size();
  }
}

// Groups of balls that stand still and are near each other: held or not, as if they had just
// stopped.
void LastingContacts::find_asleep(const Balls& balls, std::span<const Pair> near) {
  wake_all(balls);
  begin(balls, 0, balls.size());
  std::vector<char> still(balls.size(), 0);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const bool turns = balls.spin.size() > 0 && balls.spin[i] != 0;
    still[i] = !balls.fixed(i) && velocity(balls, i) == Vec2{0, 0} && !turns ? 1 : 0;
    sets_.isolate(static_cast<std::uint32_t>(i));
  }
  for (const Pair& pair : near) {
    if (still[pair.first] == 0 || still[pair.second] == 0) continue;
    sets_.merge(pair.first, pair.second);
  }
  islands_.clear();
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    if (still[i] == 0) continue;
    if (sets_.find(i) == i) {
      island_of_[i] = static_cast<int>(islands_.size());
      islands_.emplace_back();
    }
    add_member(islands_[static_cast<std::size_t>(island_of_[sets_.find(i)])], balls, i);
  }
  number_members(0);
  for (const Pair& pair : near) {
    const bool first = still[pair.first] != 0;
    const bool second = still[pair.second] != 0;
    // What moves carries nothing.
    if ((!first && !balls.fixed(pair.first)) || (!second && !balls.fixed(pair.second))) continue;
    if (!first && !second) continue;
    const auto number =
        static_cast<std::size_t>(island_of_[sets_.find(first ? pair.first : pair.second)]);
    add_pair(islands_[number], balls, first ? place_[pair.first] : -1,
             second ? place_[pair.second] : -1, pair);
  }
  IslandStep step;
  for (Island& island : islands_) {
    if (has_walls())
      add_wall_contacts(island, domain_, {rule_.wall_restitution, rule_.wall_friction}, driven_);
    island.lay_out(rule_.acceleration, rule_.step);
    island.sleeps =
        step.holds(island.bodies, island.contacts, balls.spin.size() > 0, step_rule(island.frame));
  }
  Count count;
  ImpactLog log;
  settle({}, count, log);
  for (const Island& island : islands_) {
    for (const Member& member : island.members) member_of_[member.ball] = -1;
  }
  islands_.clear();
}

}  // namespace carom::contact
