#include "carom/report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "json/writer.hpp"

namespace carom {
namespace {

using json::Writer;

void put_pair(Writer& writer, std::string_view name, const Vec2& pair) {
  writer.key(name).begin_list().value(pair.x()).value(pair.y()).end_list();
}

void put_seconds(Writer& writer, const Seconds& seconds) {
  writer.key("phases").begin_object();
  for (const auto& [name, spent] : seconds) writer.put(name, spent);
  writer.end_object();
}

void put_costs(Writer& writer, const Seconds& seconds) {
  writer.key("effects").begin_object();
  for (const auto& [name, spent] : seconds) {
    writer.key(name).begin_object().put("seconds", spent).end_object();
  }
  writer.end_object();
}

/// One ball on a line.
void put_state(Writer& writer, const Simulation& simulation, bool spin) {
  writer.key("state").begin_list(Writer::Layout::lines);
  simulation.visit_state([&](const Ball& ball) {
    writer.begin_object();
    put_pair(writer, "position", ball.position);
    put_pair(writer, "velocity", ball.velocity);
    writer.put("radius", ball.radius).put("mass", ball.mass);
    if (spin) writer.put("spin", ball.spin);
    writer.end_object();
  });
  writer.end_list();
}

// Attraction pulls balls into each other between two steps; the overlap is of the step's order.
std::string warning_of(const Report& report, bool attraction) {
  constexpr double kDeep = 1e-3;
  const double deepest = report.measurements.max_overlap;
  if (!attraction || !(deepest > kDeep) || !(report.step > 0)) return "";
  const double step =
      std::ldexp(report.step, -static_cast<int>(std::ceil(std::log2(deepest / kDeep))));
  return fmt::format("balls overlapped by {:.2g} of a radius at impacts: try --step {:.2g}",
                     deepest, step);
}

}  // namespace

const char* version() {
  return CAROM_VERSION;
}

const char* method_name(Method method) {
  return method == Method::overlap ? "overlap" : "event";
}

Report make_report(const Session& session, const std::optional<Measurements>& measured) {
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
  report.measurements = measured ? *measured : simulation.measure();
  report.warning = warning_of(report, session.scene().effects.attraction.has_value());
  report.state_hash = simulation.state_hash();
  report.balls = simulation.balls();
  return report;
}

void write_report(const Report& report, const Simulation* with_state, const TextSink& sink) {
  const Measurements& measured = report.measurements;
  Writer writer(sink);
  writer.begin_object(Writer::Layout::lines)
      .put("version", version())
      .put("scene", report.scene)
      .put("time", report.time)
      .put("frames", report.frames)
      .put("ended", report.ended)
      .put("balls", report.balls)
      .put("method", method_name(report.method))
      .put("step", report.step)
      .put("digits", report.digits)
      .put("workers", report.workers)
      .put("seed", report.seed);
  writer.key("events")
      .begin_object()
      .put("ball_ball", measured.ball_ball)
      .put("ball_wall", measured.ball_wall)
      .end_object();
  writer.put("joint_impacts", measured.joint_impacts)
      .put("resting_contacts", measured.resting_contacts)
      .put("jammed", measured.jammed);
  writer.key("energy")
      .begin_object()
      .put("initial", measured.energy_initial)
      .put("input", measured.energy_input)
      .put("dissipated", measured.energy_dissipated)
      .put("final", measured.energy_final)
      .put("relative_error", measured.relative_energy_error())
      .end_object();
  writer.key("momentum").begin_object();
  put_pair(writer, "initial", measured.momentum_initial);
  put_pair(writer, "final", measured.momentum_final);
  writer.end_object();
  writer.put("islands_again", measured.islands_again).put("max_overlap", measured.max_overlap);
  if (!report.warning.empty()) writer.put("warning", report.warning);
  writer.put("missed_hits", measured.missed_hits).put("wall_seconds", report.wall_seconds);
  put_seconds(writer, measured.phases);
  put_costs(writer, measured.effects);
  writer.put("state_hash", report.state_hash);
  if (with_state != nullptr) put_state(writer, *with_state, report.spin);
  writer.end_object().finish();
}

}  // namespace carom
