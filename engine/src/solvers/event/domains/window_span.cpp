#include "solvers/event/domains/window_span.hpp"

#include <algorithm>
#include <cmath>

namespace carom::event {

// Of a window: the rate of drag times its length.
constexpr double kMostDrag = 0.1;
constexpr FixedTime kShortestWindow = 64;
constexpr FixedTime kLongestWindow = kLongestFlight / 64;

double collision_rate(double speed, double diameter, double spacing, double packing) {
  const double crowding = (1 - packing / 2) / ((1 - packing) * (1 - packing));
  return 3 * speed * diameter / (spacing * spacing) * crowding;
}

void WindowSpan::set_alone(bool alone) {
  const double before = collisions();
  alone_ = alone;
  length_ = static_cast<FixedTime>(static_cast<double>(length_) * (collisions() / before));
  limit();
}

void WindowSpan::begin(const Gas& gas, FixedTime longest) {
  gas_ = gas;
  longest_ = gas.drag_rate > 0 ? clock_.ticks(kMostDrag / gas.drag_rate) : kLongestWindow;
  longest_ = std::min(std::clamp(longest_, kShortestWindow, kLongestWindow), longest);
  length_ = gas.rate > 0 ? clock_.ticks(collisions() / gas.rate) : kLongestWindow;
  length_ = std::min(length_, longest_);
  speed_ = gas.fastest + gas.gravity * clock_.seconds(length_);
  limit();
}

FixedTime WindowSpan::end(FixedTime now, FixedTime target) {
  full_ = alone_ || length_ <= target - now;
  return full_ ? now + length_ : target;
}

void WindowSpan::learn(double halves, FixedTime took) {
  const auto span = static_cast<double>(took);
  const double wanted = collisions() * static_cast<double>(gas_.movers);
  if (!(span > 0)) return;
  const double many = std::max(halves, wanted / 4);
  const double length = std::clamp(span * wanted / many, static_cast<double>(length_) / 2,
                                   static_cast<double>(length_) * 2);
  const double share = full_ ? 0.5 : 0.1;  // in a short time few balls collide by chance
  length_ += static_cast<FixedTime>(share * (length - static_cast<double>(length_)));
  limit();
}

void WindowSpan::note_farthest(double distance, FixedTime took) {
  const double span = clock_.seconds(took);
  if (span > 0) speed_ = distance / span;
}

void WindowSpan::limit() {
  FixedTime most = longest_;
  if (!alone_ && speed_ > 0) {
    most = std::min(most, clock_.ticks(kFarthest * gas_.spacing / speed_));
  }
  length_ = std::min(std::max(length_, kShortestWindow), std::max<FixedTime>(most, 1));
}

}  // namespace carom::event
