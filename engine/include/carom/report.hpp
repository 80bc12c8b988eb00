#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carom/session.hpp"
#include "carom/text_sink.hpp"

namespace carom {

/// What a headless run did, as it is written to a file.
struct Report {
  std::string scene;
  double time = 0;           ///< simulated seconds at the end
  std::uint64_t frames = 0;  ///< frames of the frame clock in this run
  std::string ended;         ///< by what: "time", "frames", "script" or "paused"
  double wall_seconds = 0;   ///< of the whole run
  Method method = Method::overlap;
  bool piles_up = false;  ///< by default event, but for so many balls that can pile up
  double step = 0;
  int digits = 16;
  std::size_t workers = 0;
  std::uint64_t seed = 0;
  bool spin = false;  ///< the scene has friction, and its balls spin
  Measurements measurements;
  std::string warning;  ///< of what makes the run less right than it could be; empty: nothing
  std::string state_hash;
  std::size_t balls = 0;
};

/// `measured`: of the whole run, where the session is not all of it.
Report make_report(const Session& session, const std::optional<Measurements>& measured = {});

/// Writes the report as a JSON object, with the state of the balls, one by one, or without.
void write_report(const Report& report, const Simulation* with_state, const TextSink& sink);

const char* method_name(Method method);

/// The version of the engine, as in "0.1.0".
const char* version();

}  // namespace carom
