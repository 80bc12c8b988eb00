#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "carom/verify.hpp"

namespace carom::hard {

/// What a measure is given.
struct Trial {
  Scene scene;  ///< of the case, with the method of the line
  std::uint64_t seed = 1;
  bool thorough = false;
};

/// One measure of one method in a case.
struct Line {
  Method method = Method::event;
  std::string_view measure;
  double limit = 0;
  double (*value)(const Trial& trial) = nullptr;
  std::string_view not_for = {};  ///< why the method cannot meet it by its nature
};

/// A case and its lines.  Its scene is scenes/hard/NAME.json.
struct Case {
  std::string_view name;
  std::vector<Line> lines;
};

// One family of cases each, in a file of its own.
std::vector<Case> simultaneous_cases();   ///< cradle, rack, corner, tight, three-way
std::vector<Case> timing_cases();         ///< pi, bullet, graze, far
std::vector<Case> loss_cases();           ///< collapse, zeno, pile
std::vector<Case> contact_cases();        ///< slope, triangle, heavy, sleeping, avalanche
std::vector<Case> event_contact_cases();  ///< rolling, tilt, lattice, shaken
std::vector<Case> symmetry_cases();       ///< scaled, mirrored, relabelled, workers, stopped
std::vector<Case> long_cases();           ///< dense, drift, ratio, reversal, rods
std::vector<Case> fluid_cases();          ///< gas, speeds, cooling
std::vector<Case> start_cases();          ///< start

/// The text of scenes/hard/NAME.json; empty where there is none.
std::string_view hard_scene_text(std::string_view name);

}  // namespace carom::hard
