#pragma once

#include <algorithm>

#include "solvers/event/domains/domains.hpp"
#include "solvers/event/domains/domains_start_body.hpp"

namespace carom::event {

// What is told of balls, counts and costs; where one domain's window is open, it knows more.

template <class P>
void Domains<P>::number_balls() const {
  if (!memory_.empty()) return;
  memory_.resize(next_.size());
  const DomainLoop<P>* domain = open_ ? workspaces_[0].domain.get() : nullptr;
  for (std::size_t k = 0; k < next_.size(); ++k) {
    const Index ball = domain != nullptr ? flights_[domain->memory(k)].ball : next_[k].ball;
    memory_[ball] = static_cast<Index>(k);
  }
}

template <class P>
auto Domains<P>::flight(std::size_t ball) const -> Disk {
  number_balls();
  const Index k = memory_[ball];
  return (open_ ? workspaces_[0].domain->flight(k) : next_[k]).disk();
}

template <class P>
void Domains<P>::fetch(std::size_t ball) const {
  number_balls();
  if (!open_) __builtin_prefetch(&next_[memory_[ball]]);
}

template <class P>
double Domains<P>::spin(std::size_t ball) const {
  number_balls();
  const Index k = memory_[ball];
  return open_ ? *workspaces_[0].domain->spin(k) : next_spins_[k];
}

template <class P>
Index Domains<P>::left(std::size_t ball) const {
  if (next_lefts_.empty()) return kUnknown;
  number_balls();
  const Index k = memory_[ball];
  return open_ ? workspaces_[0].domain->left(k) : next_lefts_[k];
}

template <class P>
Counts Domains<P>::counts() const {
  Counts counts = counts_;
  std::uint64_t halves = halves_;
  if (open_) {
    const auto& tally = workspaces_[0].domain->tally();
    halves += tally.ball_halves;
    counts.ball_wall += tally.walls;
    counts.max_overlap = std::max(counts.max_overlap, tally.max_overlap);
  }
  counts.ball_ball += halves / 2;
  return counts;
}

template <class P>
std::vector<double> Domains<P>::losses() const {
  ExactSum<double> sum = lost_;
  if (open_) {
    for (const double lost : workspaces_[0].domain->tally().lost) sum.add(lost);
  }
  return sum.parts();
}

template <class P>
Costs Domains<P>::costs() const {
  Costs costs;
  for (const Workspace& workspace : workspaces_) {
    costs += workspace.beside_pairs;
    costs.collisions += workspace.seconds - workspace.beside_pairs.beside_pairs();
  }
  if (open_) {
    const Costs& open = workspaces_[0].domain->tally().costs;
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
      outcomes_.capacity() * sizeof(Outcome) + sort_.bytes() +
      (lefts_.capacity() + next_lefts_.capacity() + memory_.capacity()) * sizeof(Index);
  for (const Region& region : regions_) bytes += region.ghosts.capacity() * sizeof(Ghost);
  for (const Workspace& workspace : workspaces_) {
    if (workspace.domain) bytes += workspace.domain->bytes();
  }
  return bytes;
}

template <class P>
std::size_t Domains<P>::bytes_of_flights(std::size_t balls, std::size_t workers, bool spins) {
  const bool several = workers > 1 || balls >= kBallsOfOneDomain;
  std::size_t bytes = 2 * (sizeof(BlockFlight) + (spins ? sizeof(double) : 0));
  // Half of the balls are in the halo of another domain, too.
  if (several) bytes += sizeof(Outcome) + sizeof(Index) + sizeof(Ghost) / 2;
  return balls * bytes;
}

template <class P>
std::size_t Domains<P>::bytes_of_workers(std::size_t balls, std::size_t workers) {
  constexpr auto kMost = static_cast<std::size_t>(1.5 * (kBallsOfDomain + kMoreOfDomain / 2));
  const bool several = workers > 1 || balls >= kBallsOfOneDomain;
  return (several ? workers * std::min(balls, kMost) : balls) * DomainLoop<P>::bytes_of_ball();
}

}  // namespace carom::event
