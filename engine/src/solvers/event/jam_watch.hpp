#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "solvers/event/jam_level.hpp"
#include "solvers/event/saved_flight.hpp"

namespace carom::event {

/// So many impacts within so short a time are none of losses that add up, nor of balls that are
/// jammed: those are 4e5 at most for a restitution of 0.9999.
inline constexpr std::uint64_t kManyImpacts = 1000000;
/// The same for elastic balls that gravity presses together, which nothing slows down: within 2^-10
/// of the time in which something crosses the box.
inline constexpr std::uint64_t kManyElastic = 256;
inline constexpr int kElasticSpan = 10;
inline constexpr std::int64_t kShortTicks = std::int64_t{1} << 30;

/// Counts impacts, to find those that follow each other while time hardly goes on: their balls are
/// taken as jammed.
///
/// Too many are more than 1000 + 100 n at one instant, and in a span more than 10^6 + 1000 n, or
/// 256 + 16 n where nothing loses energy along a normal, of n balls.
///
/// Units: ticks of the clock.
/// Errors: std::runtime_error where impacts have no end whatever is taken as jammed.
template <class Clock>
class JamWatch {
 public:
  using Time = typename Clock::Time;
  using At = typename Clock::At;

  /// Forgets all; there are `balls` balls.  `elastic`: nothing loses energy along a normal.
  void reset(At now, std::size_t balls, bool elastic) {
    level_ = {};
    from_ = now;
    span_ = elastic ? Clock::span(1, Clock::bits() - kElasticSpan) : Time(kShortTicks);
    most_in_span_ = elastic ? kManyElastic + 16 * balls : kManyImpacts + 1000 * balls;
    most_at_once_ = 1000 + 100 * balls;
    at_once_ = in_span_ = 0;
  }
  /// Later impacts are at this time, which none was at before.
  void begin_instant(At now) {
    at_once_ = 0;
    if (!(now - from_ > span_)) return;
    from_ = now;
    in_span_ = 0;
    level_.end_span();
  }
  /// Whether there are too many with this one; then they are counted again from 0.
  [[nodiscard]] bool note_impact() {
    ++in_span_;
    if (++at_once_ <= most_at_once_ && in_span_ <= most_in_span_) return false;
    level_.widen();
    at_once_ = in_span_ = 0;
    return true;
  }
  /// Counts time from `by` ticks later on.
  void rebase(At by) { from_ = from_ >= by ? Time(from_ - by) : Time(Time(-1) - kShortTicks); }

  [[nodiscard]] const JamLevel& level() const { return level_; }

  /// For a run that is saved, and one that goes on from it.
  void save(SavedJam& jam) const {
    jam.since = text_of(from_);
    jam.impacts = in_span_;
    level_.save(jam);
  }
  /// After `reset`, at the same time.
  void restore(const SavedJam& jam) {
    from_ = std::min(number_of<Time>(jam.since), from_);
    in_span_ = jam.impacts;
    level_.restore(jam);
  }

 private:
  JamLevel level_;
  Time from_ = 0;              ///< the span's start
  Time span_ = 0;              ///< its length
  std::uint64_t in_span_ = 0;  ///< impacts
  std::uint64_t at_once_ = 0;  ///< of the present instant
  std::uint64_t most_in_span_ = 0;
  std::uint64_t most_at_once_ = 0;
};

}  // namespace carom::event
