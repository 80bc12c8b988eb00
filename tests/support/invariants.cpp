#include "support/invariants.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "carom/scene_file.hpp"
#include "carom/session.hpp"
#include "schedule.hpp"
#include "state/domain.hpp"
#include "support/random_numbers.hpp"
#include "support/transformed_scene.hpp"
#include "verify/runs.hpp"

namespace carom::test {
namespace {

/// What a run ends with.
struct Ended {
  std::vector<Ball> balls;
  std::string hash;
  std::string saved;
  double clock = 0;
  Measurements measured;
};

Ended end_of(const Session& session) {
  const Simulation& simulation = session.simulation();
  Scene saved = session.save();
  saved.workers = 1;
  saved.per_ball = false;
  saved.frame_rate = 30;
  return {simulation.state(), simulation.state_hash(), write_scene(saved), session.clock(),
          simulation.measure()};
}

/// The first line of two texts that differs.
std::string difference(const std::string& a, const std::string& b) {
  std::istringstream lines_a(a);
  std::istringstream lines_b(b);
  std::string line_a;
  std::string line_b;
  while (std::getline(lines_a, line_a) && std::getline(lines_b, line_b)) {
    if (line_a != line_b) return line_a.append("\n  instead of\n").append(line_b);
  }
  return "one is longer";
}

/// As `carom run` does it.
Ended run(const Scene& scene) {
  Session session(scene);
  Schedule schedule(session, Options{});
  while (schedule.next_frame()) continue;
  return end_of(session);
}

Ended run_to(const Scene& scene, double clock) {
  Session session(scene);
  session.advance_clock_to(clock);
  return end_of(session);
}

/// The scene without the lines of its script that are refused when their time comes: a ball that
/// is added where another one is.
Scene without_refused_lines(Scene scene) {
  while (true) {
    Session session(scene);
    try {
      session.advance_clock_to(4 * scene.duration);
      return scene;
    } catch (const CommandError&) {
      const std::size_t rest = session.save().script.size();
      const auto refused = static_cast<std::ptrdiff_t>(scene.script.size() - rest - 1);
      scene.script.erase(scene.script.begin() + refused);
    }
  }
}

/// What the energy book may leave: rounding; the error of the steps in which attraction is
/// followed; and, of method event, that of the steps in which contacts under gravity are.
double most_unexplained(const Scene& scene) {
  if (scene.effects.attraction) return 0.05;
  if (scene.solver.method == Method::overlap) return 1e-11;
  return scene.effects.gravity && loses_energy(scene) ? 1e-12 : 1e-13;
}

/// A step of overlap meets the walls of x before those of y, which shows where friction turns one
/// impulse into the other.
bool same_for_both_axes(const Scene& scene) {
  const bool corners = scene.solver.method == Method::overlap && scene.effects.friction;
  return !corners;
}

class Trial {
 public:
  explicit Trial(const Scene& scene)
      : scene_(without_refused_lines(scene)), random_(scene.seed), expected_(run(scene_)) {}

  std::string broken() {
    std::string found = sane();
    if (found.empty()) found = every_impact_told();
    if (found.empty()) found = same_with_other_workers();
    if (found.empty()) found = same_at_other_frame_rates();
    if (found.empty()) found = same_when_saved();
    if (found.empty()) found = same_in_other_units();
    if (found.empty()) found = same_in_mirrors();
    if (found.empty()) found = same_in_another_order();
    return found;
  }

 private:
  std::string sane() const {
    const Domain domain(scene_.box, has_walls(scene_.effects));
    for (std::size_t i = 0; i < expected_.balls.size(); ++i) {
      const Ball& ball = expected_.balls[i];
      if (!ball.position.allFinite() || !ball.velocity.allFinite() || !std::isfinite(ball.spin)) {
        return fmt::format("ball {} has a number that is not finite", i);
      }
      for (const std::size_t axis : {0U, 1U}) {
        if (!domain.solid(axis)) continue;
        const double x = ball.position[axis];
        if (x < domain.lowest(axis, ball.radius) || x > domain.highest(axis, ball.radius)) {
          return fmt::format("ball {} is outside the walls, at {}", i, x);
        }
      }
    }
    return explained(expected_.measured);
  }

  std::string explained(const Measurements& measured) const {
    const double unexplained = measured.relative_energy_error();
    if (unexplained <= most_unexplained(scene_)) return {};
    return fmt::format("{} of the energy is unexplained", unexplained);
  }

  /// The same has happened in a run with the same bits.
  std::string same_report(const Measurements& measured) const {
    const Measurements& expected = expected_.measured;
    const auto impacts = [](const Measurements& of) {
      return std::array{of.ball_ball, of.ball_wall, of.joint_impacts, of.jammed};
    };
    if (impacts(measured) != impacts(expected)) {
      return fmt::format("impacts {} instead of {}", fmt::join(impacts(measured), ", "),
                         fmt::join(impacts(expected), ", "));
    }
    return explained(measured);
  }

  /// The record of impacts and the report count the same impacts and the same loss, and a run is
  /// the same while its impacts are recorded.
  std::string every_impact_told() const {
    Session session(scene_);
    session.simulation().record_impacts(true);
    Schedule schedule(session, Options{});
    std::uint64_t balls = 0;
    std::uint64_t walls = 0;
    double lost = 0;
    bool last = false;
    do {
      last = !schedule.next_frame();
      for (const Impact& impact : session.simulation().take_impacts(last)) {
        if (!(impact.impulse >= 0)) {
          return fmt::format("an impact at {} has the impulse {}", impact.time, impact.impulse);
        }
        lost += impact.energy_lost;
        if (impact.kind == ImpactKind::rest) continue;
        if (impact.b != Impact::kNoBall) ++balls;
        if (impact.wall != Side::none) ++walls;
      }
    } while (!last);
    const Measurements& measured = expected_.measured;
    if (session.simulation().state_hash() != expected_.hash) return "other bits when recorded";
    if (balls != measured.ball_ball || walls != measured.ball_wall) {
      return fmt::format("{} and {} impacts are recorded, {} and {} counted", balls, walls,
                         measured.ball_ball, measured.ball_wall);
    }
    const double missing = measured.energy_dissipated - lost;
    const double scale = std::max(std::abs(measured.energy_initial), measured.energy_dissipated);
    const double most = 1e-11 * scale;
    if (scene_.effects.drag ? missing >= -most : std::abs(missing) <= most) return {};
    return fmt::format("impacts lose {}, the book says {}", lost, measured.energy_dissipated);
  }

  std::string same_with_other_workers() {
    for (const std::size_t workers : {2U + static_cast<unsigned>(random_.below(6)), 0U}) {
      Scene scene = scene_;
      scene.per_ball = workers == 0;
      scene.workers.reset();
      if (workers > 0) scene.workers = workers;
      const Ended ended = run(scene);
      const std::string differs =
          ended.hash == expected_.hash ? same_report(ended.measured) : "other bits";
      if (differs.empty()) continue;
      return differs +
             (workers > 0 ? fmt::format(", with {} workers", workers) : ", with one for each ball");
    }
    return {};
  }

  std::string same_at_other_frame_rates() {
    for (const double rate : {random_.between(1, 20), random_.between(20, 500)}) {
      Scene scene = scene_;
      scene.frame_rate = rate;
      const Ended ended = run(scene);
      if (ended.hash != expected_.hash) return fmt::format("other bits at {} frames/s", rate);
      const std::string differs = same_report(ended.measured);
      if (!differs.empty()) return fmt::format("{}, at {} frames/s", differs, rate);
      if (ended.saved != expected_.saved) {
        return fmt::format("another save at {} frames/s: {}", rate,
                           difference(ended.saved, expected_.saved));
      }
    }
    return {};
  }

  std::string same_when_saved() {
    for (int k = 0; k < 2; ++k) {
      const double stop = random_.between(0, expected_.clock);
      Session first(scene_);
      first.advance_clock_to(stop);
      const Scene saved = parse_scene(write_scene(first.save()), "saved");
      const Ended ended = run_to(saved, expected_.clock);
      const Ended whole = run_to(scene_, expected_.clock);
      if (ended.hash != whole.hash) return fmt::format("other bits when saved at {}", stop);
      if (ended.saved != whole.saved) {
        return fmt::format("another save when saved at {}: {}", stop,
                           difference(ended.saved, whole.saved));
      }
    }
    return {};
  }

  std::string same_in_other_units() {
    const auto power = [this] { return std::ldexp(1.0, random_.below(41) - 20); };
    const Units units{power(), power(), power()};
    const Ended ended = run(in_units(scene_, units));
    const auto expected = hard::scaled(expected_.balls, units.length, units.time, units.mass);
    if (hard::different(ended.balls, expected) == 0) return {};
    return fmt::format("other bits with length x {}, time x {}, mass x {}", units.length,
                       units.time, units.mass);
  }

  std::string same_in_mirrors() {
    if (scene_.box.origin != Box::Origin::center) return {};
    for (const auto mirror : {hard::Mirror::x, hard::Mirror::y, hard::Mirror::diagonal}) {
      if (mirror == hard::Mirror::diagonal && !same_for_both_axes(scene_)) continue;
      const Ended ended = run(in_mirror(scene_, mirror));
      if (hard::different(ended.balls, hard::mirrored(expected_.balls, mirror)) > 0) {
        return fmt::format("other bits in mirror {}", static_cast<int>(mirror));
      }
    }
    return {};
  }

  std::string same_in_another_order() {
    const Reordered other = reordered(scene_, scene_.seed);
    const Ended ended = run(other.scene);
    std::vector<Ball> balls(ended.balls.size());
    for (std::size_t k = 0; k < balls.size(); ++k) balls[other.number[k]] = ended.balls[k];
    return hard::different(balls, expected_.balls) == 0 ? "" : "other bits in another order";
  }

  Scene scene_;
  RandomNumbers random_;
  Ended expected_;
};

}  // namespace

std::string broken_invariant(const Scene& scene) {
  try {
    return Trial(scene).broken();
  } catch (const SceneError& error) {
    return error.what();
  } catch (const std::runtime_error& error) {
    return std::string("ends with: ") + error.what();
  }
}

}  // namespace carom::test
