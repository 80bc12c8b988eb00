#pragma once

#include <utility>

#include "solvers/event/contact_line.hpp"
#include "solvers/event/loop_core.hpp"

namespace carom::event {

// Impacts are noted by one event loop alone: parts of the plane take some of theirs back.
template <class P>
void LoopCore<P>::record_impacts(bool wanted) {
  if (wanted == log_.wanted) return;
  land();
  log_.wanted = wanted;
  noted_.clear();
  start();
}

template <class P>
void LoopCore<P>::take_impacts(std::vector<Impact>& impacts) {
  collect_log();
  impacts.insert(impacts.end(), noted_.begin(), noted_.end());
  noted_.clear();
}

template <class P>
void LoopCore<P>::tell_slides(std::size_t ball, std::vector<Impact>& impacts) const {
  const auto spin = this->spin(ball);
  if (!spin || !motion().loses_in_flight()) return;
  const Disk disk = flight(ball);
  const auto slides = motion().slides_of(disk, &*spin, now_.ticks);
  const double epoch = static_cast<double>(scale_.seconds(P::Clock::epoch())) * now_.epoch;
  const double seconds = static_cast<double>(scale_.seconds(now_.ticks)) + epoch;
  for (const auto& slide : slides) {
    const Vec<double> at = in_double(motion().wrapped(motion().place(disk, now_.ticks)));
    impacts.push_back(slide_line<P>(slide, at, ball, seconds, balls_[ball].radius));
  }
}

template <class P>
void LoopCore<P>::tell_wake(std::size_t ball, const Disk& disk) {
  const double epoch = static_cast<double>(scale_.seconds(P::Clock::epoch())) * now_.epoch;
  const double seconds = static_cast<double>(scale_.seconds(now_.ticks)) + epoch;
  noted_.push_back(wake_line(in_double(motion().place(disk, now_.ticks)), ball, seconds));
}

// From the numbers and times of the event loop to those of the run.
template <class P>
void LoopCore<P>::collect_log() {
  if (log_.impacts.empty()) return;
  std::vector<std::size_t> number(slot_.size());
  for (std::size_t i = 0; i < slot_.size(); ++i) number[slot_[i]] = i;
  const double epoch = static_cast<double>(scale_.seconds(P::Clock::epoch())) * now_.epoch;
  const std::uint64_t joint = noted_.size();
  for (Impact& impact : log_.impacts) {
    impact.time += epoch;
    if (impact.event != 0) impact.event += joint;
    impact.a = number[impact.a];
    if (impact.b != Impact::kNoBall) impact.b = number[impact.b];
    if (impact.b < impact.a) {
      std::swap(impact.a, impact.b);
      impact.position += impact.distance * impact.normal;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        double& x = impact.position[axis];
        if (domain_.period[axis] > 0) x = domain_.wrapped(axis, x);
      }
      impact.normal = -impact.normal;
    }
    noted_.push_back(impact);
  }
  log_.impacts.clear();
}

}  // namespace carom::event
