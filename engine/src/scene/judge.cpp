#include "scene/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "scene/available.hpp"
#include "scene/limits.hpp"

namespace carom::scene {

bool Verdict::finite(const Place& place, double value) {
  if (!std::isfinite(value)) {
    add(place, fmt::format("must be a finite number, got {}", value));
  } else if (std::abs(value) > kLargest) {
    add(place, fmt::format("must be at most {0:g} in size, so that its powers stay finite, got {1}",
                           kLargest, value));
  } else {
    return true;
  }
  return false;
}

bool Verdict::finite(const Place& place, const Vec2& value) {
  const bool x = finite(place / "0", value.x());
  return finite(place / "1", value.y()) && x;
}

bool Verdict::positive(const Place& place, double value) {
  if (std::isfinite(value) && value <= 0) {
    add(place, fmt::format("must be greater than 0, got {}", value));
    return false;
  }
  if (std::isfinite(value) && value < kSmallest) {
    add(place, fmt::format("must be at least {:g}, so that its powers do not vanish, got {}",
                           kSmallest, value));
    return false;
  }
  return finite(place, value);
}

bool Verdict::not_negative(const Place& place, double value) {
  if (std::isfinite(value) && value < 0) {
    add(place, fmt::format("must be 0 or greater, got {}", value));
    return false;
  }
  return finite(place, value);
}

bool Verdict::fraction(const Place& place, double value) {
  if (value >= 0 && value <= 1) return true;
  if (!std::isfinite(value)) return finite(place, value);
  add(place, fmt::format("must be from 0 to 1, got {}", value));
  return false;
}

bool Verdict::power_of_two(const Place& place, double value) {
  int exponent = 0;
  if (value > 0 && std::frexp(value, &exponent) == 0.5) return true;
  add(place, fmt::format("must be a power of two, got {:g}", value));
  return false;
}

bool Verdict::within(Limit limit, const Place& place, double value) {
  switch (limit) {
    case Limit::positive:
      return positive(place, value);
    case Limit::not_negative:
      return not_negative(place, value);
    case Limit::fraction:
      return fraction(place, value);
    case Limit::power_of_two:
      return power_of_two(place, value);
    case Limit::none:
      break;
  }
  return finite(place, value);
}

bool has_box(const Scene& scene) {
  const auto good = [](double side) { return side >= kSmallest && side <= kLargest; };
  return good(scene.box.width) && good(scene.box.height);
}

bool judge_effects(const Effects& effects, const Place& place, Verdict& verdict) {
  bool good = true;
  for_each_effect([&](const auto& entry) {
    const auto& effect = effects.*entry.slot;
    if (!effect) return;
    if constexpr (HasTable<std::decay_t<decltype(*effect)>>) {
      good &= verdict.numbers(place / entry.name, *effect);
    } else {
      good &= verdict.finite(place / entry.name, effect->acceleration);
    }
  });
  return good;
}

namespace {

void judge_solver(const SolverChoice& solver, Verdict& verdict) {
  verdict.numbers("/solver", solver);
  const int digits = solver.digits;
  if (digits != 16 && digits != 34 && digits != 50 && digits != 100) {
    verdict.add("/solver/digits", fmt::format("must be 16, 34, 50 or 100, got {}", digits));
  }
}

void judge_clock(const Scene& scene, Verdict& verdict) {
  const bool duration = verdict.not_negative("/duration", scene.duration);
  const bool rate = verdict.positive("/frame_rate", scene.frame_rate);
  if (duration && rate && scene.duration * scene.frame_rate > kMostSteps) {
    verdict.add("/duration",
                fmt::format("is {:g} frames at this frame rate, at most {:g} can be counted",
                            scene.duration * scene.frame_rate, kMostSteps));
  } else if (duration && scene.solver.step >= kSmallest && takes_steps(scene) &&
             scene.duration / scene.solver.step > kMostSteps) {
    verdict.add("/duration",
                fmt::format("takes {:g} steps of {:g}, at most {:g} can be counted",
                            scene.duration / scene.solver.step, scene.solver.step, kMostSteps));
  }
}

// Method event follows a ball from wall to wall and from impact to impact.
class PaceJudge {
 public:
  PaceJudge(const Scene& scene, Verdict& verdict)
      : seconds_(scene.duration),
        side_(std::min(scene.box.width, scene.box.height)),
        height_(std::max(scene.box.width, scene.box.height)),
        verdict_(verdict) {}

  /// `place`: of the list, or of what there is one of; `number` in the list.
  template <class Number>
  void judge_speed(const char* place, const Number& number, const char* key, double speed) {
    const double crossings = seconds_ * speed / side_;
    if (told_ || !(speed <= kLargest) || !(crossings > kMostCrossings)) return;
    told_ = true;
    verdict_.add(std::string_view(fmt::format("{}{}/{}", place, number, key)),
                 fmt::format("makes a ball cross the box {:.3g} times in {:g} s, of which method "
                             "\"event\" follows {:g} at most: use a lower one, a shorter "
                             "duration, or \"overlap\"",
                             crossings, seconds_, kMostCrossings));
  }
  [[nodiscard]] double speed(const Gravity& gravity) const {
    return std::sqrt(gravity.acceleration.norm() * height_);
  }

 private:
  double seconds_;
  double side_;
  double height_;
  Verdict& verdict_;
  bool told_ = false;
};

void judge_pace(const Scene& scene, const std::vector<std::size_t>& script_lines,
                Verdict& verdict) {
  if (choose_method(scene).method != Method::event || !has_box(scene)) return;
  PaceJudge pace(scene, verdict);
  for (std::size_t i = 0; i < scene.balls.size(); ++i) {
    const Ball& ball = scene.balls[i];
    if (!ball.fixed) pace.judge_speed("/balls/", i, "velocity", ball.velocity.norm());
  }
  for (std::size_t i = 0; i < scene.fills.size(); ++i) {
    const Fill& fill = scene.fills[i];
    pace.judge_speed("/fill/", i, "temperature", std::sqrt(2 * fill.temperature / fill.mass));
  }
  if (scene.effects.gravity) {
    pace.judge_speed("/effects", "", "gravity", pace.speed(*scene.effects.gravity));
  }
  for (std::size_t i = 0; i < scene.script.size(); ++i) {
    const std::size_t line = i < script_lines.size() ? script_lines[i] : i;
    const Command& command = scene.script[i].command;
    if (const auto* add = std::get_if<command::Add>(&command)) {
      pace.judge_speed("/script/", line, "ball/velocity", add->ball.velocity.norm());
    } else if (const auto* set = std::get_if<command::SetEffects>(&command)) {
      if (!set->effects.gravity) continue;
      pace.judge_speed("/script/", line, "effects/gravity", pace.speed(*set->effects.gravity));
    }
  }
}

/// Calls `visit` with the place and the mass of all balls that can move, those of the script too.
template <class Visit>
void for_each_mass(const Scene& scene, const std::vector<std::size_t>& script_lines, Visit visit) {
  for (std::size_t i = 0; i < scene.balls.size(); ++i) {
    if (!scene.balls[i].fixed) visit("/balls/", i, "/mass", scene.balls[i].mass);
  }
  for (std::size_t i = 0; i < scene.fills.size(); ++i) {
    visit("/fill/", i, "/mass", scene.fills[i].mass);
  }
  for (std::size_t i = 0; i < scene.script.size(); ++i) {
    const auto* add = std::get_if<command::Add>(&scene.script[i].command);
    if (add == nullptr || add->ball.fixed) continue;
    visit("/script/", i < script_lines.size() ? script_lines[i] : i, "/ball/mass", add->ball.mass);
  }
}

// Where a heavy ball lies on a light one, method event balances forces of both sizes.
void judge_masses(const Scene& scene, const std::vector<std::size_t>& script_lines,
                  Verdict& verdict) {
  const Effects& effects = scene.effects;
  if (!effects.gravity || !effects.collisions || !loses_energy(scene)) return;
  if (choose_method(scene).method != Method::event) return;
  constexpr double kMostMassRatio = 1e9;
  double least = kLargest;
  for_each_mass(scene, script_lines, [&](auto, auto, auto, double mass) {
    if (mass > 0) least = std::min(least, mass);
  });
  bool told = false;
  for_each_mass(
      scene, script_lines, [&](const char* list, std::size_t i, const char* key, double mass) {
        if (told || !(mass > kMostMassRatio * least) || !(mass <= kLargest)) return;
        told = true;
        verdict.add(
            std::string_view(fmt::format("{}{}{}", list, i, key)),
            fmt::format("is {:.3g} times the lightest mass, and heavy balls can lie on light "
                        "ones here, which method \"event\" computes up to {:g} times: use "
                        "masses that are nearer",
                        mass / least, kMostMassRatio));
      });
}

void judge_workers(const Scene& scene, Verdict& verdict) {
  if (!scene.workers) return;
  if (*scene.workers == 0) {
    verdict.add("/workers", "must be \"per-ball\" or a whole number from 1 on, got 0");
  } else if (*scene.workers > kMostWorkers) {
    verdict.add("/workers",
                fmt::format("must be at most {}, got {}", kMostWorkers, *scene.workers));
  }
}

/// Flights belong to the balls of the scene, one by one, and to a clock.
void judge_flights(const Scene& scene, Verdict& verdict) {
  const Continuation& continuation = *scene.continuation;
  if (continuation.flights.empty()) return;
  if (!continuation.tick) {
    verdict.add("/continuation/tick", "is missing: flights need it");
  }
  const std::size_t balls = scene.balls.size();
  if (continuation.flights.size() != balls) {
    verdict.add("/continuation/flights", fmt::format("must be one for each of the {} balls, got {}",
                                                     balls, continuation.flights.size()));
    return;
  }
  for (std::size_t i = 0; i < balls; ++i) {
    const auto& left = continuation.flights[i].left;
    if (left && (*left >= balls || !scene.balls[*left].fixed)) {
      verdict.add(Place("/continuation/flights") / i / "left",
                  fmt::format("must be the number of a fixed ball, got {}", *left));
    }
    if (continuation.flights[i].support > 13) {
      verdict.add(Place("/continuation/flights") / i / "carried",
                  fmt::format("must be 0, 1 for x, 2 for y, 3 for both, 4 to 10 on walls with "
                              "friction, 11 to 13 in a contact island, got {}",
                              continuation.flights[i].support));
    }
  }
}

void judge_jam(const SavedJam& jam, Verdict& verdict) {
  const auto at_most = [&verdict](std::string_view key, unsigned number, unsigned most) {
    if (number > most) {
      verdict.add(Place("/continuation/jam") / key,
                  fmt::format("must be at most {}, got {}", most, number));
    }
  };
  at_most("found", jam.found, kMostJamsFound);
  at_most("found_before", jam.found_before, kMostJamsFound);
  at_most("lasts", jam.lasts, kMostJamSpans);
  at_most("spans", jam.spans, kMostJamSpans);
}

void judge_continuation(const Scene& scene, Verdict& verdict) {
  if (!scene.continuation) return;
  const Continuation& continuation = *scene.continuation;
  verdict.numbers("/continuation", continuation);
  if (static_cast<double>(continuation.steps) > kMostSteps) {
    verdict.add("/continuation/steps",
                fmt::format("must be at most {:g}, got {}", kMostSteps, continuation.steps));
  }
  judge_flights(scene, verdict);
  if (continuation.jam) judge_jam(*continuation.jam, verdict);
  if (!scene.fills.empty()) {
    verdict.add("/fill", "cannot stand beside \"continuation\": a saved scene lists all its balls");
  }
}

}  // namespace

std::vector<Problem> judge(const Scene& scene, const std::vector<std::size_t>& script_lines,
                           Known known) {
  Verdict verdict;
  verdict.numbers("/box", scene.box);
  judge_effects(scene.effects, "/effects", verdict);
  for (Problem& problem : find_unavailable(scene, choose_method(scene).method)) {
    verdict.add(std::string_view(problem.place), std::move(problem.message));
  }
  if (known != Known::balls) judge_balls(scene, verdict);
  judge_solver(scene.solver, verdict);
  judge_workers(scene, verdict);
  judge_clock(scene, verdict);
  judge_script(scene, script_lines, verdict);
  judge_pace(scene, script_lines, verdict);
  judge_masses(scene, script_lines, verdict);
  judge_continuation(scene, verdict);
  return verdict.take();
}

}  // namespace carom::scene
