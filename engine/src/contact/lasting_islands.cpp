#include "contact/lasting_islands.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "contact/ball_contact.hpp"
#include "contact/ball_gap.hpp"
#include "contact/wall_contacts.hpp"

namespace carom::contact {
namespace {

// Closer than this after the flight balls are linked, as a part of how far the strongest
// acceleration takes a ball in a step.
constexpr double kLinked = 3;

}  // namespace

void LastingIslands::reset(std::size_t balls) {
  islands_.clear();
  sets_.make_room(balls);
  driven_.assign(balls, 0);
  island_of_.assign(balls, -1);
  island_of_root_.assign(balls, -1);
  place_.assign(balls, -1);
}

void LastingIslands::clear() {
  for (const LastingIsland& island : islands_) {
    for (const auto& member : island.members) island_of_[member.ball] = -1;
  }
  islands_.clear();
  linked_.clear();
}

void LastingIslands::find(const Balls& balls, std::span<const Pair> near,
                          std::span<const std::uint32_t> out) {
  seeds_.assign(out.begin(), out.end());
  sleepers_.list_woken(seeds_);  // they are solved, wherever they lie
  const double gap = kLinked * rule_.strongest() * rule_.step * rule_.step;
  foreseen_.find(balls, near, out, gap, linked_);
  link(balls, near, gap);
  assemble(balls, near);
}

void LastingIslands::find_still(const Balls& balls, std::span<const Pair> near) {
  std::vector<char> still(balls.size(), 0);
  seeds_.clear();
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    const bool moves = balls.velocity[0][i] != 0 || balls.velocity[1][i] != 0;
    const bool turns = balls.spin.size() > 0 && balls.spin[i] != 0;
    if (balls.fixed(i) || moves || turns) continue;
    still[i] = 1;
    seeds_.push_back(i);
  }
  touched_ = seeds_;
  links_.clear();
  for (const Pair& pair : near) {
    if (still[pair.first] != 0 && still[pair.second] != 0) links_.push_back(pair);
  }
  assemble(balls, near);
}

std::vector<LastingIsland> LastingIslands::take_out(const Balls& balls,
                                                    std::span<const Pair> crossing, bool all) {
  std::vector<char> opened(islands_.size(), all ? 1 : 0);
  const auto open = [&](std::uint32_t ball) {
    if (island_of_[ball] >= 0) opened[static_cast<std::size_t>(island_of_[ball])] = 1;
    if (sleepers_.moves(balls, ball)) seeds_.push_back(ball);
  };
  seeds_.clear();
  for (const Pair& pair : crossing) {
    open(pair.first);
    open(pair.second);
  }
  std::vector<LastingIsland> taken;
  std::vector<LastingIsland> kept;
  for (std::size_t k = 0; k < islands_.size(); ++k) {
    LastingIsland& island = islands_[k];
    const bool leaves = opened[k] != 0 || island.driven;
    for (const auto& member : island.members) {
      island_of_[member.ball] = leaves ? -1 : static_cast<int>(kept.size());
      if (leaves) seeds_.push_back(member.ball);
    }
    (leaves ? taken : kept).push_back(std::move(island));
  }
  islands_ = std::move(kept);
  return taken;
}

void LastingIslands::find_again(const Balls& balls, std::span<const Pair> near,
                                std::span<const Pair> crossing) {
  linked_.insert(linked_.end(), crossing.begin(), crossing.end());
  std::sort(linked_.begin(), linked_.end());
  // What is near may be come to next.
  link(balls, near, std::numeric_limits<double>::infinity());
  assemble(balls, near);
}

// Balls that overlap are seeds; those that are closer than the gap are linked.  All of them are of
// no island yet.
void LastingIslands::link(const Balls& balls, std::span<const Pair> near, double gap) {
  const auto moves = [&](std::uint32_t i) { return sleepers_.moves(balls, i); };
  const auto open = [&](std::uint32_t i) { return moves(i) && island_of_[i] < 0; };
  touched_ = seeds_;
  links_.clear();
  for (const Pair& pair : near) {
    const bool first = open(pair.first);
    const bool second = open(pair.second);
    if (first && second) {
      if (!closer_than(gap, balls, pair, domain_) &&
          !std::binary_search(linked_.begin(), linked_.end(), pair))
        continue;
      links_.push_back(pair);
      touched_.push_back(pair.first);
      touched_.push_back(pair.second);
      if (overlap(balls, pair, domain_)) seeds_.push_back(pair.first);
    } else if ((first && !moves(pair.second)) || (second && !moves(pair.first))) {
      if (!overlap(balls, pair, domain_)) continue;
      touched_.push_back(first ? pair.first : pair.second);
      seeds_.push_back(touched_.back());
    }
  }
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
}

// The islands of the seeds.
void LastingIslands::assemble(const Balls& balls, std::span<const Pair> near) {
  for (const std::uint32_t i : touched_) {
    sets_.isolate(i);
    island_of_root_[i] = -1;
  }
  for (const Pair& pair : links_) sets_.merge(pair.first, pair.second);
  const std::size_t first_island = islands_.size();
  for (const std::uint32_t i : seeds_) {
    int& island = island_of_root_[sets_.find(i)];
    if (island >= 0) continue;
    island = static_cast<int>(islands_.size());
    islands_.emplace_back();
  }
  for (const std::uint32_t i : touched_) {
    const int island = island_of_root_[sets_.find(i)];
    if (island >= 0) islands_[static_cast<std::size_t>(island)].members.push_back(member(balls, i));
  }
  number_members(first_island);
  add_contacts(balls, near, first_island);
  const bool walls = domain_.solid(0) || domain_.solid(1);
  for (std::size_t k = first_island; k < islands_.size(); ++k) {
    LastingIsland& island = islands_[k];
    if (walls) {
      add_wall_contacts(island, domain_, {rule_.wall_restitution, rule_.wall_friction}, driven_);
    }
    island.lay_out(rule_.acceleration, rule_.step);
  }
}

void LastingIslands::number_members(std::size_t first_island) {
  for (std::size_t number = first_island; number < islands_.size(); ++number) {
    const LastingIsland& island = islands_[number];
    for (std::size_t k = 0; k < island.members.size(); ++k) {
      island_of_[island.members[k].ball] = static_cast<int>(number);
      place_[island.members[k].ball] = static_cast<int>(k);
    }
  }
}

void LastingIslands::add_contacts(const Balls& balls, std::span<const Pair> near,
                                  std::size_t first_island) {
  for (const Pair& pair : near) {
    const bool first = sleepers_.moves(balls, pair.first);
    const bool second = sleepers_.moves(balls, pair.second);
    if (!first && !second) continue;
    const int number = island_of_[first ? pair.first : pair.second];
    if (number < static_cast<int>(first_island)) continue;
    if (first && second && island_of_[pair.second] != number) continue;
    add_pair(islands_[static_cast<std::size_t>(number)], balls, first ? place_[pair.first] : -1,
             second ? place_[pair.second] : -1, pair);
  }
}

LastingIsland::Member LastingIslands::member(const Balls& balls, std::uint32_t ball) const {
  LastingIsland::Member member;
  member.ball = ball;
  member.start = start_.place(ball);
  member.before = start_.velocity(ball);
  member.flown = balls.at(ball);
  member.flown_velocity = {balls.velocity[0][ball], balls.velocity[1][ball]};
  if (balls.pull[0].size() > 0) {
    member.pull = {balls.pull[0][ball], balls.pull[1][ball]};
    member.pulled = rule_.step / 2 * member.pull;
    member.before -= member.pulled;
  }
  member.flight = nearest_image(member.flown - member.start, domain_);
  member.inverse_mass = balls.inverse_mass[ball];
  member.radius = balls.radius[ball];
  member.woken = sleepers_.woken(ball);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (turns_[axis].empty()) continue;
    member.turned_flying[axis] = turns_[axis][ball] - start_.turns(axis, ball);
  }
  if (balls.spin.size() > 0) member.spin = balls.spin[ball];
  return member;
}

void LastingIslands::add_pair(LastingIsland& island, const Balls& balls, int a, int b,
                              const Pair& pair) const {
  std::uint32_t from = pair.first;
  std::uint32_t to = pair.second;
  if (a < 0) {
    std::swap(a, b);
    std::swap(from, to);
  }
  const double radius = balls.radius[from];
  const double other = balls.radius[to];
  const Vec2 r = nearest_image(start_.place(to) - start_.place(from), domain_);
  const Vec2 end = nearest_image(balls.at(to) - balls.at(from), domain_);
  IslandContact contact = ball_contact(r, nearest_image(end - r, domain_), radius + other);
  contact.a = a;
  contact.b = b;
  contact.friction = rule_.friction;
  contact.restitution = rule_.restitution;
  island.add_contact(contact, {std::min(radius, other), to, false});
}

}  // namespace carom::contact
