#pragma once

#include <cmath>

#include "solvers/event/loop_core.hpp"

namespace carom::event {

template <class P>
double LoopCore<P>::present_losses() const {
  if (!motion().loses_in_flight()) return 0;
  if constexpr (kShares) {
    if (domains_ && motion().rules().only_drag_takes()) {
      const double epochs = now_.epoch - domains_began_.epoch;
      const double seconds = scale_.seconds(now_.ticks) - scale_.seconds(domains_began_.ticks) +
                             epochs * scale_.seconds(P::Clock::epoch());
      return -std::expm1(-2 * effects_.drag->rate * seconds) * domains_energy_;
    }
  }
  double sum = 0;
  for (std::size_t i = 0; i < slot_.size(); ++i) {
    const auto turning = spin(i);
    sum += motion().flight_loss(flight(i), turning ? &*turning : nullptr, now_.ticks);
  }
  return sum;
}

template <class P>
double LoopCore<P>::dissipated() const {
  return lost().rounded() + present_losses();
}

// But for what the present flights have lost.
template <class P>
ExactSum<double> LoopCore<P>::lost() const {
  ExactSum<double> sum = lost_before_;
  const auto add = [&sum](const auto& part) {
    if (!part) return;
    for (const double term : part->losses()) sum.add(term);
  };
  add(loop_);
  add(groups_);
  if constexpr (kShares) add(domains_);
  return sum;
}

template <class P>
std::vector<double> LoopCore<P>::losses() const {
  return lost().parts();
}

template <class P>
void LoopCore<P>::go_on_from_losses(const std::vector<double>& losses) {
  lost_before_.clear();
  for (const double term : losses) lost_before_.add(term);
}

template <class P>
double LoopCore<P>::energy_ahead() const {
  if (loop_) return loop_->given_ahead(now_.ticks);
  if (groups_) return groups_->given_ahead(now_.ticks);
  return 0;
}

}  // namespace carom::event
