#include "scene/available.hpp"

#include <array>

namespace carom::scene {

namespace {

struct Unavailable {
  const char* place;
  bool (*asked)(const Scene&);
  const char* message = "is not available in this version";
};

/// The one list of what a scene can name and this version cannot do.
constexpr std::array kUnavailable{
    Unavailable{"/effects/drag", [](const Scene& s) { return s.effects.drag.has_value(); }},
    Unavailable{"/effects/friction", [](const Scene& s) { return s.effects.friction.has_value(); }},
    Unavailable{"/effects/attraction",
                [](const Scene& s) { return s.effects.attraction.has_value(); }},
    Unavailable{"/solver/method", [](const Scene& s) { return s.solver.method == Method::event; },
                "\"event\" is not available in this version, use \"overlap\""},
    Unavailable{"/solver/digits",
                [](const Scene& s) {
                  const int digits = s.solver.digits;
                  return digits == 34 || digits == 50 || digits == 100;
                },
                "more than 16 is not available in this version, use 16"},
};

}  // namespace

std::vector<Problem> find_unavailable(const Scene& scene) {
  std::vector<Problem> problems;
  for (const Unavailable& entry : kUnavailable) {
    if (entry.asked(scene)) problems.push_back({entry.place, entry.message});
  }
  return problems;
}

}  // namespace carom::scene
