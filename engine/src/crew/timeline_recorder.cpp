#include "crew/timeline_recorder.hpp"

#include <algorithm>

namespace carom {

void TimelineRing::begin_frame(std::size_t frames, std::size_t most) {
  longest_ = std::max(longest_, in_frame_);
  in_frame_ = 0;
  // One frame more than is kept: the present one is being written.
  const std::size_t needed = longest_ * (std::min(frames, most) + 1);
  std::size_t capacity = capacity_;
  while (capacity < needed && 2 * capacity <= most) capacity *= 2;
  if (capacity == capacity_) return;
  auto entries = std::make_unique<TimelineEntry[]>(capacity);
  lost_ = oldest();
  for (std::uint64_t k = lost_; k < written_; ++k) {
    entries[k & (capacity - 1)] = entries_[k & (capacity_ - 1)];
  }
  entries_ = std::move(entries);
  capacity_ = capacity;
}

std::uint64_t TimelineRing::first_whole_frame() const {
  return oldest() == 0 ? 0 : entries_[oldest() & (capacity_ - 1)].frame + 1;
}

std::vector<TimelineEntry> TimelineRing::since(std::uint64_t first, std::int64_t end) const {
  std::vector<TimelineEntry> result;
  for (std::uint64_t k = oldest(); k < written_; ++k) {
    TimelineEntry entry = entries_[k & (capacity_ - 1)];
    if (entry.frame < first) continue;
    if (entry.left == kOpen) entry.left = end;
    result.push_back(entry);
  }
  return result;
}

void TimelineRecorder::set_workers(std::size_t workers) {
  while (workers_.size() < workers) workers_.push_back(std::make_unique<TimelineRing>());
}

Timeline TimelineRecorder::timeline(std::size_t frames) const {
  std::uint64_t first = frame_ - std::min<std::uint64_t>(frame_, std::min(frames, frames_));
  first = std::max(first, control_->first_whole_frame());
  for (const auto& ring : workers_) first = std::max(first, ring->first_whole_frame());
  Timeline result;
  result.control = control_->since(first, ended_);
  for (const auto& ring : workers_) result.workers.push_back(ring->since(first, ended_));
  return result;
}

void WorkerTimeline::note_frame(const std::shared_ptr<TimelineRecorder>& recorder) {
  const bool waited = recorder == recorder_;
  if (!waited) {
    recorder_ = recorder;
    ring_ = recorder ? &recorder->worker(worker_) : nullptr;
    if (ring_ == nullptr) return;
  }
  if (waited) ring_->close(recorder_->ended());
  ring_->begin_frame(recorder_->frames(), recorder_->most_entries());
  const std::int64_t now = recorder_->now();
  if (waited) ring_->add({recorder_->ended(), recorder_->ended(), now, recorder_->frame(), 0});
  mark_ = now;
}

}  // namespace carom
