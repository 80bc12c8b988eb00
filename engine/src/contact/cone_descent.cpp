#include "contact/cone_descent.hpp"

#include <algorithm>
#include <limits>

#include "contact/cone_guess.hpp"
#include "contact/cone_lanes.hpp"

namespace carom::event {

using cone::kLanes;
using cone::Lanes;
using cone::lanes;
using cone::larger_of;
using cone::largest;
using cone::size_of;
using cone::sums;
using cone::Two;

namespace {

/// How often what contacts gave way is taken back: at most.
constexpr int kMostRefinements = 64;
constexpr int kMostDescents = 1000;
/// After how many descents the impulses are guessed.
constexpr int kLongWay = 100;

}  // namespace

ConeDescent::ConeDescent(ConeResponse& response) : response_(response) {
  for (Column* column : {&anchor_, &slope_, &way_, &change_}) column->assign(response.edges(), 0);
}

void ConeDescent::expand(Column& impulses, double room) {
  const std::size_t edges = response_.edges();
  const double step = response_.step();
  for (std::size_t k = 0; k < edges; k += kLanes) {
    const Lanes at = lanes(&impulses[k]) - room * lanes(&way_[k]);
    const Lanes slope = lanes(&slope_[k]) - room * lanes(&change_[k]);
    const Lanes down = at - step * slope;
    lanes(&impulses[k]) = at > 0 && down > 0 ? down : Lanes{};
  }
  response_.times(impulses.data(), slope_.data());
  for (std::size_t k = 0; k < edges; k += kLanes) {
    lanes(&slope_[k]) += lanes(&from_[k]);
    lanes(&way_[k]) = lanes(&impulses[k]) > 0 ? lanes(&slope_[k]) : Lanes{};
  }
}

void ConeDescent::take_back(const Column& impulses) {
  const double give = response_.give();
  for (std::size_t k = 0; k < response_.edges(); k += kLanes) {
    lanes(&from_[k]) -= give * (lanes(&impulses[k]) - lanes(&anchor_[k]));
    lanes(&anchor_[k]) = lanes(&impulses[k]);
  }
}

void ConeDescent::solve(const Column& parting, Column& impulses, double goal) {
  if (descend_again(parting, impulses, goal, kLongWay)) return;
  if (!guess_cone_impulses(response_, parting, goal, impulses)) {
    descend_again(parting, impulses, goal, kMostRefinements * kMostDescents);
    return;
  }
  start(parting);
  take_back(impulses);
  // What rounding has left.
  descend(impulses, goal, kLongWay);
}

void ConeDescent::start(const Column& parting) {
  from_ = parting;
  std::fill(anchor_.begin(), anchor_.end(), 0);
}

// Contacts give way from where the last solution left them (proximal point method), so that in the
// end they give way to nothing, however heavy what they carry is.
bool ConeDescent::descend_again(const Column& parting, Column& impulses, double goal, int at_most) {
  const std::size_t edges = response_.edges();
  const double give = response_.give();
  start(parting);
  int left = at_most;
  for (int round = 0; round < kMostRefinements; ++round) {
    left -= descend(impulses, goal, std::min(left, kMostDescents));
    if (left == 0) return false;
    Lanes most{};
    for (std::size_t k = 0; k < edges; k += kLanes) {
      most = larger_of(most, size_of(give * (lanes(&impulses[k]) - lanes(&anchor_[k]))));
    }
    if (!(largest(most) > goal / 4)) return true;
    take_back(impulses);
  }
  return false;
}

int ConeDescent::descend(Column& impulses, double goal, int at_most) {
  const std::size_t edges = response_.edges();
  const double to_bound = 1 / response_.step();
  response_.times(impulses.data(), slope_.data());
  const auto onto = [&](std::size_t k) {
    const Lanes& slope = lanes(&slope_[k]);
    return lanes(&impulses[k]) > 0 || slope > 0 ? Lanes{} : slope;
  };
  const auto free = [&](std::size_t k) {
    return lanes(&impulses[k]) > 0 ? lanes(&slope_[k]) : Lanes{};
  };
  for (std::size_t k = 0; k < edges; k += kLanes) {
    lanes(&slope_[k]) += lanes(&from_[k]);
    lanes(&way_[k]) = free(k);
  }
  // The step along the way that descends farthest, and how the slope bends on it.
  const auto look_along = [&]() -> std::array<double, 2> {
    response_.times(way_.data(), change_.data());
    const auto [fall, curvature] = sums(edges, [&](std::size_t k) -> Two {
      const Lanes& way = lanes(&way_[k]);
      return {lanes(&slope_[k]) * way, way * lanes(&change_[k])};
    });
    return {fall / curvature, curvature};
  };
  const auto descend = [&](double length, std::size_t k) {
    lanes(&impulses[k]) -= length * lanes(&way_[k]);
    lanes(&slope_[k]) -= length * lanes(&change_[k]);
  };
  int rounds = 0;
  for (; rounds < at_most; ++rounds) {
    Lanes remains{};
    for (std::size_t k = 0; k < edges; k += kLanes) {
      remains = larger_of(remains, size_of(free(k) + onto(k)));
    }
    if (!(largest(remains) > goal)) return rounds;
    const auto [off, along] = sums(edges, [&](std::size_t k) -> Two {
      const Lanes down = onto(k);
      const Lanes inside = free(k);
      const Lanes most = to_bound * lanes(&impulses[k]);
      return {down * down, inside * (inside < most ? inside : most)};
    });
    if (off > along) {
      for (std::size_t k = 0; k < edges; k += kLanes) lanes(&way_[k]) = onto(k);
      const double length = look_along()[0];
      for (std::size_t k = 0; k < edges; k += kLanes) {
        descend(length, k);
        lanes(&way_[k]) = free(k);
      }
      continue;
    }
    const auto [length, curvature] = look_along();
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Lanes nearest = Lanes{} + kFar;
    for (std::size_t k = 0; k < edges; k += kLanes) {
      const Lanes& way = lanes(&way_[k]);
      const Lanes until = way > 0 ? lanes(&impulses[k]) / way : Lanes{} + kFar;
      nearest = nearest < until ? nearest : until;
    }
    const double room = -largest(-nearest);
    if (!(length < room)) {
      expand(impulses, room);
      continue;
    }
    for (std::size_t k = 0; k < edges; k += kLanes) descend(length, k);
    const auto turned = sums(edges, [&](std::size_t k) -> Two {
      return {free(k) * lanes(&change_[k]), Lanes{}};
    });
    const double turn = turned[0] / curvature;
    for (std::size_t k = 0; k < edges; k += kLanes) {
      lanes(&way_[k]) = free(k) - turn * lanes(&way_[k]);
    }
  }
  return rounds;
}

}  // namespace carom::event
