#include "scene/available.hpp"

#include <algorithm>
#include <array>

namespace carom::scene {

namespace {

double largest_radius(const Scene& scene) {
  double radius = 0;
  for (const Ball& ball : scene.balls) radius = std::max(radius, ball.radius);
  for (const Fill& fill : scene.fills) radius = std::max(radius, fill.radius);
  return radius;
}

// Attraction leaves no closed-form flight: there method `event` integrates, whatever else is named.
bool flies_in_closed_form(const Scene& scene) {
  return !scene.effects.attraction;
}

// Round a shorter one two balls could touch on both sides at once; where it is hardly longer,
// flights that keep to one side are so short that there is no end of them.
bool short_periodic_axis(const Scene& scene) {
  if (!scene.effects.collisions) return false;
  if (!scene.box.periodic[0] && !scene.box.periodic[1]) return false;
  const double least = 4.001 * largest_radius(scene);
  return (scene.box.periodic[0] && !(scene.box.width > least)) ||
         (scene.box.periodic[1] && !(scene.box.height > least));
}

constexpr bool kOverlap[] = {true, false};
constexpr bool kEvent[] = {false, true};

struct Unavailable {
  const char* place;
  const bool* methods;  ///< by Method: which of them cannot do it
  bool (*asked)(const Scene&);
  const char* message;
};

/// The one list of what a scene can name and a method cannot do.
constexpr std::array kUnavailable{
    Unavailable{"/solver/method", kEvent, short_periodic_axis,
                "\"event\" needs periodic axes longer than 4.001 radii of the largest ball, use "
                "\"overlap\""},
    Unavailable{"/solver/digits", kEvent,
                [](const Scene& s) {
                  const int digits = s.solver.digits;
                  return !flies_in_closed_form(s) &&
                         (digits == 34 || digits == 50 || digits == 100);
                },
                "with attraction method \"event\" computes in 16 digits: use 16"},
    Unavailable{"/solver/digits", kOverlap,
                [](const Scene& s) {
                  const int digits = s.solver.digits;
                  return digits == 34 || digits == 50 || digits == 100;
                },
                "method \"overlap\" computes in 16 digits: use 16, or method \"event\""},
};

}  // namespace

std::vector<Problem> find_unavailable(const Scene& scene, Method method) {
  std::vector<Problem> problems;
  for (const Unavailable& entry : kUnavailable) {
    if (entry.methods[static_cast<std::size_t>(method)] && entry.asked(scene)) {
      problems.push_back({entry.place, entry.message});
    }
  }
  return problems;
}

}  // namespace carom::scene

namespace carom {

bool takes_steps(const Scene& scene) {
  return choose_method(scene).method == Method::overlap || !scene::flies_in_closed_form(scene);
}

}  // namespace carom
