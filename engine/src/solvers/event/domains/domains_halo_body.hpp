#pragma once

#include <algorithm>
#include <cmath>

#include "solvers/event/domains/domains.hpp"

namespace carom::event {

// Several domains: what they load, and whether what they have done agrees.

template <class P>
DomainWindow Domains<P>::window_of(Region& region) const {
  const carom::Domain& box = motion_->rules().domain;
  DomainWindow window;
  window.from = from_;
  window.until = until_;
  window.skin = skin_;
  window.halo = !alone();
  window.collisions = span_.collisions();
  const HaloWidth::Width width = halo_width_.of(span_.farthest(until_ - from_), region.wider);
  window.full = width.full;
  window.reach = width.reach;
  region.reach = width.reach;
  region.covers = true;
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
      const int halo = static_cast<int>(std::min(std::ceil(width.reach / side), 1e6));
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
  return window;
}

template <class P>
void Domains<P>::solve(Region& region, Workspace& workspace) {
  if (!workspace.domain)
    workspace.domain = std::make_unique<DomainLoop<P>>(*motion_, normal_radius_);
  DomainLoop<P>& domain = *workspace.domain;
  const DomainWindow window = window_of(region);
  domain.begin(window, memory_of_domains());
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
  const std::vector<Index>& starts = sort_.starts();
  const auto& large = sort_.large();
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
      for (Index k = starts[b]; k < starts[b + 1]; ++k) {
        if (own || large.empty() || !is_large(k)) domain.load(k, own);
      }
    }
  }
  for (const auto& ball : large) {
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
    const Vec<double> at = alone() ? Vec<double>{} : domain.last_place(k);
    if (domain.owns(k)) {
      const BlockFlight& flight = domain.flight(k);
      next_[memory] = flight;
      if (!spins_.empty()) next_spins_[memory] = *domain.spin(k);
      if (!lefts_.empty()) next_lefts_[memory] = domain.left(k);
      if (alone()) continue;
      const std::array<double, 2>& middle = domain.window().middle;
      sort_.set_block(memory, blocks_->at(middle[0] + at.x, middle[1] + at.y));
      outcomes_[memory] = {domain.history(k), domain.displacement(k, at)};
      region.displacement = std::max(region.displacement, outcomes_[memory].displacement);
      region.radius = std::max(region.radius, motion_->species(flight).radius);
    } else {
      region.ghosts.push_back({domain.history(k), memory, domain.distance(k),
                               domain.displacement(k, at), domain.followed(k)});
    }
  }
}

// Whether a ball that may have come near to those of the domain, here or at its owner, did
// something else than its owner has it do.
template <class P>
void Domains<P>::check(Region& region) const {
  region.differs = false;
  const auto near = static_cast<float>(region.displacement + region.radius + normal_radius_ +
                                       halo_width_.slack());
  for (const Ghost& ghost : region.ghosts) {
    const Outcome& outcome = outcomes_[ghost.memory];
    if (ghost.distance > near + std::max(outcome.displacement, ghost.displacement)) continue;
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
                                                         halo_width_.slack();
    if (far && !region.differs) continue;
    region.wider *= HaloWidth::kWiderAgain;
    ++again_;
    to_solve_.push_back(k);
  }
  if (!to_solve_.empty()) {
    tried_again_ += to_solve_.size();
    return kSolve;
  }
  sort_.set_known(true);
  double halves = 0;
  for (Region& region : regions_) {
    add_tally(region.tally);
    halves += static_cast<double>(region.tally.ball_halves);
    region.wider = std::max(1.0, region.wider * 0.8);
  }
  halo_width_.learn(tried_again_, regions_.size());
  tried_again_ = 0;
  span_.note_farthest(farthest, until_ - from_);
  span_.learn(halves, until_ - from_);
  return end_window();
}

}  // namespace carom::event
