#include "solvers/event/agenda.hpp"

#include <bit>

namespace carom::event {

void Agenda::reset(Ticks now, Ticks width, std::size_t buckets) {
  const std::size_t count = std::bit_ceil(std::max<std::size_t>(buckets, 4));
  width = std::min(width, kLongestFlight / static_cast<Ticks>(count));
  origin_ = now;
  shift_ =
      static_cast<int>(std::bit_width(static_cast<std::uint64_t>(std::max<Ticks>(width, 1)))) - 1;
  mask_ = count - 1;
  present_ = 0;
  year_end_ = static_cast<Ticks>(count);
  buckets_.assign(count, {});
  ordered_.clear();
  next_ = 0;
  late_.clear();
  far_.clear();
}

void Agenda::rebase(Ticks by) {
  // Buckets are numbered anew too, by whole turns of the ring, so that no difference of times grows
  // beyond what a number holds.
  const auto turn = static_cast<Ticks>(buckets_.size());
  const Ticks numbers = present_ / turn * turn;
  present_ -= numbers;
  year_end_ -= numbers;
  origin_ += (numbers << shift_) - by;
  const auto shift = [by](std::vector<Entry>& entries) {
    for (Entry& entry : entries) entry.time -= by;
  };
  for (auto& bucket : buckets_) shift(bucket);
  shift(ordered_);
  shift(late_);
  shift(far_);
}

std::size_t Agenda::bytes() const {
  std::size_t entries = ordered_.capacity() + late_.capacity() + far_.capacity();
  for (const auto& bucket : buckets_) entries += bucket.capacity();
  return entries * sizeof(Entry) + buckets_.capacity() * sizeof(std::vector<Entry>);
}

std::size_t Agenda::size() const {
  std::size_t entries = ordered_.size() - next_ + late_.size() + far_.size();
  for (const auto& bucket : buckets_) entries += bucket.size();
  return entries;
}

}  // namespace carom::event
