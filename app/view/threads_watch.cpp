#include "view/threads_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace carom {
namespace {

constexpr std::size_t kKept = 8;  // calls of advance_to: a frame of the screen seldom takes more
constexpr std::chrono::milliseconds kBetweenLooks{250};
constexpr double kSteady = 0.8;     // of who is busy: lanes should not change places all the time
constexpr std::size_t kAtOnce = 6;  // barriers of a slow frame that are shown at once

Computation computation_of(const Simulation& simulation) {
  if (simulation.method() == Method::overlap) return Computation::overlap;
  return simulation.effects().attraction ? Computation::integrated : Computation::events;
}

}  // namespace

void ThreadsWatch::open(Simulation& simulation) {
  open_ = true;
  next_ = {};
  lanes_ = {};
  start_recording(simulation);
}

void ThreadsWatch::close(Simulation& simulation) {
  open_ = false;
  set_slow(false);
  simulation.record_timeline(0);
}

void ThreadsWatch::start_recording(Simulation& simulation) {
  simulation.record_timeline(kKept);
}

void ThreadsWatch::computed(Simulation& simulation, std::size_t calls, Instant now) {
  if (!open_ || calls == 0) return;
  if (slow_ ? !awaited_ : now < next_) return;
  Timeline timeline = simulation.timeline(calls);
  if (timeline.control.empty()) return start_recording(simulation);  // another simulation
  next_ = now + kBetweenLooks;
  time_ = simulation.time();
  balls_ = simulation.balls();
  barriers_ = std::move(timeline.barriers);
  lanes_ = lanes_of(timeline);
  computation_ = computation_of(simulation);
  computed_.resize(lanes_.workers.size());
  for (std::size_t worker = 0; worker < computed_.size(); ++worker) {
    const double here = computing_in(lanes_.workers[worker], static_cast<double>(lanes_.begin),
                                     static_cast<double>(lanes_.end));
    computed_[worker] = kSteady * computed_[worker] + (1 - kSteady) * here;
  }
  passed_ = awaited_ ? 1 : lanes_.passages.size();
  awaited_ = false;
}

void ThreadsWatch::set_slow(bool slow) {
  slow_ = slow;
  awaited_ = false;
  before_.reset();
  passed_ = lanes_.passages.size();
}

bool ThreadsWatch::pass_barrier() {
  if (passed_ >= lanes_.passages.size()) return false;
  ++passed_;
  return true;
}

void ThreadsWatch::begin_frame(const Simulation& simulation) {
  before_ = simulation.frame();
  awaited_ = true;
}

double ThreadsWatch::slow_frame(const Simulation& simulation, double frame_seconds) {
  return computation_of(simulation) == Computation::events ? frame_seconds : simulation.step();
}

const Frame* ThreadsWatch::before(const Simulation& simulation) const {
  const bool same = simulation.time() == time_ && simulation.balls() == balls_;
  return slow_ && before_ && same && passed_ < lanes_.passages.size() ? &*before_ : nullptr;
}

ThreadsView ThreadsWatch::view() const {
  if (slow_) return slow_view();
  ThreadsView view{lanes_, barriers_, computed_, lanes_.end, "threads", ""};
  if (lanes_.empty()) {
    view.now = "The lanes appear with the next frame that is computed.";
    return view;
  }
  view.title = fmt::format("threads: {:.3g} ms from do_frame to frame_done",
                           static_cast<double>(lanes_.end - lanes_.begin) / 1e6);
  return view;
}

int ThreadsWatch::rows_wanted(const Simulation& simulation) const {
  return static_cast<int>(simulation.workers()) + kRowsBesideLanes + (slow_ ? kRowsOfWords : 0);
}

/// Long frames are shown a few barriers at a time.
ThreadsView ThreadsWatch::slow_view() const {
  const std::size_t count = lanes_.passages.size();
  ThreadsView view{lanes_, barriers_, computed_, lanes_.end, "threads, slow motion", ""};
  if (passed_ == 0 || !before_) {
    view.now = guarantee_between_frames() + " Press . to order a frame.";
    return view;
  }
  const std::size_t last = passed_ - 1;
  const Passage& passage = lanes_.passages[last];
  if (count > kAtOnce && last > 0) {
    const std::size_t first = (last - 1) / (kAtOnce - 1) * (kAtOnce - 1);
    const std::size_t end = std::min(first + kAtOnce, count) - 1;
    view.lanes = part_of(lanes_, first == 0 ? lanes_.begin : lanes_.passages[first].at,
                         end + 1 == count ? lanes_.end : lanes_.passages[end].at);
  }
  view.until = passed_ == count ? lanes_.end : passage.at;
  const std::string& barrier = barriers_[passage.barrier];
  view.title = fmt::format("threads, slow motion: barrier {} of {}", passed_, count);
  const bool pairs =
      std::find(barriers_.begin(), barriers_.end(), "pair_computation") != barriers_.end();
  view.now = barrier + ": " + guarantee_of(barrier, computation_, pairs);
  return view;
}

}  // namespace carom
