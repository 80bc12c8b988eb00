#pragma once

#include <cstddef>
#include <optional>
#include <variant>

#include "carom/ball.hpp"
#include "carom/effects.hpp"

namespace carom {

/// What a script line or a key asks of a running simulation.
namespace command {

struct Add {
  Ball ball;
};
struct Remove {
  std::optional<std::size_t> ball;  ///< its number; absent: the newest
};
struct Pause {};
struct Resume {};
/// New values for effects that the scene names already.
struct SetEffects {
  Effects effects;
};
/// A new step length, seconds.
struct SetStep {
  double step = 0;
};
struct Quit {};

}  // namespace command

using Command = std::variant<command::Add, command::Remove, command::Pause, command::Resume,
                             command::SetEffects, command::SetStep, command::Quit>;

}  // namespace carom
