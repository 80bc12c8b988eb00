#include "solvers/event/tile.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "solvers/event/lanes.hpp"
#include "solvers/event/pair_lanes.hpp"

namespace carom::event {
namespace {

// Entries that a bucket of the agenda should hold: enough to fetch what they need ahead of time.
constexpr double kPerBucket = 24;

}  // namespace

Tile::Tile(Rules rules) : motion_(std::move(rules)) {}

void Tile::reset(const std::vector<Body>& bodies, Ticks now) {
  const auto n = static_cast<Index>(bodies.size());
  bodies_.assign(bodies.begin(), bodies.end());
  bool pegs = false;
  for (Body& body : bodies_) {
    body.meets = kNever;
    body.leaves = kNever;
    body.partner = kUnknown;
    if (motion_.fixed(body)) {
      body.start = kEver;
      pegs = true;
    }
  }
  left_.clear();
  if (pegs && motion_.falls()) left_.assign(n, kUnknown);
  instant_ = now;
  at_once_ = 0;
  start_agenda(now);
  if (motion_.rules().collisions) {
    neighbours_.reset(bodies_, now);
    for (Index i = 0; i < n; ++i) bodies_[i].leaves = neighbours_.leaving(bodies_[i], i, now);
  }
  for (Index i = 0; i < n; ++i) scan(i, now);
  for (Index i = 0; i < n; ++i) announce(i);
}

// A guess of how fast entries are due: it decides how long a bucket is, and no result.
void Tile::start_agenda(Ticks now) {
  const Domain& domain = motion_.rules().domain;
  const double area = (domain.upper[0] - domain.lower[0]) * (domain.upper[1] - domain.lower[1]);
  double square = 0;
  double diameter = 0;
  double covered = 0;
  for (const Body& body : bodies_) {
    const double radius = motion_.kind(body).radius;
    square += body.vx * body.vx + body.vy * body.vy;
    diameter += 2 * radius;
    covered += 3.14159 * radius * radius;
  }
  const auto n = static_cast<double>(std::max<std::size_t>(bodies_.size(), 1));
  const double gravity = std::hypot(motion_.rules().gravity[0], motion_.rules().gravity[1]);
  const double speed = std::sqrt(square / n + gravity * std::sqrt(area));
  const double packing = std::min(covered / area, 0.8);
  const double crowd = (1 - packing / 2) / ((1 - packing) * (1 - packing));
  const double across = n / area * (diameter / n) * crowd + 1 / std::sqrt(area);
  const double rate = 4 * n * speed * across;
  const TickScale& scale = motion_.rules().scale;
  const Ticks width = rate > 0 ? scale.ticks(kPerBucket / rate) : kLongestFlight;
  agenda_.reset(now, std::min(width, kLongestFlight / 64),
                std::clamp<std::size_t>(bodies_.size() / 16, 16, 4096));
}

template <bool kFalls>
void Tile::look_at(Index i, const Index* others, std::uint32_t count, Ticks now,
                   Meeting& best) const {
  const Body& me = bodies_[i];
  const Rules& rules = motion_.rules();
  const Lanes zero{};
  const WholeLanes none{};
  const double my_radius = motion_.kind(me).radius;
  const auto row_of = [](const Body& body) { return Lanes{body.x, body.y, body.vx, body.vy}; };
  const auto kind_of = [&](const Body* body) { return motion_.kind(*body); };
  for (std::uint32_t from = 0; from < count; from += kLanes) {
    // A lane without a ball holds the ball itself, which it does not approach.
    const Body* body[kLanes];
    for (std::uint32_t l = 0; l < kLanes; ++l) {
      body[l] = &bodies_[from + l < count ? others[from + l] : i];
    }
    Lanes x = row_of(*body[0]);
    Lanes y = row_of(*body[1]);
    Lanes vx = row_of(*body[2]);
    Lanes vy = row_of(*body[3]);
    transpose(x, y, vx, vy);
    const WholeLanes start{body[0]->start, body[1]->start, body[2]->start, body[3]->start};
    const WholeLanes meets{body[0]->meets, body[1]->meets, body[2]->meets, body[3]->meets};

    // Both as they are at the later of the two starts: only the earlier flight has moved by then.
    const WholeLanes since = me.start - start;
    const WholeLanes mine = since > none;
    const WholeLanes later = mine ? none + me.start : start;
    const Lanes elapsed =
        __builtin_convertvector(mine ? since : -since, Lanes) * rules.scale.tick();
    Lanes dx = x - me.x;
    Lanes dy = y - me.y;
    Lanes dvx = vx - me.vx;
    Lanes dvy = vy - me.vy;
    if constexpr (kFalls) {
      const Lanes gx = zero + rules.gravity[0];
      const Lanes gy = zero + rules.gravity[1];
      const Lanes half = elapsed / 2;
      const Lanes sx = fused(gx, half, mine ? vx : zero + me.vx) * elapsed;
      const Lanes sy = fused(gy, half, mine ? vy : zero + me.vy) * elapsed;
      dx = mine ? dx + sx : dx - sx;
      dy = mine ? dy + sy : dy - sy;
      dvx = mine ? dvx + gx * elapsed : dvx - gx * elapsed;
      dvy = mine ? dvy + gy * elapsed : dvy - gy * elapsed;
    } else {
      dx = fused(mine ? vx : zero - me.vx, elapsed, dx);
      dy = fused(mine ? vy : zero - me.vy, elapsed, dy);
    }
    dx = nearest(dx, zero + motion_.periods()[0], zero + motion_.periods()[0] / 2);
    dy = nearest(dy, zero + motion_.periods()[1], zero + motion_.periods()[1] / 2);
    Lanes reach = zero + 2 * my_radius;
    if (!motion_.one_kind()) {
      reach = my_radius + Lanes{kind_of(body[0]).radius, kind_of(body[1]).radius,
                                kind_of(body[2]).radius, kind_of(body[3]).radius};
    }
    const Lanes wait = pair_times(dx, dy, dvx, dvy, reach) * rules.scale.per_second();
    const Lanes longest = zero + static_cast<double>(kLongestFlight);
    WholeLanes at = later + __builtin_convertvector(wait < longest ? wait : zero, WholeLanes);
    at = at > now ? at : none + now;
    at = at < meets ? at : none + kNever;
    at = wait < longest ? at : none + kNever;
    for (std::uint32_t l = 0; l < kLanes; ++l) {
      if (at[l] < best.time) best = {at[l], others[from + l]};
    }
  }
}

void Tile::look_at(Index i, const Index* others, std::uint32_t count, Ticks now,
                   Meeting& best) const {
  if (!left_.empty()) {
    // Fixed balls are not met on a straight way: they are looked at one by one.
    for (std::uint32_t n = 0; n < count; ++n) {
      if (motion_.fixed(bodies_[others[n]])) {
        look_at_pegs(i, others + n, 1, best);
      } else {
        look_at<true>(i, others + n, 1, now, best);
      }
    }
  } else if (motion_.falls()) {
    look_at<true>(i, others, count, now, best);
  } else {
    look_at<false>(i, others, count, now, best);
  }
}

void Tile::look_at_pegs(Index i, const Index* others, std::uint32_t count, Meeting& best) const {
  for (std::uint32_t n = 0; n < count; ++n) {
    const Ticks at = motion_.pair_meets(bodies_[i], bodies_[others[n]], left_[i] == others[n]);
    if (at < best.time) best = {at, others[n]};
  }
}

// Finds what the ball meets before `meets`, which is no more than a time it is free until.
void Tile::scan(Index i, Ticks now) {
  const Body& me = bodies_[i];
  if (motion_.fixed(me)) return;
  ++counts_.scans;
  Meeting best{me.meets, kUnknown};
  if (motion_.rules().collisions) {
    const Neighbours::Lists& lists = neighbours_.lists();
    for (const auto* node = &lists.first(i);; node = &lists.after(*node)) {
      look_at(i, node->item, node->count, now, best);
      if (node->next == 0) break;
    }
  }
  const Meeting alone = motion_.alone(me);
  if (alone.time < best.time) best = alone;
  best.time = std::max(best.time, now);
  link(i, best);
}

// A fixed ball waits for nobody: it can be the partner of many.
void Tile::link(Index i, const Meeting& best) {
  if (best.partner == kUnknown) return;
  unlink(i);
  bodies_[i].meets = best.time;
  bodies_[i].partner = best.partner;
  if (best.partner >= kFirstMark || motion_.fixed(bodies_[best.partner])) return;
  unlink(best.partner);
  bodies_[best.partner].meets = best.time;
  bodies_[best.partner].partner = i;
}

void Tile::unlink(Index i) {
  const Index j = bodies_[i].partner;
  bodies_[i].partner = kUnknown;
  if (j < kFirstMark && bodies_[j].partner == i) {
    bodies_[j].partner = kUnknown;
    announce(j);
  }
}

void Tile::forget(Index i) {
  bodies_[i].meets = kNever;
  bodies_[i].partner = kUnknown;
}

void Tile::watch(Ticks now) {
  if (now != instant_) {
    instant_ = now;
    at_once_ = 0;
  }
  if (++at_once_ > 1000 + 100 * bodies_.size()) {
    throw std::runtime_error("impacts follow each other without end at one instant");
  }
}

void Tile::meet_ball(Index i, Index j, Ticks now) {
  counts_.max_overlap = std::max(counts_.max_overlap, motion_.strike(bodies_[i], bodies_[j], now));
  ++counts_.ball_ball;
  if (!left_.empty()) {
    left_[i] = motion_.fixed(bodies_[j]) ? j : kUnknown;
    left_[j] = kUnknown;
  }
  if (motion_.fixed(bodies_[j])) return;
  forget(j);
  bodies_[j].leaves = neighbours_.leaving(bodies_[j], j, now);
  scan(j, now);
  announce(j);
}

void Tile::meet(Index i, Ticks now) {
  const Index partner = bodies_[i].partner;
  forget(i);
  if (partner == kUnknown) {
    ++counts_.vain;
  } else {
    if (partner < kFirstMark) {
      watch(now);
      if (!motion_.fixed(bodies_[partner])) forget(partner);
      meet_ball(i, partner, now);
    } else {
      if (!left_.empty()) left_[i] = kUnknown;
      if (partner == kCarry) {
        motion_.carry(bodies_[i], now);
      } else {
        watch(now);
        motion_.bounce(bodies_[i], partner, now);
        ++counts_.ball_wall;
      }
    }
    if (motion_.rules().collisions) {
      bodies_[i].leaves = neighbours_.leaving(bodies_[i], i, now);
    }
  }
  scan(i, now);
  announce(i);
}

void Tile::next_event(Index i, Ticks now) {
  if (bodies_[i].meets <= bodies_[i].leaves) {
    meet(i, now);
    return;
  }
  ++counts_.renewals;
  const std::vector<Index>& fresh = neighbours_.renew(bodies_, i, now);
  Meeting best{bodies_[i].meets, kUnknown};
  look_at(i, fresh.data(), static_cast<std::uint32_t>(fresh.size()), now, best);
  bodies_[i].leaves = neighbours_.leaving(bodies_[i], i, now);
  link(i, best);
  announce(i);
}

void Tile::advance_to(Ticks until) {
  const auto wanted = [this](const Agenda::Entry& entry) {
    return bodies_[entry.ball].due() == entry.time;
  };
  const auto prepare = [this](std::span<const Agenda::Entry> entries,
                              std::span<const Agenda::Entry> after) { fetch(entries, after); };
  while (const Agenda::Entry* next = agenda_.first(until, wanted, prepare)) {
    const Agenda::Entry entry = *next;
    agenda_.drop_first();
    if (wanted(entry)) next_event(entry.ball, entry.time);
  }
}

// Asks for the memory that the events of a bucket will look at, in the order in which one needs the
// other, so that a hundred fetches run at once instead of one after the other.
void Tile::fetch(std::span<const Agenda::Entry> entries,
                 std::span<const Agenda::Entry> after) const {
  constexpr std::size_t kInCache = 4000;
  if (bodies_.size() < kInCache || !motion_.rules().collisions) return;
  for (const Agenda::Entry& entry : after) {
    __builtin_prefetch(&bodies_[entry.ball]);
    neighbours_.fetch(entry.ball);
  }
  const auto meets_ball = [](const Body& body, const Agenda::Entry& entry) {
    return body.partner < kFirstMark && body.meets == entry.time;
  };
  for (const Agenda::Entry& entry : entries) {
    const Body& body = bodies_[entry.ball];
    if (!meets_ball(body, entry)) continue;
    __builtin_prefetch(&bodies_[body.partner]);
    neighbours_.fetch(body.partner);
  }
  const auto fetch_listed = [this](Index i) {
    const auto& node = neighbours_.lists().first(i);
    for (std::uint32_t n = 0; n < node.count; ++n) __builtin_prefetch(&bodies_[node.item[n]]);
  };
  for (const Agenda::Entry& entry : entries) {
    const Body& body = bodies_[entry.ball];
    fetch_listed(entry.ball);
    if (meets_ball(body, entry)) fetch_listed(body.partner);
    if (body.leaves == entry.time) neighbours_.fetch_around(entry.ball);
  }
}

void Tile::rebase(Ticks by) {
  for (Body& body : bodies_) {
    if (body.start != kEver) body.start -= by;
    if (body.meets != kNever) body.meets -= by;
    if (body.leaves != kNever) body.leaves -= by;
  }
  instant_ -= by;
  agenda_.rebase(by);
}

std::size_t Tile::bytes() const {
  return bodies_.capacity() * sizeof(Body) + neighbours_.bytes() + agenda_.bytes() +
         left_.capacity() * sizeof(Index);
}

}  // namespace carom::event
