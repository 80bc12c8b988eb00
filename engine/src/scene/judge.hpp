#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "carom/scene.hpp"
#include "carom/scene_file.hpp"
#include "scene/place.hpp"
#include "scene/table.hpp"

namespace carom::scene {

/// What is wrong with what a scene means.  `script_lines`: the number that each line of the script
/// has in its file; empty where they are in order.
/// `known`: what has been judged before and is the same.
std::vector<Problem> judge(const Scene& scene, const std::vector<std::size_t>& script_lines,
                           Known known = Known::nothing);

/// Collects problems; each check says whether its value is good.
class Verdict {
 public:
  void add(const Place& place, std::string message) {
    problems_.push_back({place.text(), std::move(message)});
  }
  bool finite(const Place& place, double value);
  bool finite(const Place& place, const Vec2& value);
  bool positive(const Place& place, double value);
  bool not_negative(const Place& place, double value);
  bool fraction(const Place& place, double value);  ///< from 0 to 1
  bool power_of_two(const Place& place, double value);
  bool within(Limit limit, const Place& place, double value);

  /// Every number of an object, by its table of keys.
  template <class Object>
  bool numbers(const Place& place, const Object& object) {
    bool good = true;
    for_each_key<Object>([&](const auto& key) {
      const auto& value = object.*key.slot;
      using Member = std::decay_t<decltype(value)>;
      if constexpr (std::is_same_v<Member, double>) {
        good &= within(key.limit, place / key.name, value);
      } else if constexpr (std::is_same_v<Member, std::optional<double>>) {
        if (value) good &= within(key.limit, place / key.name, *value);
      } else if constexpr (std::is_same_v<Member, Vec2>) {
        good &= finite(place / key.name, value);
      }
    });
    return good;
  }

  std::vector<Problem> take() { return std::move(problems_); }

 private:
  std::vector<Problem> problems_;
};

bool judge_effects(const Effects& effects, const Place& place, Verdict& verdict);
/// The numbers of a ball, and that it is inside the solid walls.
bool judge_ball(const Ball& ball, const Place& place, const Scene& scene, Verdict& verdict);
void judge_balls(const Scene& scene, Verdict& verdict);
void judge_fill(const Fill& fill, const Place& place, const Scene& scene, Verdict& verdict);
void judge_script(const Scene& scene, const std::vector<std::size_t>& script_lines,
                  Verdict& verdict);
/// The box is a box: both sides are positive numbers.
bool has_box(const Scene& scene);

}  // namespace carom::scene
