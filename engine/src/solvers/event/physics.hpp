#pragma once

#include <type_traits>

#include "contact/event_any_law.hpp"
#include "contact/event_flight.hpp"
#include "solvers/event/disk.hpp"
#include "solvers/event/rules.hpp"
#include "solvers/event/ticks.hpp"

namespace carom::event {

/// What a run of the method is compiled for: the number it computes with, the law its balls fly by,
/// whether contacts can come to rest, and whether they rub and so balls have a spin.  Chosen once
/// for a scene; nothing is asked ball by ball.
template <class S, template <class> class FlightLaw, bool kToRest = false, bool kRubs = false>
struct Physics {
  static constexpr bool kSpins = kRubs;
  using Scalar = S;
  using Law = FlightLaw<S>;
  using Clock = event::Clock<S>;
  using Time = typename Clock::Time;
  using At = typename Clock::At;
  static constexpr bool kRests = kToRest;  ///< some impacts lose energy, or balls lie still
  using Disk = std::conditional_t<kSpins, SpinningDisk<S>, BasicDisk<S>>;

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
using DampedToRest = Physics<double, DampedLaw, true>;

/// The same physics with friction.
template <class P>
struct RubbingOf;
template <class S, template <class> class FlightLaw, bool kToRest>
struct RubbingOf<Physics<S, FlightLaw, kToRest>> {
  using Type = Physics<S, FlightLaw, kToRest, true>;
};
using FreeRubbing = RubbingOf<Free>::Type;
using FallingRubbing = RubbingOf<Falling>::Type;
using DampedRubbing = RubbingOf<Damped>::Type;
using FreeToRestRubbing = RubbingOf<FreeToRest>::Type;
using FallingToRestRubbing = RubbingOf<FallingToRest>::Type;
using DampedToRestRubbing = RubbingOf<DampedToRest>::Type;

}  // namespace carom::event
