#pragma once

#include "contact/event_any_law.hpp"
#include "contact/event_flight.hpp"
#include "solvers/event/disk.hpp"
#include "solvers/event/rules.hpp"
#include "solvers/event/ticks.hpp"

namespace carom::event {

/// What a run of the method is compiled for: the number it computes with and the law its balls fly
/// by, and whether contacts can come to rest.  Chosen once for a scene; nothing is asked ball by
/// ball.
template <class S, template <class> class FlightLaw, bool kToRest = false>
struct Physics {
  using Scalar = S;
  using Law = FlightLaw<S>;
  using Clock = event::Clock<S>;
  using Time = typename Clock::Time;
  using At = typename Clock::At;
  using Disk = BasicDisk<S>;
  static constexpr bool kRests = kToRest;  ///< some impacts lose energy, or balls lie still

  static Law law(const BasicRules<S>& rules) { return law_of(rules, static_cast<Law*>(nullptr)); }

 private:
  static Law law_of(const BasicRules<S>&, StraightLaw<S>*) { return {}; }
  static Law law_of(const BasicRules<S>& rules, BallisticLaw<S>*) { return {gravity(rules)}; }
  static Law law_of(const BasicRules<S>& rules, DampedLaw<S>*) {
    return {gravity(rules), S(rules.drag_rate)};
  }
  static Law law_of(const BasicRules<S>& rules, AnyLaw<S>*) {
    return {gravity(rules), S(rules.drag_rate)};
  }

  static Vec<S> gravity(const BasicRules<S>& rules) {
    return {S(rules.gravity[0]), S(rules.gravity[1])};
  }
};

/// In double, the fastest: a law for each scene.
using Free = Physics<double, StraightLaw>;
using Falling = Physics<double, BallisticLaw>;
using Damped = Physics<double, DampedLaw>;
using FreeToRest = Physics<double, StraightLaw, true>;
using FallingToRest = Physics<double, BallisticLaw, true>;

}  // namespace carom::event
