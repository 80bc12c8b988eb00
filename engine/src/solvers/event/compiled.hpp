#pragma once

#include "solvers/event/event_loop_body.hpp"
#include "solvers/event/event_queue_body.hpp"
#include "solvers/event/groups/conflict_groups_body.hpp"
#include "solvers/event/islands/island_coming_body.hpp"
#include "solvers/event/islands/island_impact_body.hpp"
#include "solvers/event/islands/island_impulses_body.hpp"
#include "solvers/event/islands/island_search_body.hpp"
#include "solvers/event/islands/island_stepping_body.hpp"
#include "solvers/event/loop_core_body.hpp"
#include "solvers/event/loop_core_book_body.hpp"
#include "solvers/event/loop_core_change_body.hpp"
#include "solvers/event/loop_core_log_body.hpp"
#include "solvers/event/loop_core_start_body.hpp"
#include "solvers/event/loop_core_state_body.hpp"
#include "solvers/event/loop_cost_body.hpp"
#include "solvers/event/loop_impact_body.hpp"
#include "solvers/event/loop_island_body.hpp"
#include "solvers/event/loop_joint_body.hpp"
#include "solvers/event/loop_rest_body.hpp"
#include "solvers/event/loop_simultaneous_body.hpp"
#include "solvers/event/loop_undo_body.hpp"
#include "solvers/event/motion_body.hpp"
#include "solvers/event/motion_impact_body.hpp"
#include "solvers/event/motion_rest_body.hpp"
#include "solvers/event/motion_roll_body.hpp"
#include "solvers/event/neighbours_body.hpp"
#include "solvers/event/prediction_body.hpp"
#include "solvers/event/touch_search_body.hpp"

/// The whole method compiled for one Physics: a source file for each.
#define CAROM_COMPILE_EVENT(PHYSICS)                    \
  namespace carom {                                     \
  template class event::Motion<event::PHYSICS>;         \
  template class event::EventLoop<event::PHYSICS>;      \
  template class event::ConflictGroups<event::PHYSICS>; \
  template class event::LoopCore<event::PHYSICS>;       \
  }
