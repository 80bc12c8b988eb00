#pragma once

#include <cstddef>

#include "trajectory/damped_law.hpp"
#include "trajectory/flight.hpp"

namespace carom::event {

/// Whichever law the scene has, asked each time: for scalars whose arithmetic costs more than the
/// question.
template <class S>
class AnyLaw {
 public:
  static constexpr bool kStretches = false;

  AnyLaw(const Vec<S>& gravity, const S& rate)
      : damped_(rate != 0),
        straight_(gravity.x == 0 && gravity.y == 0),
        damped_law_{gravity, rate},
        ballistic_law_{gravity} {}

  static constexpr bool bends() { return true; }
  Vec<S> displacement(const Flight<S>& f, const S& elapsed) const {
    return ask([&](const auto& law) { return law.displacement(f, elapsed); });
  }
  Vec<S> velocity(const Flight<S>& f, const S& elapsed) const {
    return ask([&](const auto& law) { return law.velocity(f, elapsed); });
  }
  Flight<S> after(const Flight<S>& f, const S& elapsed) const {
    return ask([&](const auto& law) { return event::after(law, f, elapsed); });
  }
  Relative<S> relative(const Flight<S>& earlier, const S& elapsed, const Flight<S>& later) const {
    return ask(
        [&](const auto& law) { return relative_at_later_start(law, earlier, elapsed, later); });
  }
  S when(const S& straight) const {
    return ask([&](const auto& law) { return S(law.when(straight)); });
  }
  S wall_wait(std::size_t axis, int side, const S& h, const S& v) const {
    return ask([&](const auto& law) { return law.wall_wait(axis, side, h, v); });
  }
  S wall_arrival(std::size_t axis, int side, const S& h, const S& v, const S& elapsed) const {
    return ask([&](const auto& law) { return law.wall_arrival(axis, side, h, v, elapsed); });
  }
  S fixed_disk_wait(const Vec<S>& r, const Vec<S>& v, const S& s, bool from_contact) const {
    if (damped_) return damped_law_.fixed_disk_wait(r, v, s, from_contact);
    return straight_ ? pair_time(r, v, s) : ballistic_law_.fixed_disk_wait(r, v, s, from_contact);
  }
  const S& pull(std::size_t axis) const { return damped_law_.pull(axis); }
  const Vec<S>& pull() const { return damped_law_.pull(); }
  AnyLaw rolling() const { return {rolling_part(pull()), S(2 * fading() / 3)}; }
  AnyLaw under(const Vec<S>& pull) const { return {pull, damped_law_.rate}; }
  S push(std::size_t axis, const S& v) const { return damped_law_.push(axis, v); }
  const S& fading() const { return damped_law_.fading(); }

 private:
  template <class Question>
  auto ask(const Question& question) const {
    if (damped_) return question(damped_law_);
    return straight_ ? question(StraightLaw<S>{}) : question(ballistic_law_);
  }

  bool damped_;
  bool straight_;
  DampedLaw<S> damped_law_;
  BallisticLaw<S> ballistic_law_;
};

template <class S>
Flight<S> after(const AnyLaw<S>& law, const Flight<S>& f, const S& elapsed) {
  return law.after(f, elapsed);
}

template <class S>
Relative<S> relative_at_later_start(const AnyLaw<S>& law, const Flight<S>& earlier,
                                    const S& elapsed, const Flight<S>& later) {
  return law.relative(earlier, elapsed, later);
}

}  // namespace carom::event
