#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "carom/timeline.hpp"

namespace carom {

/// The last entries of one thread.
///
/// Threads: the thread that writes; another may read while the first waits at do_frame or is on its
/// way there from frame_done.
class TimelineRing {
 public:
  TimelineRing() : entries_(std::make_unique<TimelineEntry[]>(kFewest)), capacity_(kFewest) {}

  /// Makes room for `frames` frames, each as long as the longest so far, but for no more than
  /// `most` entries.  Allocates.
  /// REQUIRES: no phase has begun.
  void begin_frame(std::size_t frames, std::size_t most);
  /// Adds an entry; the oldest goes where there is no room.
  void add(const TimelineEntry& entry) {
    entries_[written_++ & (capacity_ - 1)] = entry;
    ++in_frame_;
  }
  /// The last entry's wait is over.
  void close(std::int64_t left) { entries_[(written_ - 1) & (capacity_ - 1)].left = left; }
  /// The entries of frames from `first` on, in order.  A wait that has not been closed ends at
  /// `end`.
  [[nodiscard]] std::vector<TimelineEntry> since(std::uint64_t first, std::int64_t end) const;
  /// The first frame all of whose entries are still there.
  [[nodiscard]] std::uint64_t first_whole_frame() const;

  static constexpr std::int64_t kOpen = -1;

 private:
  /// The number of the oldest entry.
  [[nodiscard]] std::uint64_t oldest() const {
    return written_ < capacity_ ? lost_ : std::max(lost_, written_ - capacity_);
  }

  static constexpr std::size_t kFewest = 256;

  std::unique_ptr<TimelineEntry[]> entries_;  // a ring: entry k is at k modulo the capacity
  std::size_t capacity_;                      // a power of two
  std::uint64_t written_ = 0;
  std::uint64_t lost_ = 0;    // before there was more room
  std::size_t in_frame_ = 0;  // entries since the frame began
  std::size_t longest_ = 0;   // entries of a frame
};

/// Records the timeline of a crew: a ring for the control thread and one for each worker.
///
/// Threads: each ring belongs to its thread; the rest is for the control thread between frames.
class TimelineRecorder {
 public:
  /// Keeps the last `frames` frames, or as many as find room.
  explicit TimelineRecorder(std::size_t frames) : frames_(frames) {}

  [[nodiscard]] std::int64_t now() const {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - began_).count();
  }
  void set_workers(std::size_t workers);
  /// Of a ring.
  [[nodiscard]] std::size_t most_entries() const { return kMostEntries / (1 + workers_.size()); }
  [[nodiscard]] TimelineRing& control() { return *control_; }
  [[nodiscard]] TimelineRing& worker(std::size_t index) { return *workers_[index]; }
  [[nodiscard]] std::size_t frames() const { return frames_; }
  [[nodiscard]] std::uint64_t frame() const { return frame_; }
  /// When the last frame ended.
  [[nodiscard]] std::int64_t ended() const { return ended_; }
  void end_frame() {
    ended_ = now();
    ++frame_;
  }
  /// The last `frames` frames of which everything is still there.
  [[nodiscard]] Timeline timeline(std::size_t frames) const;

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kMostEntries = std::size_t{1} << 22;  // of all rings: 160 MiB

  Clock::time_point began_ = Clock::now();
  std::size_t frames_;
  std::uint64_t frame_ = 0;  // the number of the present one
  std::int64_t ended_ = 0;
  std::unique_ptr<TimelineRing> control_ = std::make_unique<TimelineRing>();
  std::vector<std::unique_ptr<TimelineRing>> workers_;  // those that have ended keep their entries
};

/// What a worker notes of itself: nothing where nothing is recorded.
///
/// Threads: its worker.
class WorkerTimeline {
 public:
  explicit WorkerTimeline(std::size_t worker) : worker_(worker) {}

  /// After do_frame; `recorder` is null where nothing is recorded.
  void begin_frame(const std::shared_ptr<TimelineRecorder>& recorder) {
    if (recorder != recorder_ || ring_ != nullptr) note_frame(recorder);
  }
  /// Before a barrier; `barrier` is its place in the timeline.
  void arrive() {
    if (ring_ != nullptr) arrived_ = recorder_->now();
  }
  void leave(std::uint32_t barrier) {
    if (ring_ == nullptr) return;
    const std::int64_t now = recorder_->now();
    ring_->add({mark_, arrived_, now, recorder_->frame(), barrier});
    mark_ = now;
  }
  /// Before frame_done, after which the control thread may read.
  void arrive_at_frame_done(std::uint32_t barrier) {
    if (ring_ == nullptr) return;
    const std::int64_t now = recorder_->now();
    ring_->add({now, now, TimelineRing::kOpen, recorder_->frame(), barrier});
  }
  /// After the do_frame that ends its worker.
  void end() {
    if (ring_ != nullptr) ring_->close(recorder_->ended());
  }

 private:
  void note_frame(const std::shared_ptr<TimelineRecorder>& recorder);

  std::size_t worker_;
  std::shared_ptr<TimelineRecorder> recorder_;  // a worker may still write as recording ends
  TimelineRing* ring_ = nullptr;
  std::int64_t mark_ = 0;     // the last barrier let it through
  std::int64_t arrived_ = 0;  // it began to wait
};

}  // namespace carom
