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
constexpr std::uint64_t kFarthest = std::uint64_t{1} << 53U;

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

Schedule::Schedule(Session& session, const Options& options,
                   const std::optional<Beginning>& beginning)
    : session_(session), start_time_(beginning ? beginning->time : session.simulation().time()) {
  const Scene& scene = session.scene();
  const double rate = scene.frame_rate;
  frame_ = frames_until(session.clock(), rate);
  first_frame_ = beginning ? beginning->frame : frame_;
  const double fastest =
      takes_steps(scene) ? std::max(rate, 1 / session.simulation().step()) : rate;
  const double most = kMostFrames / fastest;
  if (options.frames) {
    if (static_cast<double>(*options.frames) / rate > most) {
      throw UsageError(fmt::format("--frames: must be at most {:.3g} at this frame rate{}, got {}",
                                   most * rate, takes_steps(scene) ? " and step" : "",
                                   *options.frames));
    }
    end_frame_ = first_frame_ + *options.frames;
  } else {
    const double time = options.time.value_or(scene.duration);
    if (time > most) {
      throw UsageError(
          fmt::format("--time: must be at most {:.3g} at this frame rate{}, got {:.3g}", most,
                      takes_steps(scene) ? " and step" : "", time));
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
  return !over() && move_on(frame_ + 1);
}

// The last frames before the end are taken one by one, as rounding decides which is the last.
bool Schedule::next_frames(std::uint64_t most) {
  constexpr std::uint64_t kOneByOne = 2;
  if (over()) return false;
  std::uint64_t last = frame_ + std::max<std::uint64_t>(1, std::min(most, kFarthest));
  if (end_frame_) last = std::min(last, *end_frame_);
  // After a line, what it does to the end is asked at the next frame.
  if (const auto line = session_.next_line()) last = std::min(last, frame_before(*line) + 1);
  if (end_time_ && !session_.paused()) {
    const double left = std::max(0.0, *end_time_ - session_.simulation().time());
    const std::uint64_t end = frame_before(session_.clock() + left);
    last = std::min(last, end > kOneByOne ? end - kOneByOne : 0);
  }
  return move_on(std::max(last, frame_ + 1));
}

bool Schedule::move_on(std::uint64_t frame) {
  if (!move_clock_to(clock_of(frame))) {
    // It ended on the way: which frames it has passed, as if it had stopped at each.
    if (frame > frame_ + 1) frame_ = std::max(frame_, frame_before(session_.clock()));
    (void)over();
    return false;
  }
  frame_ = frame;
  return true;
}

double Schedule::clock_of(std::uint64_t frame) const {
  return static_cast<double>(frame) / session_.scene().frame_rate;
}

/// The last frame before an instant.
std::uint64_t Schedule::frame_before(double clock) const {
  const double frames = clock * session_.scene().frame_rate * (1 - kRounding);
  auto frame = static_cast<std::uint64_t>(std::clamp(frames, 0.0, kMostFrames));
  while (frame > 0 && clock_of(frame) >= clock) --frame;
  while (frame < kFarthest && clock_of(frame + 1) < clock) ++frame;
  return frame;
}

/// Along the lines of the script, so that nothing but quit happens before the end of a stretch.
bool Schedule::move_clock_to(double clock) {
  for (auto line = session_.next_line(); line && *line <= clock; line = session_.next_line()) {
    if (!move_until(*line)) return false;
  }
  return move_until(clock);
}

bool Schedule::move_until(double clock) {
  if (end_time_ && !session_.paused()) {
    const double end = session_.clock_at(*end_time_);
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
