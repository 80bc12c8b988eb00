#pragma once

#include <cstdint>

#include "carom/scene.hpp"

namespace carom::test {

/// A random scene of method event in which all that can touch does; the same for a seed on every
/// machine.
///
/// Balls of one radius on a square or a hexagonal lattice, in a box that may leave them no room,
/// one in ten fixed, some moving, their masses up to 1 : 1e6. Any restitution, of walls and of
/// balls; gravity from any side or none, which a script may turn; friction, drag and 34 digits or
/// not.
Scene lattice_scene(std::uint64_t seed);

}  // namespace carom::test
