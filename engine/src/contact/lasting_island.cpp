#include "contact/lasting_island.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <numeric>
#include <optional>
#include <utility>

namespace carom::contact {
namespace {

using Order = std::vector<std::uint32_t>;

// Frames in which the acceleration points down, and to the right if it leans: one or two, or all
// eight where there is none.
std::vector<Frame> frames_of(const Vec2& acceleration) {
  const double across = std::abs(acceleration.x());
  const double along = std::abs(acceleration.y());
  std::vector<Frame> frames;
  const auto add = [&](bool swaps) {
    Frame frame;
    frame.swaps = swaps;
    const Vec2 turned = frame.into(acceleration);
    frame.sign = {turned.x() < 0 ? -1.0 : 1.0, turned.y() > 0 ? -1.0 : 1.0};
    frames.push_back(frame);
    if (turned.x() == 0) frames.push_back({swaps, {-1, frame.sign.y()}});
    if (turned.y() == 0) {
      frames.push_back({swaps, {1, -1}});
      frames.push_back({swaps, {-1, -1}});
    }
  };
  add(across > along);
  if (across == along) add(true);
  return frames;
}

std::partial_ordering compare(const Vec2& a, const Vec2& b) {
  const auto high = a.y() <=> b.y();
  return std::is_neq(high) ? high : a.x() <=> b.x();
}

Order order_of(const std::vector<LastingIsland::Member>& members, const Frame& frame) {
  std::vector<Vec2> places;
  places.reserve(members.size());
  for (const auto& member : members) places.push_back(frame.into(member.start));
  Order order(members.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto which = compare(places[a], places[b]);
    return std::is_neq(which) ? std::is_lt(which) : members[a].ball < members[b].ball;
  });
  return order;
}

std::partial_ordering compare(const std::vector<LastingIsland::Member>& members, const Frame& frame,
                              const Order& order, const Frame& other, const Order& other_order) {
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Vec2 a = frame.into(members[order[k]].start);
    const Vec2 b = other.into(members[other_order[k]].start);
    const auto which = compare(a, b);
    if (std::is_neq(which)) return which;
  }
  return std::partial_ordering::equivalent;
}

void arrange(LastingIsland& island, const Frame& frame, const Order& order, double step) {
  island.frame = frame;
  std::vector<LastingIsland::Member> members;
  members.reserve(order.size());
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    members.push_back(island.members[order[k]]);
    place[order[k]] = static_cast<int>(k);
    const LastingIsland::Member& member = members.back();
    IslandBody body;
    body.inverse_mass = member.inverse_mass;
    body.before = frame.into(member.before);
    body.free = frame.into(member.flown_velocity + member.pulled);
    body.pull = frame.into(member.pull);
    body.free_mean = frame.into(member.flight) / step;
    body.turning = frame.turn() * member.spin * member.radius;
    island.bodies.push_back(body);
  }
  island.members.swap(members);

  std::vector<std::pair<IslandContact, LastingIsland::Source>> contacts;
  contacts.reserve(island.contacts.size());
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    IslandContact contact = island.contacts[k];
    LastingIsland::Source source = island.sources[k];
    contact.normal = frame.into(contact.normal);
    contact.a = place[static_cast<std::size_t>(contact.a)];
    if (contact.b >= 0) contact.b = place[static_cast<std::size_t>(contact.b)];
    if (contact.b >= 0 && contact.b < contact.a) {
      std::swap(contact.a, contact.b);
      contact.normal = -contact.normal;
      source.other = island.members[static_cast<std::size_t>(contact.b)].ball;
    }
    contacts.emplace_back(contact, source);
  }
  std::sort(contacts.begin(), contacts.end(), [](const auto& one, const auto& two) {
    const IslandContact& c = one.first;
    const IslandContact& d = two.first;
    if (c.a != d.a) return c.a < d.a;
    if (c.b != d.b) return c.b < d.b;
    const auto which = compare(c.normal, d.normal);
    if (std::is_neq(which)) return std::is_lt(which);
    return c.gap != d.gap ? c.gap < d.gap : one.second.other < two.second.other;
  });
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    island.contacts[k] = contacts[k].first;
    island.sources[k] = contacts[k].second;
  }
}

// All that a solution depends on, and at last the numbers of the balls: an island that is its own
// mirror image turns its balls as a mirrored scene does.
std::vector<double> signature(const LastingIsland& island) {
  std::vector<double> values;
  const auto add = [&](const Vec2& v) { values.insert(values.end(), {v.x(), v.y()}); };
  for (const IslandBody& body : island.bodies) {
    add(body.before);
    add(body.free);
    add(body.free_mean);
    values.insert(values.end(), {body.turning, body.inverse_mass});
  }
  for (const IslandContact& contact : island.contacts) {
    add(contact.normal);
    values.insert(values.end(), {static_cast<double>(contact.a), static_cast<double>(contact.b),
                                 contact.gap, contact.friction});
  }
  for (const auto& member : island.members) values.push_back(member.ball);
  return values;
}

}  // namespace

void LastingIsland::lay_out(const Vec2& acceleration, double step) {
  // Those of its mirror images whose places come first; nearly always it is one.
  std::vector<std::pair<Frame, Order>> first;
  for (const Frame& one : frames_of(acceleration)) {
    Order order = order_of(members, one);
    if (!first.empty()) {
      const auto which = compare(members, one, order, first.front().first, first.front().second);
      if (std::is_gt(which)) continue;
      if (std::is_lt(which)) first.clear();
    }
    first.emplace_back(one, std::move(order));
  }
  std::optional<LastingIsland> image;
  for (std::size_t k = 1; k < first.size(); ++k) {
    LastingIsland other = *this;
    arrange(other, first[k].first, first[k].second, step);
    if (image && !(signature(other) < signature(*image))) continue;
    image = std::move(other);
  }
  arrange(*this, first.front().first, first.front().second, step);
  if (image && signature(*image) < signature(*this)) *this = std::move(*image);
}

void LastingIsland::turn_back(IslandOutcome& outcome) const {
  for (Vec2& v : outcome.after) v = frame.out(v);
  for (Vec2& v : outcome.mean) v = frame.out(v);
  for (double& turning : outcome.turning) turning *= frame.turn();
  for (double& along : outcome.along) along *= frame.turn();
}

}  // namespace carom::contact
