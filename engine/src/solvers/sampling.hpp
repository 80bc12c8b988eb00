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

/// By what to multiply the seconds of the sampled ones of `steps` steps to have those of all.
inline double scale_of_samples(std::uint64_t steps) {
  const std::uint64_t sampled = (steps + kSampling - 1) / kSampling;
  return sampled == 0 ? 0 : static_cast<double>(steps) / static_cast<double>(sampled);
}

/// Notes the seconds of the effects that are named.
inline void add_seconds(const Effects& effects, const EffectSeconds& seconds,
                        Measurements& measurements) {
  for_each_effect([&](const auto& entry) {
    using Effect = typename std::decay_t<decltype(entry)>::Type;
    if (!(effects.*entry.slot)) return;
    measurements.effects.emplace_back(entry.name, seconds.of<Effect>());
  });
}

}  // namespace carom
