#pragma once

#include <cstdint>

// The two words of a barrier: its state, with phase, parties and arrived side by side, and the word
// of a gate, which tells the phase it let out last and whether the barrier was cancelled.
namespace carom::barrier {

inline constexpr std::uint32_t kCancelled = 1;
inline constexpr std::uint32_t kNextOfGate = 4;  // two phases on, in the upper 31 bits

inline constexpr unsigned kCountBits = 20;
inline constexpr std::uint64_t kCount = (std::uint64_t{1} << kCountBits) - 1;
inline constexpr std::uint64_t kOneArrived = 1;
inline constexpr std::uint64_t kOneParty = std::uint64_t{1} << kCountBits;
inline constexpr std::uint64_t kOnePhase = std::uint64_t{1} << (2 * kCountBits);
inline constexpr std::uint32_t kPhase = (1U << (64 - 2 * kCountBits)) - 1;

inline std::uint64_t arrived_of(std::uint64_t state) {
  return state & kCount;
}
inline std::uint64_t parties_of(std::uint64_t state) {
  return (state >> kCountBits) & kCount;
}
inline std::uint32_t phase_of(std::uint64_t state) {
  return static_cast<std::uint32_t>(state >> (2 * kCountBits));
}
/// The state in which the next phase begins.
inline std::uint64_t next_phase(std::uint64_t state) {
  return (state & ~kCount) + kOnePhase;
}

/// Has this gate let out the parties of `phase`?  No party can fall two phases behind, so that the
/// numbers may wrap around.
inline bool is_over(std::uint32_t word, std::uint32_t phase) {
  return ((word >> 1) & kPhase) == ((phase + 1) & kPhase);
}

}  // namespace carom::barrier
