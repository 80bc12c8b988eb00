#pragma once

#include <algorithm>
#include <cmath>

#include "solvers/event/domains/domains.hpp"

namespace carom::event {

// A domain solved again gets a halo so much wider.
inline constexpr double kWiderAgain = 1.4;
// Halos are as much wider as farther displacements than those of the last window ask for.
inline constexpr double kFarther = 1.15;
// Wider than single precision and what two sums of a place may differ by, in spacings.
inline constexpr double kHaloSlack = 1e-3;

// Each flight by where it is now, the share of each worker in the order of memory.
template <class P>
void Domains<P>::count_blocks(Share share) {
  std::vector<Index>& counts = workspaces_[share.index].counts;
  counts.assign(blocks_->all(), 0);
  if (blocks_known_) {
    for (std::size_t k = share.begin(next_.size()); k < share.end(next_.size()); ++k) {
      ++counts[block_of_[k]];
    }
    return;
  }
  const bool bends = motion_->bends();
  for (std::size_t k = share.begin(next_.size()); k < share.end(next_.size()); ++k) {
    const BlockFlight& flight = next_[k];
    Vec<double> at{flight.x, flight.y};
    if (flight.start != kEver) {
      if (bends) {
        at = motion_->place(flight, now_);
      } else {
        const double since = motion_->rules().scale.seconds(now_ - flight.start);
        at = {at.x + since * flight.vx, at.y + since * flight.vy};
      }
    }
    block_of_[k] = blocks_->at(at.x, at.y);
    ++counts[block_of_[k]];
  }
}

template <class P>
void Domains<P>::place_blocks() {
  const std::size_t sorters = std::min(workers_, kMostSorters);
  starts_.resize(blocks_->all() + 1);
  Index sum = 0;
  for (std::size_t b = 0; b < blocks_->all(); ++b) {
    starts_[b] = sum;
    for (std::size_t w = 0; w < sorters; ++w) {
      sum += std::exchange(workspaces_[w].counts[b], sum);
    }
  }
  starts_.back() = sum;
}

template <class P>
void Domains<P>::scatter(Share share) {
  std::vector<Index>& to = workspaces_[share.index].counts;
  for (std::size_t k = share.begin(next_.size()); k < share.end(next_.size()); ++k) {
    const Index at = to[block_of_[k]]++;
    flights_[at] = next_[k];
    if (!spins_.empty()) spins_[at] = next_spins_[k];
  }
}

template <class P>
void Domains<P>::find_large() {
  large_.clear();
  if (!(motion_->largest_radius() > normal_radius_)) return;
  for (std::size_t b = 0; b < blocks_->all(); ++b) {
    for (Index k = starts_[b]; k < starts_[b + 1]; ++k) {
      if (motion_->rules().all_species[flights_[k].species].radius > normal_radius_) {
        large_.push_back({k, static_cast<int>(b)});
      }
    }
  }
}

template <class P>
DomainWindow Domains<P>::window_of(Region& region) const {
  const carom::Domain& box = motion_->rules().domain;
  DomainWindow window;
  window.from = from_;
  window.until = until_;
  window.skin = skin_;
  window.halo = !alone();
  window.collisions = collisions_of_window();
  const double displaced = kFarther * speed_ * motion_->rules().scale.seconds(until_ - from_);
  const double beyond = followed_ * std::min(spacing_, 2 * normal_radius_);
  const double full =
      (2 * displaced + 2 * normal_radius_ + beyond + kHaloSlack * spacing_) * region.wider;
  const double wanted = full + pyramid_ * spacing_ * region.wider;
  region.covers = true;
  region.reach = wanted;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double half = (box.upper[axis] - box.lower[axis]) / 2;
    const double middle = box.lower[axis] + half;
    window.middle[axis] = middle;
    window.own[axis] = half;
    window.loaded[axis] = half;
    window.whole[axis] = true;
    region.halo[axis] = 0;
    if (!alone()) {
      const double side = blocks_->side(axis);
      const int first = region.blocks.first[axis];
      const int size = region.blocks.size[axis];
      const int halo = static_cast<int>(std::min(std::ceil(wanted / side), 1e6));
      window.own[axis] = size * side / 2;
      if (size + 2 * halo < blocks_->count(axis)) {
        region.halo[axis] = halo;
        region.covers = false;
        window.middle[axis] = box.lower[axis] + (first + size / 2.0) * side;
        window.loaded[axis] = window.own[axis] + halo * side;
        window.whole[axis] = false;
      }
    }
    const bool periodic = box.period[axis] > 0;
    window.wraps[axis] = window.whole[axis] && periodic;
    window.lowest[axis] = periodic ? -never<double>() : box.lower[axis] - window.middle[axis];
    window.highest[axis] = periodic ? never<double>() : box.upper[axis] - window.middle[axis];
  }
  window.full = full;
  window.reach = region.reach;
  return window;
}

template <class P>
void Domains<P>::solve(Region& region, Workspace& workspace) {
  if (!workspace.domain)
    workspace.domain = std::make_unique<DomainLoop<P>>(*motion_, normal_radius_);
  DomainLoop<P>& domain = *workspace.domain;
  const DomainWindow window = window_of(region);
  domain.begin(window, flights_.data(), spins_.empty() ? nullptr : spins_.data());
  load_halo(region, domain);
  region.unusual = !domain.start() || !domain.advance_to(until_);
  workspace.beside_pairs += domain.tally().costs;
  if (!region.unusual) keep(region, domain);
}

template <class P>
void Domains<P>::load_halo(const Region& region, DomainLoop<P>& domain) const {
  const auto& all_species = motion_->rules().all_species;
  const auto is_large = [&](Index k) {
    return all_species[flights_[k].species].radius > normal_radius_;
  };
  struct Line {
    int first;
    int last;
  };
  std::array<Line, 2> lines;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const int halo = region.halo[axis];
    lines[axis] = {region.blocks.first[axis] - halo,
                   region.blocks.first[axis] + region.blocks.size[axis] + halo};
    if (halo == 0) {
      lines[axis] = {0, blocks_->count(axis)};
    } else if (!blocks_->periodic(axis)) {
      lines[axis] = {std::max(lines[axis].first, 0),
                     std::min(lines[axis].last, blocks_->count(axis))};
    }
  }
  const auto is_own = [&](std::size_t axis, int at) {
    return at >= region.blocks.first[axis] &&
           at < region.blocks.first[axis] + region.blocks.size[axis];
  };
  const auto wrapped = [&](std::size_t axis, int at) {
    const int count = blocks_->count(axis);
    return at < 0 ? at + count : at >= count ? at - count : at;
  };
  for (int y = lines[1].first; y < lines[1].last; ++y) {
    const int row = wrapped(1, y) * blocks_->count(0);
    for (int x = lines[0].first; x < lines[0].last; ++x) {
      const auto b = static_cast<std::size_t>(row + wrapped(0, x));
      const bool own = is_own(0, x) && is_own(1, y);
      for (Index k = starts_[b]; k < starts_[b + 1]; ++k) {
        if (own || large_.empty() || !is_large(k)) domain.load(k, own);
      }
    }
  }
  for (const Large& ball : large_) {
    const int columns = blocks_->count(0);
    if (!is_own(0, ball.block % columns) || !is_own(1, ball.block / columns)) {
      domain.load(ball.memory, false);
    }
  }
}

// What lasts of the window.
template <class P>
void Domains<P>::keep(Region& region, DomainLoop<P>& domain) {
  region.ghosts.clear();
  region.displacement = 0;
  region.radius = 0;
  region.tally = domain.tally();
  for (std::size_t k = 0; k < domain.size(); ++k) {
    const Index memory = domain.memory(k);
    if (domain.owns(k)) {
      const BlockFlight& flight = domain.flight(k);
      next_[memory] = flight;
      if (!spins_.empty()) next_spins_[memory] = *domain.spin(k);
      if (alone()) continue;
      const Vec<double> at = domain.last_place(k);
      const std::array<double, 2>& middle = domain.window().middle;
      block_of_[memory] = blocks_->at(middle[0] + at.x, middle[1] + at.y);
      outcomes_[memory] = {domain.history(k), domain.displacement(k, at)};
      region.displacement = std::max(region.displacement, outcomes_[memory].displacement);
      region.radius = std::max(region.radius, motion_->species(flight).radius);
    } else {
      region.ghosts.push_back({domain.history(k), memory, domain.distance(k), domain.followed(k)});
    }
  }
}

// Whether a ball that may have come near to those of the domain did something else than its owner
// has it do.
template <class P>
void Domains<P>::check(Region& region) const {
  region.differs = false;
  const auto near = static_cast<float>(region.displacement + region.radius + normal_radius_ +
                                       kHaloSlack * spacing_);
  for (const Ghost& ghost : region.ghosts) {
    const Outcome& outcome = outcomes_[ghost.memory];
    if (ghost.distance > near + outcome.displacement) continue;
    if (ghost.followed && ghost.history == outcome.history) continue;
    region.differs = true;
    return;
  }
}

template <class P>
std::size_t Domains<P>::judge() {
  double farthest = 0;
  for (const Region& region : regions_) {
    farthest = std::max(farthest, static_cast<double>(region.displacement));
  }
  to_solve_.clear();
  taken_ = 0;
  for (std::size_t k = 0; k < regions_.size(); ++k) {
    Region& region = regions_[k];
    // Balls that were not loaded.
    const bool far = region.covers || region.reach > region.displacement + farthest +
                                                         region.radius + normal_radius_ +
                                                         kHaloSlack * spacing_;
    if (far && !region.differs) continue;
    region.wider *= kWiderAgain;
    ++again_;
    to_solve_.push_back(k);
  }
  if (!to_solve_.empty()) {
    tried_again_ += to_solve_.size();
    return kSolve;
  }
  blocks_known_ = true;
  double halves = 0;
  for (Region& region : regions_) {
    add_tally(region.tally);
    halves += static_cast<double>(region.tally.ball_halves);
    region.wider = std::max(1.0, region.wider * 0.8);
  }
  // About one domain in twenty is solved again.
  const double part = static_cast<double>(tried_again_) / static_cast<double>(regions_.size());
  const double wider = part > 0.2 ? 1.2 : part > 0.06 ? 1.05 : part > 0 ? 0.99 : 0.98;
  pyramid_ = std::clamp(pyramid_ * wider, 1.0, 40.0);
  tried_again_ = 0;
  const double span = motion_->rules().scale.seconds(until_ - from_);
  if (span > 0) speed_ = farthest / span;
  adapt(halves);
  return end_window();
}

}  // namespace carom::event
