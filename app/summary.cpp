#include "summary.hpp"

#include <fmt/format.h>

namespace carom {
namespace {

std::string row(const std::string& name, const std::string& value) {
  return fmt::format("  {:<27}{}\n", name, value);
}

std::string end_of(const Report& report) {
  if (report.ended == "script") return "; the script quit";
  if (report.ended == "paused") return "; paused, and nothing in the script resumes it";
  return "";
}

std::string costs(const std::string& what, const Seconds& seconds) {
  std::string text;
  for (const auto& [name, spent] : seconds) {
    text += row(fmt::format("{} {}", what, name), fmt::format("{:.3f} s", spent));
  }
  return text;
}

std::string method(const Report& report) {
  if (report.method == Method::event) return fmt::format("event, {} digits", report.digits);
  const char* why = report.piles_up ? kPilesUp : "";
  return fmt::format("overlap, step {:.4g} s{}{}", report.step, *why == '\0' ? "" : ": ", why);
}

// One worker would have computed for the sum of the times of all workers, and would not have
// waited.
std::string workers(const Report& report) {
  constexpr double kShort = 0.01;  // seconds that are not worth a word
  const double computing = report.measurements.computing;
  const double waiting = report.measurements.waiting;
  if (report.workers < 2 || waiting < kShort || waiting < computing) {
    return fmt::format("{}", report.workers);
  }
  return fmt::format(
      "{}: computing {:.2f} s, waiting {:.2f} s; --workers 1 gives the same bits "
      "faster",
      report.workers, computing, waiting);
}

std::string energy(const Measurements& measured) {
  std::string text =
      fmt::format("{:.10g} (initially {:.10g}", measured.energy_final, measured.energy_initial);
  if (measured.energy_input != 0) text += fmt::format(", input {:.10g}", measured.energy_input);
  if (measured.energy_dissipated > 0) {
    text += fmt::format(", dissipated {:.10g}", measured.energy_dissipated);
  }
  return text + ')';
}

}  // namespace

std::string to_summary(const Report& report) {
  const Measurements& measured = report.measurements;
  std::string text = report.scene.empty() ? "a scene without a name\n" : report.scene + '\n';
  text += row("time", fmt::format("{:.10g} s simulated{}", report.time, end_of(report)));
  text += row("frames", fmt::format("{}", report.frames));
  text += row("balls", fmt::format("{}", report.balls));
  text += row("workers", workers(report));
  text += row("method", method(report));
  text += row("events",
              fmt::format("{} ball-ball, {} ball-wall", measured.ball_ball, measured.ball_wall));
  text += row("energy", energy(measured));
  text += row("energy error", fmt::format("{:.2e} relative", measured.relative_energy_error()));
  text += row("max overlap", fmt::format("{:.2e} of the smaller radius", measured.max_overlap));
  if (!report.warning.empty()) text += row("warning", report.warning);
  if (measured.jammed > 0) {
    text += row("jammed", fmt::format("{} contacts in a gap of zero, with speed across it that no "
                                      "impacts end: see carom-models(7)",
                                      measured.jammed));
  }
  if (measured.missed_hits > 0) {
    text += row("missed hits", fmt::format("{} or more: balls passed through each other between "
                                           "two steps, take a smaller one",
                                           measured.missed_hits));
  }
  text += row("wall clock", fmt::format("{:.3f} s", report.wall_seconds));
  text += costs("phase", measured.phases);
  text += costs("effect", measured.effects);
  return text;
}

}  // namespace carom
