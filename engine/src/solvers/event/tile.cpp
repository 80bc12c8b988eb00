#include "solvers/event/tile.hpp"

#include <algorithm>
#include <cmath>
#include <set>
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

void Tile::reset(const std::vector<Disk>& disks, Ticks now, const std::vector<Index>& left) {
  const auto n = static_cast<Index>(disks.size());
  disks_.assign(disks.begin(), disks.end());
  bool pegs = false;
  for (Disk& disk : disks_) {
    disk.meets = kNever;
    disk.leaves = kNever;
    disk.partner = kUnknown;
    if (motion_.fixed(disk)) {
      disk.start = kEver;
      pegs = true;
    }
  }
  left_.clear();
  if (pegs && motion_.falls()) {
    left_ = left;
    left_.resize(n, kUnknown);
  }
  ties_.clear();
  instant_ = now;
  at_once_ = 0;
  start_agenda(now);
  if (motion_.rules().collisions) {
    neighbours_.reset(disks_, now);
    for (Index i = 0; i < n; ++i) disks_[i].leaves = neighbours_.leaving(disks_[i], i, now);
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
  for (const Disk& disk : disks_) {
    const double radius = motion_.kind(disk).radius;
    square += disk.vx * disk.vx + disk.vy * disk.vy;
    diameter += 2 * radius;
    covered += 3.14159 * radius * radius;
  }
  const auto n = static_cast<double>(std::max<std::size_t>(disks_.size(), 1));
  const double gravity = std::hypot(motion_.rules().gravity[0], motion_.rules().gravity[1]);
  const double speed = std::sqrt(square / n + gravity * std::sqrt(area));
  const double packing = std::min(covered / area, 0.8);
  const double crowd = (1 - packing / 2) / ((1 - packing) * (1 - packing));
  const double across = n / area * (diameter / n) * crowd + 1 / std::sqrt(area);
  const double rate = 4 * n * speed * across;
  const TickScale& scale = motion_.rules().scale;
  const Ticks width = rate > 0 ? scale.ticks(kPerBucket / rate) : kLongestFlight;
  agenda_.reset(now, width, std::clamp<std::size_t>(disks_.size() / 16, 16, 4096));
}

template <bool kFalls>
void Tile::look_at(Index i, const Index* others, std::uint32_t count, Ticks now,
                   Meeting& best) const {
  const Disk& me = disks_[i];
  const Rules& rules = motion_.rules();
  const Lanes zero{};
  const WholeLanes none{};
  const double my_radius = motion_.kind(me).radius;
  const auto row_of = [](const Disk& disk) { return Lanes{disk.x, disk.y, disk.vx, disk.vy}; };
  const auto kind_of = [&](const Disk* disk) { return motion_.kind(*disk); };
  for (std::uint32_t from = 0; from < count; from += kLanes) {
    // A lane without a ball holds the ball itself, which it does not approach.
    const Disk* disk[kLanes];
    for (std::uint32_t l = 0; l < kLanes; ++l) {
      disk[l] = &disks_[from + l < count ? others[from + l] : i];
    }
    Lanes x = row_of(*disk[0]);
    Lanes y = row_of(*disk[1]);
    Lanes vx = row_of(*disk[2]);
    Lanes vy = row_of(*disk[3]);
    transpose(x, y, vx, vy);
    const WholeLanes start{disk[0]->start, disk[1]->start, disk[2]->start, disk[3]->start};
    const WholeLanes meets{disk[0]->meets, disk[1]->meets, disk[2]->meets, disk[3]->meets};

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
      reach = my_radius + Lanes{kind_of(disk[0]).radius, kind_of(disk[1]).radius,
                                kind_of(disk[2]).radius, kind_of(disk[3]).radius};
    }
    const Lanes wait = pair_times(dx, dy, dvx, dvy, reach) * rules.scale.per_second();
    const Lanes longest = zero + static_cast<double>(kLongestFlight);
    WholeLanes at = later + __builtin_convertvector(wait < longest ? wait : zero, WholeLanes);
    at = at > now ? at : none + now;
    at = wait < longest ? at : none + kNever;
    const WholeLanes tie = (at == meets) & (at < kNever);
    if ((tie[0] | tie[1] | tie[2] | tie[3]) != 0) {
      for (std::uint32_t l = 0; l < kLanes; ++l) {
        if (tie[l] != 0 && disk[l]->partner != i) note_tie(at[l]);
      }
    }
    at = at < meets ? at : none + kNever;
    for (std::uint32_t l = 0; l < kLanes; ++l) {
      if (at[l] > best.time) continue;
      if (at[l] < best.time) {
        best = {at[l], others[from + l]};
      } else if (at[l] != kNever) {
        note_tie(at[l]);
      }
    }
  }
}

void Tile::look_at(Index i, const Index* others, std::uint32_t count, Ticks now,
                   Meeting& best) const {
  if (!left_.empty()) {
    // Fixed balls are not met on a straight way: they are looked at one by one.
    for (std::uint32_t n = 0; n < count; ++n) {
      if (motion_.fixed(disks_[others[n]])) {
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
    const Ticks at = motion_.pair_meets(disks_[i], disks_[others[n]], left_[i] == others[n]);
    if (at == best.time && at != kNever) note_tie(at);
    if (at < best.time) best = {at, others[n]};
  }
}

// Finds what the ball meets before `meets`, which is no more than a time it is free until.
void Tile::scan(Index i, Ticks now) {
  const Disk& me = disks_[i];
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
  if (alone.time == best.time && alone.partner != kCarry) note_tie(alone.time);
  if (alone.time < best.time) best = alone;
  best.time = std::max(best.time, now);
  link(i, best);
}

// A fixed ball waits for nobody: it can be the partner of many.
void Tile::link(Index i, const Meeting& best) {
  if (best.partner == kUnknown) return;
  unlink(i);
  disks_[i].meets = best.time;
  disks_[i].partner = best.partner;
  if (best.partner >= kFirstMark || motion_.fixed(disks_[best.partner])) return;
  unlink(best.partner);
  disks_[best.partner].meets = best.time;
  disks_[best.partner].partner = i;
}

void Tile::unlink(Index i) {
  const Index j = disks_[i].partner;
  disks_[i].partner = kUnknown;
  if (j < kFirstMark && disks_[j].partner == i) {
    disks_[j].partner = kUnknown;
    announce(j);
  }
}

void Tile::forget(Index i) {
  disks_[i].meets = kNever;
  disks_[i].partner = kUnknown;
}

void Tile::watch(Ticks now) {
  if (now != instant_) {
    instant_ = now;
    at_once_ = 0;
  }
  if (++at_once_ > 1000 + 100 * disks_.size()) {
    throw std::runtime_error("impacts follow each other without end at one instant");
  }
}

// After a new flight has begun.
void Tile::look_again(Index i, Ticks now) {
  if (motion_.fixed(disks_[i])) return;
  if (motion_.rules().collisions) disks_[i].leaves = neighbours_.leaving(disks_[i], i, now);
  scan(i, now);
  announce(i);
}

void Tile::meet_alone(Index i, Index partner, Ticks now) {
  if (partner >= kWalls) {
    motion_.bounce(disks_[i], partner, now);
    ++counts_.ball_wall;
    if (!left_.empty()) left_[i] = kUnknown;
    return;
  }
  counts_.max_overlap =
      std::max(counts_.max_overlap, motion_.strike(disks_[i], disks_[partner], now));
  ++counts_.ball_ball;
  if (!left_.empty()) {
    left_[i] = motion_.fixed(disks_[partner]) ? partner : kUnknown;
    left_[partner] = kUnknown;
  }
}

void Tile::meet(Index i, Ticks now) {
  const Index partner = disks_[i].partner;
  forget(i);
  if (partner == kUnknown) {
    ++counts_.vain;
    scan(i, now);
    announce(i);
    return;
  }
  if (partner == kCarry) {
    if (!left_.empty()) left_[i] = kUnknown;
    motion_.carry(disks_[i], now);
    look_again(i, now);
    return;
  }
  watch(now);
  const bool ball = partner < kFirstMark && !motion_.fixed(disks_[partner]);
  if (ball) forget(partner);
  if (tied(now)) {
    meet_jointly(i, partner, now);
    return;
  }
  const Disk before = disks_[i];
  const Disk partner_before = ball ? disks_[partner] : Disk{};
  const Counts counts = counts_;
  const Index left = left_.empty() ? kUnknown : left_[i];
  const Index partner_left = left_.empty() || !ball ? kUnknown : left_[partner];
  meet_alone(i, partner, now);
  if (ball) look_again(partner, now);
  look_again(i, now);
  if (disks_[i].meets != now && !(ball && disks_[partner].meets == now)) return;
  // The blow is passed on at once: take it back, and resolve all that touches together.
  counts_ = counts;
  const auto take_back = [this](Index k, const Disk& flight) {
    unlink(k);
    const Ticks leaves = disks_[k].leaves;
    disks_[k] = flight;
    disks_[k].leaves = leaves;
    forget(k);
  };
  take_back(i, before);
  if (ball) take_back(partner, partner_before);
  if (!left_.empty()) {
    left_[i] = left;
    if (ball) left_[partner] = partner_left;
  }
  meet_jointly(i, partner, now);
}

void Tile::next_event(Index i, Ticks now) {
  if (disks_[i].meets <= disks_[i].leaves) {
    meet(i, now);
    return;
  }
  ++counts_.renewals;
  const std::vector<Index>& fresh = neighbours_.renew(disks_, i, now);
  Meeting best{disks_[i].meets, kUnknown};
  look_at(i, fresh.data(), static_cast<std::uint32_t>(fresh.size()), now, best);
  disks_[i].leaves = neighbours_.leaving(disks_[i], i, now);
  link(i, best);
  announce(i);
}

void Tile::advance_to(Ticks until) {
  const auto wanted = [this](const Agenda::Entry& entry) {
    return disks_[entry.ball].due() == entry.time;
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
  if (disks_.size() < kInCache || !motion_.rules().collisions) return;
  for (const Agenda::Entry& entry : after) {
    __builtin_prefetch(&disks_[entry.ball]);
    neighbours_.fetch(entry.ball);
  }
  const auto meets_ball = [](const Disk& disk, const Agenda::Entry& entry) {
    return disk.partner < kFirstMark && disk.meets == entry.time;
  };
  for (const Agenda::Entry& entry : entries) {
    const Disk& disk = disks_[entry.ball];
    if (!meets_ball(disk, entry)) continue;
    __builtin_prefetch(&disks_[disk.partner]);
    neighbours_.fetch(disk.partner);
  }
  const auto fetch_listed = [this](Index i) {
    const auto& node = neighbours_.lists().first(i);
    for (std::uint32_t n = 0; n < node.count; ++n) __builtin_prefetch(&disks_[node.item[n]]);
  };
  for (const Agenda::Entry& entry : entries) {
    const Disk& disk = disks_[entry.ball];
    fetch_listed(entry.ball);
    if (meets_ball(disk, entry)) fetch_listed(disk.partner);
    if (disk.leaves == entry.time) neighbours_.fetch_around(entry.ball);
  }
}

void Tile::rebase(Ticks by) {
  for (Disk& disk : disks_) {
    if (disk.start != kEver) disk.start -= by;
    if (disk.meets != kNever) disk.meets -= by;
    if (disk.leaves != kNever) disk.leaves -= by;
  }
  instant_ = instant_ >= by ? instant_ - by : -1;
  std::set<Ticks> ties;
  for (auto at = ties_.lower_bound(by); at != ties_.end(); ++at) ties.insert(*at - by);
  ties_ = std::move(ties);
  agenda_.rebase(by);
}

std::size_t Tile::bytes() const {
  return disks_.capacity() * sizeof(Disk) + neighbours_.bytes() + agenda_.bytes() +
         left_.capacity() * sizeof(Index);
}

}  // namespace carom::event
