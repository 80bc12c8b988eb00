#include "carom/session.hpp"

#include <algorithm>
#include <utility>

namespace carom {

Session::Session(Scene scene) : scene_(std::move(scene)), simulation_(scene_) {
  if (!scene_.continuation) return;
  clock_ = scene_.continuation->clock;
  stood_still_ = clock_ - scene_.continuation->time;
  paused_ = scene_.continuation->paused;
  while (next_line_ < scene_.script.size() && scene_.script[next_line_].at < clock_) ++next_line_;
}

void Session::advance_clock_to(double clock) {
  while (!quit_ && next_line_ < scene_.script.size() && scene_.script[next_line_].at <= clock) {
    const ScriptLine& line = scene_.script[next_line_++];
    advance_clock_to(std::max(clock_, line.at));
    apply(line.command);
  }
  if (quit_) return;
  clock_ = clock;
  if (!paused_) simulation_.advance_to(clock_ - stood_still_);
}

void Session::nudge(double seconds) {
  simulation_.advance_to(simulation_.time() + seconds);
  stood_still_ = clock_ - simulation_.time();
}

void Session::apply(const Command& command) {
  if (std::holds_alternative<command::Pause>(command)) {
    paused_ = true;
  } else if (std::holds_alternative<command::Resume>(command)) {
    // Not summed up frame by frame: a pause ends at the same instant at every frame rate.
    if (paused_) stood_still_ = clock_ - simulation_.time();
    paused_ = false;
  } else if (std::holds_alternative<command::Quit>(command)) {
    quit_ = true;
  } else {
    simulation_.apply(command);
  }
}

bool Session::stuck() const {
  return paused_ && next_line_ == scene_.script.size();
}

Scene Session::save() const {
  Scene scene = simulation_.save();
  if (!scene.continuation) scene.continuation.emplace();
  scene.continuation->clock = clock_;
  scene.continuation->paused = paused_;
  scene.script.assign(scene_.script.begin() + static_cast<std::ptrdiff_t>(next_line_),
                      scene_.script.end());
  return scene;
}

}  // namespace carom
