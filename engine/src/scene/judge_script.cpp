#include <fmt/format.h>

#include "scene/judge.hpp"
#include "scene/limits.hpp"

namespace carom::scene {

namespace {

/// Goes through the script in the order of time and keeps count of the balls.
class ScriptJudge {
 public:
  ScriptJudge(const Scene& scene, Verdict& verdict) : scene_(scene), verdict_(verdict) {
    balls_ = scene.balls.size();
    for (const Fill& fill : scene.fills) balls_ += fill.count;
  }

  void judge_line(const ScriptLine& line, const std::string& place) {
    place_ = place;
    verdict_.not_negative(Place(place) / "at", line.at);
    std::visit([this](const auto& command) { judge_command(command); }, line.command);
  }

 private:
  void judge_command(const command::Add& add) {
    const Place all(place_);
    const Place place = all / "ball";
    if (judge_ball(add.ball, place, scene_, verdict_) && scene_.effects.collisions &&
        has_box(scene_)) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const double size = scene_.box.size()[axis];
        if (scene_.box.periodic[static_cast<std::size_t>(axis)] && 4 * add.ball.radius > size) {
          verdict_.add(place / "radius",
                       fmt::format("must be at most {:g}, a quarter of the periodic {}, got {}",
                                   size / 4, axis == 0 ? "width" : "height", add.ball.radius));
          break;
        }
      }
    }
    ++balls_;
  }

  void judge_command(const command::Remove& remove) {
    if (balls_ == 0) {
      verdict_.add(std::string_view(place_), "removes a ball when none is left");
      return;
    }
    if (remove.ball && *remove.ball >= balls_) {
      verdict_.add(Place(place_) / "ball",
                   fmt::format("must be the number of a ball, at that time from 0 to {}, got {}",
                               balls_ - 1, *remove.ball));
      return;
    }
    --balls_;
  }

  void judge_command(const command::SetEffects& set) {
    const Effects& named = set.effects;
    const Place all(place_);
    const Place place = all / "effects";
    const Effects& known = scene_.effects;
    for_each_effect([&](const auto& entry) {
      judge_named(place / entry.name, (named.*entry.slot).has_value(),
                  (known.*entry.slot).has_value());
    });
    judge_effects(named, place, verdict_);
  }

  void judge_command(const command::SetStep& set) {
    verdict_.positive(Place(place_) / "solver" / "step", set.step);
  }

  void judge_command(const command::Pause&) {}
  void judge_command(const command::Resume&) {}
  void judge_command(const command::Quit&) {}

  void judge_named(const Place& place, bool set, bool known) {
    if (!set || known) return;
    verdict_.add(place, "sets an effect that the scene does not name, name it in /effects");
  }

  const Scene& scene_;
  Verdict& verdict_;
  std::size_t balls_ = 0;
  std::string place_;
};

}  // namespace

void judge_script(const Scene& scene, const std::vector<std::size_t>& script_lines,
                  Verdict& verdict) {
  ScriptJudge judge(scene, verdict);
  for (std::size_t i = 0; i < scene.script.size(); ++i) {
    const std::size_t number = i < script_lines.size() ? script_lines[i] : i;
    judge.judge_line(scene.script[i], fmt::format("/script/{}", number));
  }
}

}  // namespace carom::scene
