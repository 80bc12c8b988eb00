#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "carom/measurements.hpp"
#include "contact/island.hpp"
#include "contact/lasting_contacts.hpp"
#include "contact/missed.hpp"
#include "contact/pair_list.hpp"
#include "effects/collisions.hpp"
#include "effects/walls.hpp"

namespace carom::overlap {

/// What one worker of method `overlap` writes, apart from what others write.
struct alignas(128) Work {
  std::vector<Pair> touching;
  std::vector<Bullet> bullets;
  std::vector<std::uint32_t> out;                            ///< beyond a wall, where contacts last
  std::array<std::vector<effects::WallImpact>, 2> at_walls;  ///< across each axis, by a block
  contact::IslandStep island;
  contact::LastingContacts::Count lasting;
  effects::ImpactCount impacts;
  double deepest = 0;
  EffectSeconds seconds;

  /// Takes over what a worker that goes has counted.
  void inherit(Work& gone);
};

}  // namespace carom::overlap
