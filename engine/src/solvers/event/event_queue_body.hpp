#pragma once

#include <bit>

#include "solvers/event/event_queue.hpp"

namespace carom::event {

template <class Clock>
void EventQueue<Clock>::reset(At now, Time width, std::size_t buckets) {
  const std::size_t count = std::bit_ceil(std::max<std::size_t>(buckets, 4));
  width = std::min(width, Time(Clock::longest_flight() / static_cast<std::int64_t>(count)));
  origin_ = now;
  shift_ = Clock::shift_of(width);
  mask_ = count - 1;
  present_ = 0;
  year_end_ = static_cast<std::int64_t>(count);
  buckets_.assign(count, {});
  ordered_.clear();
  next_ = 0;
  late_.clear();
  far_.clear();
}

template <class Clock>
void EventQueue<Clock>::rebase(At by) {
  // Buckets are numbered again, too, by whole turns of the ring, so that no difference of times
  // grows beyond what a number holds.
  const auto turn = static_cast<std::int64_t>(buckets_.size());
  const std::int64_t numbers = present_ / turn * turn;
  present_ -= numbers;
  year_end_ -= numbers;
  origin_ += Clock::span(numbers, shift_) - by;
  const auto shift = [&by](std::vector<Entry>& entries) {
    for (Entry& entry : entries) entry.time -= by;
  };
  for (auto& bucket : buckets_) shift(bucket);
  shift(ordered_);
  shift(late_);
  shift(far_);
}

template <class Clock>
std::size_t EventQueue<Clock>::size() const {
  std::size_t entries = ordered_.size() - next_ + late_.size() + far_.size();
  for (const auto& bucket : buckets_) entries += bucket.size();
  return entries;
}

}  // namespace carom::event
