#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace carom::accuracy {

/// The longest step of the sequence, seconds; the others are its halves.
inline constexpr double kLongestStep = 1.0 / 30;
inline constexpr int kSteps = 11;  ///< down to 1/30720 s

/// When runs are compared: at whole multiples of a spacing, which is the longest step of the
/// sequence times a power of two, so that steps end there; and at the end.
///
/// Between two of them time is parted further where it matters; a fine number counts those parts.
class Samples {
 public:
  static constexpr std::uint64_t kParts = 64;  ///< of a spacing

  /// For runs of `time` seconds; `most` of them at the most.
  Samples(double time, std::size_t most);

  /// Samples after the start; the last one is the end.
  [[nodiscard]] std::size_t count() const { return whole_ + (end_is_whole_ ? 0 : 1); }
  /// Of sample 1 .. count(), and of 0, the start.
  [[nodiscard]] double time(std::size_t sample) const;
  /// Of a fine number; sample s that is whole has fine number s * kParts.
  [[nodiscard]] double fine_time(std::uint64_t fine) const;

  /// Every so many fine numbers a run with this step has a whole number of steps behind it; with
  /// none, always.
  [[nodiscard]] std::uint64_t stride(std::optional<double> step) const;
  /// Whether a run with this step is compared at a sample: it has just ended a step, or it ends.
  [[nodiscard]] bool compares(std::size_t sample, std::optional<double> step) const;

 private:
  double time_;
  double spacing_;
  std::size_t whole_;  // samples at multiples of the spacing
  bool end_is_whole_;  // the last of them is the end
};

}  // namespace carom::accuracy
