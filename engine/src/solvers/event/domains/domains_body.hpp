#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/event/domains/domains.hpp"
#include "state/stopwatch.hpp"

namespace carom::event {

// So many collisions a ball are a window.
inline constexpr double kCollisionsOfWindow = 2;
// A domain has about so many balls; below the second number and with one worker there is one.
inline constexpr double kBallsOfDomain = 4000;
inline constexpr std::size_t kBallsOfOneDomain = 20000;
inline constexpr double kWiderAgain = 1.4;
// Of several domains, whose halos it makes wide: how far the fastest ball may go, in spacings.
inline constexpr double kFarthest = 1.4;
// The skin of lists, by the mean diameter and the gap between neighbours.
inline constexpr double kSkinOfDiameter = 0.3;
inline constexpr double kSkinOfGap = 0.7;
inline constexpr double kFirstPyramid = 4;
// Of a window: the rate of drag times its length.
inline constexpr double kMostDrag = 0.1;
// No more share the sorting of flights.
inline constexpr std::size_t kMostSorters = 16;
// Windows solved by a tile count so much more than others; with so many, domains do not pay.
inline constexpr std::uint32_t kOddWindow = 8;
inline constexpr std::uint32_t kTooManyOdd = 64;

template <class P>
Domains<P>::Domains(const BasicRules<double>& rules)
    : motion_(std::make_shared<const Motion<P>>(rules)) {}

template <class P>
void Domains<P>::reset(const std::vector<Disk>& flights, Ticks now,
                       const std::vector<double>& spins) {
  const std::size_t n = flights.size();
  next_.resize(n);
  movers_ = 0;
  for (std::size_t i = 0; i < n; ++i) {
    next_[i] = BlockFlight::of(flights[i], static_cast<Index>(i));
    if (motion_->fixed(flights[i])) {
      next_[i].start = kEver;
    } else {
      ++movers_;
    }
  }
  next_spins_ = spins;
  memory_.clear();
  from_ = now_ = until_ = target_ = now;
  const carom::Domain& box = motion_->rules().domain;
  const double area = (box.upper[0] - box.lower[0]) * (box.upper[1] - box.lower[1]);
  spacing_ = std::sqrt(area / static_cast<double>(std::max<std::size_t>(n, 1)));
  choose_radii(flights);
  guess_window(flights);
  pyramid_ = kFirstPyramid;
  decompose();
  limit_window();
}

// All but the largest few balls are normal.
template <class P>
void Domains<P>::choose_radii(const std::vector<Disk>& flights) {
  const auto& kinds = motion_->rules().kinds;
  std::vector<std::size_t> count(kinds.size(), 0);
  double diameters = 0;
  for (const Disk& disk : flights) {
    ++count[disk.kind % kinds.size()];
    diameters += 2 * kinds[disk.kind % kinds.size()].radius;
  }
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (count[k] > 0) order.push_back(k);
  }
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return kinds[a].radius > kinds[b].radius; });
  std::size_t few = std::max<std::size_t>(64, flights.size() / 100);
  normal_radius_ = 0;
  const double mean = diameters / static_cast<double>(std::max<std::size_t>(flights.size(), 1));
  for (const std::size_t k : order) {
    normal_radius_ = kinds[k].radius;
    // They take no room worth a list of their own.
    if (count[k] > few || kinds[k].radius < mean) break;
    few -= count[k];
  }
  skin_ = kSkinOfDiameter * mean + kSkinOfGap * std::max(spacing_ - mean, 0.0);
  // Of two that are listed no image but the nearest may come near.
  for (const double period : motion_->rules().domain.period) {
    if (period > 0) skin_ = std::min(skin_, period / 8 - motion_->largest_radius() / 2);
  }
}

// Of equal disks by Enskog; the first window tells better.
template <class P>
void Domains<P>::guess_window(const std::vector<Disk>& flights) {
  double square = 0;
  double fastest = 0;
  double diameters = 0;
  double covered = 0;
  for (const Disk& disk : flights) {
    const double v = disk.vx * disk.vx + disk.vy * disk.vy;
    const double r = motion_->kind(disk).radius;
    square += v;
    fastest = std::max(fastest, v);
    diameters += 2 * r;
    covered += 3.14159 * r * r;
  }
  const auto& rules = motion_->rules();
  const auto n = static_cast<double>(std::max<std::size_t>(movers_, 1));
  const double gravity = std::hypot(rules.gravity[0], rules.gravity[1]);
  const double speed = std::sqrt(square / n + gravity * spacing_);
  const double packing = std::min(covered / (spacing_ * spacing_ * n), 0.8);
  const double crowd = (1 - packing / 2) / ((1 - packing) * (1 - packing));
  const double rate = 3 * speed * (diameters / n) / (spacing_ * spacing_) * crowd;
  const Ticks most = kLongestFlight / 64;
  window_ = rate > 0 ? rules.scale.ticks(kCollisionsOfWindow / rate) : most;
  if (rules.drag_rate > 0) {
    longest_ = rules.scale.ticks(kMostDrag / rules.drag_rate);
  } else {
    longest_ = most;
  }
  longest_ = std::min(std::clamp<Ticks>(longest_, 64, most), wanted_longest_);
  window_ = std::min(window_, longest_);
  speed_ = std::sqrt(fastest) + gravity * rules.scale.seconds(window_);
}

template <class P>
void Domains<P>::decompose() {
  const std::size_t n = next_.size();
  const carom::Domain& box = motion_->rules().domain;
  std::size_t wanted = 1;
  if (n >= kBallsOfOneDomain) {
    wanted = static_cast<std::size_t>(static_cast<double>(n) / kBallsOfDomain);
  }
  wanted = std::max(wanted, workers_);
  regions_.clear();
  to_solve_.clear();
  if (wanted == 1) {
    regions_.resize(1);
    return;
  }
  blocks_ = std::make_unique<Blocks>(box, n);
  const double width = box.upper[0] - box.lower[0];
  const double height = box.upper[1] - box.lower[1];
  const double across = std::sqrt(static_cast<double>(wanted) * width / height);
  const int columns = std::clamp(static_cast<int>(std::lround(across)), 1,
                                 std::min(blocks_->count(0), static_cast<int>(wanted)));
  const int rows = std::clamp(static_cast<int>((wanted + static_cast<std::size_t>(columns) - 1) /
                                               static_cast<std::size_t>(columns)),
                              1, blocks_->count(1));
  const auto cut = [](int count, int k, int parts) {
    return static_cast<int>(static_cast<std::int64_t>(count) * k / parts);
  };
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      Region region;
      region.blocks.first = {cut(blocks_->count(0), x, columns), cut(blocks_->count(1), y, rows)};
      region.blocks.size = {cut(blocks_->count(0), x + 1, columns) - region.blocks.first[0],
                            cut(blocks_->count(1), y + 1, rows) - region.blocks.first[1]};
      regions_.push_back(std::move(region));
    }
  }
}

template <class P>
void Domains<P>::set_workers(std::size_t workers) {
  if (workers == workers_) return;
  if (open_) close_window();
  workers_ = workers;
  desks_.resize(workers);
  decompose();
}

template <class P>
std::size_t Domains<P>::aim(Ticks until) {
  target_ = until;
  if (!(now_ < target_)) return Phase::kFrameDone;
  return open_ ? std::size_t{kSolve} : begin_window();
}

template <class P>
std::size_t Domains<P>::begin_window() {
  memory_.clear();
  from_ = now_;
  by_tile_ = false;
  // One domain alone may look beyond the aim.
  full_ = alone() || window_ <= target_ - now_;
  until_ = full_ ? now_ + window_ : target_;
  to_solve_.resize(regions_.size());
  for (std::size_t k = 0; k < regions_.size(); ++k) to_solve_[k] = k;
  taken_ = 0;
  outcomes_.resize(alone() ? 0 : next_.size());
  block_of_.resize(alone() ? 0 : next_.size());
  flights_.resize(next_.size());
  spins_.resize(next_spins_.size());
  if (alone()) {
    flights_.swap(next_);
    spins_.swap(next_spins_);
    next_.resize(flights_.size());
    next_spins_.resize(spins_.size());
    return kSolve;
  }
  counted_ = false;
  return kSort;
}

template <class P>
void Domains<P>::work(std::size_t phase, Share share) {
  Desk& desk = desks_[share.index];
  if (phase == kSort) {
    if (share.index >= kMostSorters) return;
    const Stopwatch stopwatch(true, desk.seconds);
    share.count = std::min(share.count, kMostSorters);
    if (counted_) {
      scatter(share);
    } else {
      count_blocks(share);
    }
    return;
  }
  const Stopwatch stopwatch(true, desk.seconds);
  if (by_tile_) {
    if (share.index == 0) solve_by_tile();
  } else if (alone()) {
    if (share.index == 0) solve_alone(desk);
  } else if (phase == kSolve) {
    for (std::size_t k = taken_++; k < to_solve_.size(); k = taken_++) {
      solve(regions_[to_solve_[k]], desk);
    }
  } else {
    for (std::size_t k = share.index; k < regions_.size(); k += share.count) check(regions_[k]);
  }
}

template <class P>
std::size_t Domains<P>::finish(std::size_t phase) {
  if (phase == kSort) {
    if (counted_) {
      find_large();
      return kSolve;
    }
    place_blocks();
    counted_ = true;
    return kSort;
  }
  if (by_tile_) {
    by_tile_ = false;
    return end_window();
  }
  if (phase == kCheck) return judge();
  bool unusual = false;
  for (const std::size_t k : to_solve_) unusual = unusual || regions_[k].unusual;
  if (unusual) {
    by_tile_ = true;
    open_ = false;
    until_ = std::min(until_, target_);
    odd_windows_ += kOddWindow;
    return kSolve;
  }
  if (!alone()) return kCheck;
  now_ = std::min(until_, target_);
  if (now_ < until_) return Phase::kFrameDone;
  close_window();
  return end_window();
}

template <class P>
std::size_t Domains<P>::end_window() {
  now_ = until_;
  ++windows_;
  if (odd_windows_ > kTooManyOdd) stuck_ = true;
  if (odd_windows_ > 0) --odd_windows_;
  return now_ < target_ && !stuck_ ? begin_window() : Phase::kFrameDone;
}

template <class P>
void Domains<P>::solve_alone(Desk& desk) {
  Region& region = regions_[0];
  if (!desk.domain) desk.domain = std::make_unique<DomainLoop<P>>(*motion_, normal_radius_);
  DomainLoop<P>& domain = *desk.domain;
  if (!open_) {
    DomainWindow window = window_of(region);
    domain.begin(window, flights_.data(), spins_.empty() ? nullptr : spins_.data());
    for (std::size_t k = 0; k < flights_.size(); ++k) domain.load(static_cast<Index>(k), true);
    region.unusual = !domain.start();
    open_ = !region.unusual;
  }
  if (open_) region.unusual = !domain.advance_to(std::min(until_, target_));
}

// One domain: what it has come to goes on as flights.
template <class P>
void Domains<P>::close_window() {
  DomainLoop<P>& domain = *desks_[0].domain;
  until_ = now_;
  keep(regions_[0], domain);
  add_tally(domain.tally());
  desks_[0].beside_pairs += domain.tally().costs;
  adapt(static_cast<double>(domain.tally().ball_halves));
  open_ = false;
  memory_.clear();
}

template <class P>
void Domains<P>::add_tally(const typename DomainLoop<P>::Tally& tally) {
  halves_ += tally.ball_halves;
  counts_.ball_wall += tally.walls;
  counts_.scans += tally.scans;
  counts_.renewals += tally.renewals;
  counts_.vain += tally.stale;
  counts_.max_overlap = std::max(counts_.max_overlap, tally.max_overlap);
  for (const double lost : tally.lost) lost_.add(lost);
}

// The next window is as long as collisions take of which a ball has some.
template <class P>
void Domains<P>::adapt(double halves) {
  const auto span = static_cast<double>(until_ - from_);
  const double wanted = kCollisionsOfWindow * static_cast<double>(movers_);
  if (!(span > 0)) return;
  const double many = std::max(halves, wanted / 4);
  const double length = std::clamp(span * wanted / many, static_cast<double>(window_) / 2,
                                   static_cast<double>(window_) * 2);
  const double share = full_ ? 0.5 : 0.1;  // in a short time few balls collide by chance
  window_ += static_cast<Ticks>(share * (length - static_cast<double>(window_)));
  limit_window();
}

template <class P>
void Domains<P>::limit_window() {
  Ticks most = longest_;
  if (!alone() && speed_ > 0) {
    most = std::min(most, motion_->rules().scale.ticks(kFarthest * spacing_ / speed_));
  }
  window_ = std::min(std::max<Ticks>(window_, 64), std::max<Ticks>(most, 1));
}

template <class P>
void Domains<P>::solve_by_tile() {
  const std::size_t n = flights_.size();
  std::vector<Disk> disks(n);
  for (std::size_t k = 0; k < n; ++k) disks[k] = flights_[k].template disk<Disk>();
  Tile<P> tile(motion_, n);
  tile.reset(disks, from_, {}, spins_);
  tile.advance_to(until_);
  for (std::size_t k = 0; k < n; ++k) {
    next_[k] = BlockFlight::of(tile.disks()[k], flights_[k].ball);
  }
  if (!spins_.empty()) next_spins_ = tile.spins();
  counts_ += tile.counts();
  for (const double lost : tile.take_lost()) lost_.add(lost);
}

template <class P>
void Domains<P>::rebase(Ticks by) {
  if (open_) close_window();
  now_ -= by;
  from_ -= by;
  until_ -= by;
  target_ -= by;
  for (BlockFlight& flight : next_) {
    if (flight.start != kEver) flight.start -= by;
  }
}

template <class P>
void Domains<P>::number_balls() const {
  if (!memory_.empty()) return;
  memory_.resize(next_.size());
  const DomainLoop<P>* domain = open_ ? desks_[0].domain.get() : nullptr;
  for (std::size_t k = 0; k < next_.size(); ++k) {
    const Index ball = domain != nullptr ? flights_[domain->memory(k)].ball : next_[k].ball;
    memory_[ball] = static_cast<Index>(k);
  }
}

template <class P>
auto Domains<P>::flight(std::size_t ball) const -> Disk {
  number_balls();
  const Index k = memory_[ball];
  return open_ ? desks_[0].domain->disk(k) : next_[k].template disk<Disk>();
}

template <class P>
double Domains<P>::spin(std::size_t ball) const {
  number_balls();
  const Index k = memory_[ball];
  return open_ ? *desks_[0].domain->spin(k) : next_spins_[k];
}

template <class P>
Counts Domains<P>::counts() const {
  Counts counts = counts_;
  std::uint64_t halves = halves_;
  if (open_) {
    const auto& tally = desks_[0].domain->tally();
    halves += tally.ball_halves;
    counts.ball_wall += tally.walls;
    counts.max_overlap = std::max(counts.max_overlap, tally.max_overlap);
  }
  counts.ball_ball += halves / 2;
  return counts;
}

template <class P>
double Domains<P>::lost() const {
  ExactSum<double> sum = lost_;
  if (open_) {
    for (const double lost : desks_[0].domain->tally().lost) sum.add(lost);
  }
  return sum.rounded();
}

template <class P>
Costs Domains<P>::costs() const {
  Costs costs;
  for (const Desk& desk : desks_) {
    costs += desk.beside_pairs;
    costs.collisions += desk.seconds - desk.beside_pairs.beside_pairs();
  }
  if (open_) {
    const Costs& open = desks_[0].domain->tally().costs;
    costs += open;
    costs.collisions -= open.beside_pairs();
  }
  costs.collisions = std::max(costs.collisions, 0.0);
  return costs;
}

template <class P>
std::size_t Domains<P>::bytes() const {
  std::size_t bytes =
      (flights_.capacity() + next_.capacity()) * sizeof(BlockFlight) +
      (spins_.capacity() + next_spins_.capacity()) * sizeof(double) +
      outcomes_.capacity() * sizeof(Outcome) +
      (block_of_.capacity() + starts_.capacity() + memory_.capacity()) * sizeof(Index);
  for (const Region& region : regions_) bytes += region.ghosts.capacity() * sizeof(Ghost);
  for (const Desk& desk : desks_) {
    bytes += desk.counts.capacity() * sizeof(Index);
    if (desk.domain) bytes += desk.domain->bytes();
  }
  return bytes;
}

}  // namespace carom::event
