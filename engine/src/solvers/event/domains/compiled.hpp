#pragma once

#include "solvers/event/domains/domain_flight_body.hpp"
#include "solvers/event/domains/domain_load_body.hpp"
#include "solvers/event/domains/domain_loop_body.hpp"
#include "solvers/event/domains/domain_search_body.hpp"
#include "solvers/event/domains/domains_body.hpp"
#include "solvers/event/domains/domains_halo_body.hpp"
#include "solvers/event/domains/domains_start_body.hpp"
#include "solvers/event/domains/domains_state_body.hpp"
#include "solvers/event/event_queue_body.hpp"
#include "solvers/event/motion_body.hpp"
#include "solvers/event/motion_impact_body.hpp"
#include "solvers/event/motion_rest_body.hpp"
#include "solvers/event/physics.hpp"

/// Domains compiled for one Physics: a source file for each.
#define CAROM_COMPILE_DOMAINS(PHYSICS)              \
  namespace carom {                                 \
  template class event::DomainLoop<event::PHYSICS>; \
  template class event::Domains<event::PHYSICS>;    \
  }
