#include "carom/session.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carom {

Session::Session(Scene scene) : scene_(std::move(scene)), simulation_(scene_) {
  if (!scene_.continuation) return;
  clock_ = scene_.continuation->clock;
  paused_ = scene_.continuation->paused;
  const double time = scene_.continuation->time;
  const bool never_paused = clock_ == time;
  clock_origin_ = scene_.continuation->clock_origin.value_or(never_paused ? 0 : clock_);
  time_origin_ = scene_.continuation->time_origin.value_or(never_paused ? 0 : time);
  while (next_line_ < scene_.script.size() && scene_.script[next_line_].at < clock_) ++next_line_;
}

void Session::advance_clock_to(double clock) {
  while (!quit_ && next_line_ < scene_.script.size() && scene_.script[next_line_].at <= clock) {
    const ScriptLine& line = scene_.script[next_line_++];
    move_clock_to(std::max(clock_, line.at));
    apply(line.command);
  }
  if (!quit_) move_clock_to(clock);
}

void Session::move_clock_to(double clock) {
  clock_ = clock;
  if (!paused_) simulation_.advance_to(time_origin_ + (clock_ - clock_origin_));
}

void Session::nudge(double seconds) {
  simulation_.advance_to(simulation_.time() + seconds);
  start_time_here();
}

void Session::apply(const Command& command) {
  if (std::holds_alternative<command::Pause>(command)) {
    paused_ = true;
  } else if (std::holds_alternative<command::Resume>(command)) {
    if (paused_) start_time_here();
    paused_ = false;
  } else if (std::holds_alternative<command::Quit>(command)) {
    quit_ = true;
  } else {
    simulation_.apply(command);
    obeyed_.push_back({simulation_.time(), command});
  }
}

void Session::start_time_here() {
  clock_origin_ = clock_;
  time_origin_ = simulation_.time();
}

bool Session::stuck() const {
  return paused_ && next_line_ == scene_.script.size();
}

Scene Session::save() const {
  Scene scene = simulation_.save();
  if (!scene.continuation) scene.continuation.emplace();
  scene.continuation->clock = clock_;
  scene.continuation->paused = paused_;
  if (!paused_ && (clock_origin_ != 0 || time_origin_ != 0)) {
    scene.continuation->clock_origin = clock_origin_;
    scene.continuation->time_origin = time_origin_;
  }
  scene.script.assign(scene_.script.begin() + static_cast<std::ptrdiff_t>(next_line_),
                      scene_.script.end());
  return scene;
}

Scene Session::log() const {
  Scene scene = scene_;
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
