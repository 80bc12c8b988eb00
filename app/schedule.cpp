#include "schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

// Rounding of clock * rate and of time - clock: a few units in the last place.
constexpr double kRounding = 0x1p-50;
// The numbers up to here that a double tells apart.
constexpr double kMostFrames = 0x1p53;

std::uint64_t frames_until(double clock, double rate) {
  return static_cast<std::uint64_t>(std::floor(clock * rate * (1 + kRounding)));
}

}  // namespace

const char* end_name(Schedule::End end) {
  switch (end) {
    case Schedule::End::frames:
      return "frames";
    case Schedule::End::script:
      return "script";
    case Schedule::End::paused:
      return "paused";
    default:
      return "time";
  }
}

Schedule::Schedule(Session& session, const Options& options)
    : session_(session), start_time_(session.simulation().time()) {
  const Scene& scene = session.scene();
  const double rate = scene.frame_rate;
  first_frame_ = frames_until(session.clock(), rate);
  frame_ = first_frame_;
  const double fastest = std::max(rate, 1 / session.simulation().step());
  const double most = kMostFrames / fastest;
  if (options.frames) {
    if (static_cast<double>(*options.frames) / rate > most) {
      throw UsageError(
          fmt::format("--frames: must be at most {:.3g} at this frame rate and step, got {}",
                      most * rate, *options.frames));
    }
    end_frame_ = first_frame_ + *options.frames;
  } else {
    const double time = options.time.value_or(scene.duration);
    if (time > most) {
      throw UsageError(fmt::format(
          "--time: must be at most {:.3g} at this frame rate and step, got {:.3g}", most, time));
    }
    end_time_ = start_time_ + time;
  }
}

bool Schedule::over() {
  if (session_.quit()) {
    end_ = End::script;
  } else if (end_frame_ && frame_ >= *end_frame_) {
    end_ = End::frames;
  } else if (end_time_ && session_.simulation().time() >= *end_time_ * (1 - kRounding)) {
    end_ = End::time;
  } else if (end_time_ && session_.stuck()) {
    end_ = End::paused;
  }
  return end_ != End::none;
}

bool Schedule::next_frame() {
  if (over()) return false;
  const double rate = session_.scene().frame_rate;
  if (!move_clock_to(static_cast<double>(frame_ + 1) / rate)) {
    (void)over();
    return false;
  }
  ++frame_;
  return true;
}

/// Along the lines of the script, so that nothing but quit happens before the end of a stretch.
bool Schedule::move_clock_to(double clock) {
  const auto& script = session_.scene().script;
  for (; next_line_ < script.size() && script[next_line_].at <= clock; ++next_line_) {
    if (!move_until(std::max(script[next_line_].at, session_.clock()))) return false;
  }
  return move_until(clock);
}

bool Schedule::move_until(double clock) {
  if (end_time_ && !session_.paused()) {
    const double end = *end_time_ + (session_.clock() - session_.simulation().time());
    if (end < clock * (1 - kRounding)) {
      session_.advance_clock_to(end);
      return false;
    }
  }
  session_.advance_clock_to(clock);
  return !session_.quit();
}

double Schedule::part_done() const {
  if (end_frame_) {
    return static_cast<double>(frame_ - first_frame_) /
           static_cast<double>(std::max<std::uint64_t>(1, *end_frame_ - first_frame_));
  }
  const double whole = *end_time_ - start_time_;
  return whole > 0 ? (session_.simulation().time() - start_time_) / whole : 1;
}

}  // namespace carom
