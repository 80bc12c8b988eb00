#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/event/domains/domains.hpp"

namespace carom::event {

// A domain has about so many balls where they are dense, and up to so many more where there is room
// between them, as halos are wide then.
inline constexpr double kBallsOfDomain = 3200;
inline constexpr double kMoreOfDomain = 5500;
// Below so many balls and with one worker there is one domain.
inline constexpr std::size_t kBallsOfOneDomain = 20000;
// The skin of lists, by the mean diameter and the gap between neighbours.
inline constexpr double kSkinOfDiameter = 0.3;
inline constexpr double kSkinOfGap = 0.7;

template <class P>
Domains<P>::Domains(const BasicRules<double>& rules)
    : motion_(std::make_shared<const Motion<P>>(rules)) {}

template <class P>
void Domains<P>::reset(const std::vector<Disk>& flights, FixedTime now,
                       const std::vector<double>& spins, const std::vector<Index>& lefts) {
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
  next_lefts_.clear();
  if (motion_->bends() && movers_ < n) {
    next_lefts_ = lefts;
    next_lefts_.resize(n, kUnknown);
  }
  memory_.clear();
  from_ = now_ = until_ = target_ = now;
  const carom::Domain& box = motion_->rules().domain;
  const double area = (box.upper[0] - box.lower[0]) * (box.upper[1] - box.lower[1]);
  spacing_ = std::sqrt(area / static_cast<double>(std::max<std::size_t>(n, 1)));
  choose_radii(flights);
  decompose();
  span_.begin(gas_of(flights), wanted_longest_);
  halo_width_.reset({spacing_, normal_radius_});
}

// All but the largest few balls are normal.
template <class P>
void Domains<P>::choose_radii(const std::vector<Disk>& flights) {
  const auto& all_species = motion_->rules().all_species;
  std::vector<std::size_t> count(all_species.size(), 0);
  double diameters = 0;
  for (const Disk& disk : flights) {
    ++count[disk.species % all_species.size()];
    diameters += 2 * all_species[disk.species % all_species.size()].radius;
  }
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < all_species.size(); ++k) {
    if (count[k] > 0) order.push_back(k);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return all_species[a].radius > all_species[b].radius;
  });
  std::size_t few = std::max<std::size_t>(64, flights.size() / 100);
  normal_radius_ = 0;
  const double mean = diameters / static_cast<double>(std::max<std::size_t>(flights.size(), 1));
  for (const std::size_t k : order) {
    normal_radius_ = all_species[k].radius;
    // They take no room worth a list of their own.
    if (count[k] > few || all_species[k].radius < mean) break;
    few -= count[k];
  }
  balls_of_domain_ = kBallsOfDomain + kMoreOfDomain * std::max(1 - mean / spacing_, 0.0);
  skin_ = kSkinOfDiameter * mean + kSkinOfGap * std::max(spacing_ - mean, 0.0);
  // Of two that are listed no image but the nearest may come near.
  for (const double period : motion_->rules().domain.period) {
    if (period > 0) skin_ = std::min(skin_, period / 8 - motion_->largest_radius() / 2);
  }
}

template <class P>
WindowSpan::Gas Domains<P>::gas_of(const std::vector<Disk>& flights) const {
  double square = 0;
  double fastest = 0;
  double diameters = 0;
  double covered = 0;
  for (const Disk& disk : flights) {
    const double v = disk.vx * disk.vx + disk.vy * disk.vy;
    const double r = motion_->species(disk).radius;
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
  return {movers_,
          spacing_,
          collision_rate(speed, diameters / n, spacing_, packing),
          std::sqrt(fastest),
          gravity,
          rules.drag_rate};
}

template <class P>
void Domains<P>::decompose() {
  const std::size_t n = next_.size();
  std::size_t wanted = 1;
  if (n >= kBallsOfOneDomain) {
    wanted = static_cast<std::size_t>(static_cast<double>(n) / balls_of_domain_);
  }
  wanted = std::max(wanted, workers_);
  regions_.clear();
  to_solve_.clear();
  if (wanted == 1) {
    regions_.resize(1);
  } else {
    blocks_ = std::make_unique<Blocks>(motion_->rules().domain, n);
    sort_.reset(*blocks_, workers_);
    for (const BlockRange& range : cut(*blocks_, wanted)) {
      Region region;
      region.blocks = range;
      regions_.push_back(std::move(region));
    }
  }
  span_.set_alone(alone());
}

}  // namespace carom::event
