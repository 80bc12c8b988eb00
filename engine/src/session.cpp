#include "carom/session.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carom {

namespace {

bool is_off(const Walls& walls) {
  return !walls.on;
}
bool is_off(const Collisions& collisions) {
  return !collisions.on;
}
bool is_off(const Gravity& gravity) {
  return gravity.acceleration.x() == 0 && gravity.acceleration.y() == 0;
}
bool is_off(const Drag& drag) {
  return drag.rate == 0;
}
bool is_off(const Friction& friction) {
  return friction.balls == 0 && friction.walls == 0;
}
bool is_off(const Attraction& attraction) {
  return attraction.strength == 0;
}

}  // namespace

Session::Session(Scene scene)
    : scene_(std::move(scene)), simulation_(scene_), when_on_(scene_.effects) {
  if (!scene_.continuation) return;
  clock_ = FrameClock(*scene_.continuation);
  while (next_line_ < scene_.script.size() && scene_.script[next_line_].at < clock_.now())
    ++next_line_;
}

void Session::advance_clock_to(double clock) {
  while (!quit_ && next_line() && *next_line() <= clock) {
    const ScriptLine& line = scene_.script[next_line_++];
    move_clock_to(std::max(clock_.now(), line.at));
    apply(line.command);
  }
  if (!quit_) move_clock_to(clock);
}

void Session::move_clock_to(double clock) {
  clock_.move_to(clock);
  if (!clock_.paused()) simulation_.advance_to(clock_.time());
}

void Session::nudge(double seconds) {
  nudge_to(simulation_.time() + seconds);
}

void Session::nudge_to(double time) {
  simulation_.advance_to(time);
  clock_.start_at(simulation_.time());
}

void Session::apply(const Command& command) {
  if (std::holds_alternative<command::Pause>(command)) {
    clock_.pause();
  } else if (std::holds_alternative<command::Resume>(command)) {
    clock_.resume(simulation_.time());
  } else if (std::holds_alternative<command::Quit>(command)) {
    quit_ = true;
  } else {
    simulation_.apply(command);
    obeyed_.push_back({simulation_.time(), command});
    if (const auto* const set = std::get_if<command::SetEffects>(&command)) {
      for_each_effect([&](const auto& entry) {
        const auto& value = set->effects.*entry.slot;
        if (value && !is_off(*value)) when_on_.*entry.slot = value;
      });
    }
  }
}

std::optional<Session::Switch> Session::switch_of(std::string_view effect) const {
  std::optional<Switch> result;
  for_each_effect([&](const auto& entry) {
    const auto& present = simulation_.effects().*entry.slot;
    if (entry.name != effect || !present) return;
    result.emplace();
    result->on = is_off(*present);
    result->change.effects.*entry.slot =
        result->on ? *(when_on_.*entry.slot) : switched_off(*present);
  });
  return result;
}

std::optional<double> Session::next_line() const {
  if (next_line_ == scene_.script.size()) return std::nullopt;
  return scene_.script[next_line_].at;
}

bool Session::stuck() const {
  return clock_.paused() && !next_line();
}

Scene Session::save() const {
  return save_stream().collect();
}

SceneStream Session::save_stream() const {
  SceneStream stream = simulation_.save_stream();
  Scene& scene = stream.head;
  clock_.save(*scene.continuation);
  scene.script.assign(scene_.script.begin() + static_cast<std::ptrdiff_t>(next_line_),
                      scene_.script.end());
  return stream;
}

void Session::go_on_from(const Scene& log) {
  log_start_ = log;
  obeyed_ = log.script;
}

Scene Session::log() const {
  Scene scene = log_start_ ? *log_start_ : scene_;
  scene.script = obeyed_;
  scene.solver.method = simulation_.method();
  const double start = scene.continuation ? scene.continuation->time : 0;
  if (scene.continuation) {
    scene.continuation->clock = start;
    scene.continuation->paused = false;
  }
  // The end is met exactly: the sum of start and duration must round to it.
  const double end = simulation_.time();
  scene.duration = std::max(0.0, end - start);
  while (start + scene.duration < end) scene.duration = std::nextafter(scene.duration, end + 1);
  while (start + scene.duration > end && scene.duration > 0) {
    scene.duration = std::nextafter(scene.duration, 0);
  }
  return scene;
}

}  // namespace carom
