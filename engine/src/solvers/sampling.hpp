#pragma once

#include <cstdint>
#include <type_traits>

#include "carom/effects.hpp"
#include "carom/measurements.hpp"

namespace carom {

/// One step in so many has its effects timed: reading the clock in all would cost more than they.
inline constexpr std::uint64_t kSampling = 31;

inline bool is_sampled(std::uint64_t step) {
  return step % kSampling == 0;
}

/// What the sampled ones of `steps` steps took, scaled to all, of the effects that are named.
inline void add_sampled_seconds(const Effects& effects, const EffectSeconds& seconds,
                                std::uint64_t steps, Measurements& measurements) {
  const std::uint64_t sampled = (steps + kSampling - 1) / kSampling;
  const double scale = sampled == 0 ? 0 : static_cast<double>(steps) / static_cast<double>(sampled);
  for_each_effect([&](const auto& entry) {
    using Effect = typename std::decay_t<decltype(entry)>::Type;
    if (!(effects.*entry.slot)) return;
    measurements.effects.emplace_back(entry.name, seconds.of<Effect>() * scale);
  });
}

}  // namespace carom
