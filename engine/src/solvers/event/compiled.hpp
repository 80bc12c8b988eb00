#pragma once

#include "solvers/event/agenda_body.hpp"
#include "solvers/event/groups/conflict_groups_body.hpp"
#include "solvers/event/groups/path_meeting_body.hpp"
#include "solvers/event/motion_body.hpp"
#include "solvers/event/motion_rest_body.hpp"
#include "solvers/event/motion_roll_body.hpp"
#include "solvers/event/neighbours_body.hpp"
#include "solvers/event/tile_body.hpp"
#include "solvers/event/tile_core_body.hpp"
#include "solvers/event/tile_cost_body.hpp"
#include "solvers/event/tile_crowd_energy_body.hpp"
#include "solvers/event/tile_crowd_hit_body.hpp"
#include "solvers/event/tile_crowd_step_body.hpp"
#include "solvers/event/tile_friction_body.hpp"
#include "solvers/event/tile_gathering_body.hpp"
#include "solvers/event/tile_impact_body.hpp"
#include "solvers/event/tile_instant_body.hpp"
#include "solvers/event/tile_lanes_body.hpp"
#include "solvers/event/tile_log_body.hpp"
#include "solvers/event/tile_rest_body.hpp"
#include "solvers/event/tile_search_body.hpp"
#include "solvers/event/tile_undo_body.hpp"

/// The whole method compiled for one Physics: a source file for each.
#define CAROM_COMPILE_EVENT(PHYSICS)                    \
  namespace carom {                                     \
  template class event::Motion<event::PHYSICS>;         \
  template class event::Tile<event::PHYSICS>;           \
  template class event::ConflictGroups<event::PHYSICS>; \
  template class event::TileCore<event::PHYSICS>;       \
  }
