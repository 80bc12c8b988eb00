#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string_view>
#include <tuple>

#include "carom/vector.hpp"

namespace carom {

/// The solid, non-periodic sides of the box.
struct Walls {
  double restitution = 1;
  bool on = true;  ///< a script or a key can switch them off: balls leave meanwhile
};

/// Balls collide with each other.
struct Collisions {
  double restitution = 1;
  bool on = true;  ///< a script or a key can switch them off: balls pass meanwhile
};

/// A uniform acceleration, lengths per second squared.
struct Gravity {
  Vec2 acceleration{0, -9.81};
};

/// dv/dt = -rate v, the same rate (1/s) for every ball.
struct Drag {
  double rate = 0;
};

/// Coulomb friction at impacts; balls carry spin.
struct Friction {
  double balls = 0;
  double walls = 0;
};

/// Every ball attracts every other; a negative strength repels.
struct Attraction {
  double strength = 0;
  double softening = 0;
};

/// The whole list of what is simulated: an effect that is not named is not simulated.
struct Effects {
  std::optional<Walls> walls;
  std::optional<Collisions> collisions;
  std::optional<Gravity> gravity;
  std::optional<Drag> drag;
  std::optional<Friction> friction;
  std::optional<Attraction> attraction;
};

/// Whether the sides are solid, and whether balls collide, at present.
inline bool has_walls(const Effects& effects) {
  return effects.walls && effects.walls->on;
}
inline bool has_collisions(const Effects& effects) {
  return effects.collisions && effects.collisions->on;
}

/// Whether impacts lose energy along the normal.
inline bool loses_energy(const Effects& effects) {
  return (effects.walls && effects.walls->restitution < 1) ||
         (effects.collisions && effects.collisions->restitution < 1);
}

/// An effect as everybody names it: scenes, reports, messages, and the keys of `play`.
template <class Effect>
struct EffectEntry {
  using Type = Effect;

  std::string_view name;
  std::optional<Effect> Effects::*slot;
  char key;  ///< switches it off and on in `play`
};

/// The one table of effects.  A new effect is a member of Effects, a line here, and what the
/// compiler then asks for: every place that says something of each effect has a function for each.
inline constexpr std::tuple kEffects{
    EffectEntry<Walls>{"walls", &Effects::walls, 'w'},
    EffectEntry<Collisions>{"collisions", &Effects::collisions, 'c'},
    EffectEntry<Gravity>{"gravity", &Effects::gravity, 'g'},
    EffectEntry<Drag>{"drag", &Effects::drag, 'd'},
    EffectEntry<Friction>{"friction", &Effects::friction, 'f'},
    EffectEntry<Attraction>{"attraction", &Effects::attraction, 't'},
};
inline constexpr std::size_t kEffectCount = std::tuple_size_v<decltype(kEffects)>;

/// Calls `visit` with every entry of the table, in its order.
template <class Visit>
constexpr void for_each_effect(Visit&& visit) {
  std::apply([&visit](const auto&... entries) { (visit(entries), ...); }, kEffects);
}

static_assert(std::apply(
                  [](const auto&... entries) {
                    return (sizeof(std::optional<typename std::decay_t<decltype(entries)>::Type>) +
                            ...);
                  },
                  kEffects) == sizeof(Effects),
              "kEffects names every member of Effects, each once");

/// The place of an effect in the table.
template <class Effect>
consteval std::size_t effect_index() {
  std::size_t index = 0;
  std::size_t found = kEffectCount;
  for_each_effect([&](const auto& entry) {
    if (std::same_as<typename std::decay_t<decltype(entry)>::Type, Effect>) found = index;
    ++index;
  });
  return found;
}

/// A number for each effect, such as the seconds it took.
class EffectSeconds {
 public:
  template <class Effect>
  double& of() {
    return seconds_[effect_index<Effect>()];
  }
  template <class Effect>
  [[nodiscard]] double of() const {
    return seconds_[effect_index<Effect>()];
  }
  EffectSeconds& operator+=(const EffectSeconds& other) {
    for (std::size_t i = 0; i < kEffectCount; ++i) seconds_[i] += other.seconds_[i];
    return *this;
  }
  EffectSeconds& operator*=(double factor) {
    for (double& seconds : seconds_) seconds *= factor;
    return *this;
  }

 private:
  std::array<double, kEffectCount> seconds_{};
};

/// Puts the values that `named` has in the place of those of `effects`; the others stay.
inline void assign(Effects& effects, const Effects& named) {
  for_each_effect([&](const auto& entry) {
    if (named.*entry.slot) effects.*entry.slot = named.*entry.slot;
  });
}

/// An effect with values that do nothing, for as long as it is switched off.
inline Walls switched_off(Walls walls) {
  walls.on = false;
  return walls;
}
inline Collisions switched_off(Collisions collisions) {
  collisions.on = false;
  return collisions;
}
inline Gravity switched_off(const Gravity&) {
  return {{0, 0}};
}
inline Drag switched_off(const Drag&) {
  return {};
}
inline Friction switched_off(const Friction&) {
  return {};
}
inline Attraction switched_off(Attraction attraction) {
  attraction.strength = 0;
  return attraction;
}

}  // namespace carom
