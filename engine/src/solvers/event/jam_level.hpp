#pragma once

#include "carom/scene.hpp"

namespace carom::event {

/// How often balls are taken as jammed before time goes on.
inline constexpr int kMostJams = 1000;
inline constexpr int kMostDoublings = 12;
/// For how many of the spans in which impacts are counted they are taken as jammed at most.
inline constexpr int kLongestJam = 64;

/// How wide a gap between balls is taken as none, because impacts across it had no end.
///
/// Each time that this does not end them the gap is twice as wide; a jam that is found as soon as
/// the last one was over begins with that one's gap, and lasts for twice as many spans.
///
/// Holds: the gap is kTouching 2^k of a contact's distance, k from 0 to kMostDoublings.
/// Errors: std::runtime_error from `widen`, after kMostJams without a span's end.
class JamLevel {
 public:
  /// Impacts have had no end in the present span.
  void widen();
  /// A span of time has passed in which they had one.
  void end_span();

  [[nodiscard]] bool jammed() const { return times_ > 0; }
  /// So near are balls that are taken as jammed, in parts of their contact's distance.
  /// REQUIRES: jammed().
  [[nodiscard]] double gap() const;
  /// No gap has helped: what is taken as jammed loses what its contacts have of speed, or goes
  /// along the ways that are open with that, where nothing takes energy.
  [[nodiscard]] bool gives_up() const { return times_ > kMostDoublings; }

  /// For a run that is saved, and one that goes on from it.
  void save(SavedJam& jam) const;
  void restore(const SavedJam& jam);

 private:
  int times_ = 0;       ///< that the present jam has been found; 0: there is none
  int last_times_ = 0;  ///< the same of the last one
  int lasts_ = 1;       ///< in spans
  int spans_ = 2;       ///< since a jam was found, or was over
};

}  // namespace carom::event
