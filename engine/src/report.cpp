#include "carom/report.hpp"

#include <nlohmann/json.hpp>

namespace carom {

const char* version() {
  return CAROM_VERSION;
}

Report make_report(const Session& session, std::size_t frames, double wall_seconds) {
  const Simulation& simulation = session.simulation();
  Report report;
  report.scene = session.scene().name;
  report.time = simulation.time();
  report.frames = frames;
  report.wall_seconds = wall_seconds;
  report.method = simulation.method();
  report.step = simulation.step();
  report.digits = session.scene().solver.digits;
  report.workers = simulation.workers();
  report.seed = session.scene().seed;
  report.spin = session.scene().effects.friction.has_value();
  report.measurements = simulation.measure();
  report.state_hash = simulation.state_hash();
  report.state = simulation.state();
  return report;
}

std::string to_json(const Report& report) {
  nlohmann::ordered_json json;
  json["version"] = version();
  json["scene"] = report.scene;
  json["time"] = report.time;
  return json.dump(2);
}

}  // namespace carom
