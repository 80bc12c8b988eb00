#include "carom/report.hpp"

#include <nlohmann/json.hpp>

namespace carom {
namespace {

using Json = nlohmann::ordered_json;

Json pair(const Vec2& vector) {
  return Json::array({vector.x(), vector.y()});
}

Json seconds_by_name(const Seconds& seconds) {
  Json json = Json::object();
  for (const auto& [name, spent] : seconds) json[name] = spent;
  return json;
}

Json costs_by_name(const Seconds& seconds) {
  Json json = Json::object();
  for (const auto& [name, spent] : seconds) json[name] = {{"seconds", spent}};
  return json;
}

Json state_of(const Report& report) {
  Json json = Json::array();
  for (const Ball& ball : report.state) {
    Json entry = {{"position", pair(ball.position)},
                  {"velocity", pair(ball.velocity)},
                  {"radius", ball.radius},
                  {"mass", ball.mass}};
    if (report.spin) entry["spin"] = ball.spin;
    json.push_back(std::move(entry));
  }
  return json;
}

}  // namespace

const char* version() {
  return CAROM_VERSION;
}

const char* method_name(Method method) {
  return method == Method::overlap ? "overlap" : "event";
}

Report make_report(const Session& session) {
  const Simulation& simulation = session.simulation();
  Report report;
  report.scene = session.scene().name;
  report.time = simulation.time();
  report.method = simulation.method();
  report.piles_up = choose_method(session.scene()).piles_up;
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

std::string to_json(const Report& report, bool with_state) {
  const Measurements& measured = report.measurements;
  Json json;
  json["version"] = version();
  json["scene"] = report.scene;
  json["time"] = report.time;
  json["frames"] = report.frames;
  json["ended"] = report.ended;
  json["balls"] = report.state.size();
  json["method"] = method_name(report.method);
  json["step"] = report.step;
  json["digits"] = report.digits;
  json["workers"] = report.workers;
  json["seed"] = report.seed;
  json["events"] = {{"ball_ball", measured.ball_ball}, {"ball_wall", measured.ball_wall}};
  json["joint_impacts"] = measured.joint_impacts;
  json["resting_contacts"] = measured.resting_contacts;
  json["energy"] = {{"initial", measured.energy_initial},
                    {"input", measured.energy_input},
                    {"dissipated", measured.energy_dissipated},
                    {"final", measured.energy_final},
                    {"relative_error", measured.relative_energy_error()}};
  json["momentum"] = {{"initial", pair(measured.momentum_initial)},
                      {"final", pair(measured.momentum_final)}};
  json["islands_again"] = measured.islands_again;
  json["max_overlap"] = measured.max_overlap;
  json["missed_hits"] = measured.missed_hits;
  json["wall_seconds"] = report.wall_seconds;
  json["phases"] = seconds_by_name(measured.phases);
  json["effects"] = costs_by_name(measured.effects);
  json["state_hash"] = report.state_hash;
  if (with_state) json["state"] = state_of(report);
  return json.dump(2) + '\n';
}

}  // namespace carom
