#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "carom/scene.hpp"
#include "carom/scene_file.hpp"

namespace carom::scene {

/// What is wrong with what a scene means.  `script_lines`: the number that each line of the script
/// has in its file; empty where they are in order.
std::vector<Problem> judge(const Scene& scene, const std::vector<std::size_t>& script_lines);

/// Collects problems; each check says whether its value is good.
class Verdict {
 public:
  void add(std::string place, std::string message) {
    problems_.push_back({std::move(place), std::move(message)});
  }
  bool finite(const std::string& place, double value);
  bool finite(const std::string& place, const Vec2& value);
  bool positive(const std::string& place, double value);
  bool not_negative(const std::string& place, double value);
  bool fraction(const std::string& place, double value);  ///< from 0 to 1

  std::vector<Problem> take() { return std::move(problems_); }

 private:
  std::vector<Problem> problems_;
};

bool judge_effects(const Effects& effects, const std::string& place, Verdict& verdict);
/// The numbers of a ball, and that it is inside the solid walls.
bool judge_ball(const Ball& ball, const std::string& place, const Scene& scene, Verdict& verdict);
void judge_balls(const Scene& scene, Verdict& verdict);
void judge_fill(const Fill& fill, const std::string& place, const Scene& scene, Verdict& verdict);
void judge_script(const Scene& scene, const std::vector<std::size_t>& script_lines,
                  Verdict& verdict);
/// The box is a box: both sides are positive numbers.
bool has_box(const Scene& scene);

}  // namespace carom::scene
