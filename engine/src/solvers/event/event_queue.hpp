#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "solvers/event/disk.hpp"

namespace carom::event {

/// What is due when: a calendar of buckets, of which only the present one is kept in order.
///
/// Entries are never taken out: who asks for the next one says which are still wanted, and the
/// others are dropped on the way.  Adding costs a write at the end of a bucket.
///
/// Source: G. Paul, A complexity O(1) priority queue for event driven molecular dynamics
/// simulations, J. Comput. Phys. 221 (2007) 615.
template <class Clock>
class EventQueue {
 public:
  using Time = typename Clock::Time;
  using At = typename Clock::At;

  struct Entry {
    Time time;
    Index ball;
  };
  /// Of a ball: its entry and those of before that are still in it, some one and a half.
  static constexpr std::size_t kBytesOfBall = 5 * sizeof(Entry) / 2;

  /// Empties it; `width` is the ticks of one bucket, about as long as a few entries take.
  void reset(At now, Time width, std::size_t buckets);

  void add(At time, Index ball) {
    if (time == Clock::never()) return;
    const std::int64_t number = Clock::steps(time - origin_, shift_);
    if (number <= present_) {
      late_.push_back({time, ball});
      std::push_heap(late_.begin(), late_.end(), later);
    } else if (number < year_end_) {
      buckets_[static_cast<std::size_t>(number) & mask_].push_back({time, ball});
    } else {
      far_.push_back({time, ball});
    }
  }

  /// The earliest entry; opens buckets up to the one that holds `until`.  `wanted(entry)` tells
  /// whether an entry still counts; `prepare` is given the entries of each bucket in order before
  /// the first of them is due.  Null: none up to `until`.
  template <class Wanted, class Prepare>
  const Entry* first(At until, const Wanted& wanted, const Prepare& prepare) {
    while (next_ == ordered_.size() && late_.empty()) {
      if (Clock::steps(until - origin_, shift_) <= present_) return nullptr;
      open_next(wanted);
      prepare(std::span<const Entry>(ordered_),
              std::span<const Entry>(buckets_[static_cast<std::size_t>(present_ + 1) & mask_]),
              std::span<const Entry>(buckets_[static_cast<std::size_t>(present_ + 2) & mask_]));
    }
    const bool from_late =
        !late_.empty() && (next_ == ordered_.size() || late_.front().time < ordered_[next_].time);
    const Entry* entry = from_late ? &late_.front() : &ordered_[next_];
    taking_late_ = from_late;
    return entry->time <= until ? entry : nullptr;
  }
  /// Counts time from `by` ticks later on.
  void rebase(At by);
  /// Takes out the entry that `first` gave.
  void drop_first() {
    if (taking_late_) {
      std::pop_heap(late_.begin(), late_.end(), later);
      late_.pop_back();
    } else {
      ++next_;
    }
  }

  [[nodiscard]] std::size_t size() const;

 private:
  static bool later(const Entry& a, const Entry& b) { return a.time > b.time; }

  template <class Wanted>
  void open_next(const Wanted& wanted) {
    ++present_;
    if (present_ + static_cast<std::int64_t>(buckets_.size()) / 2 >= year_end_) next_year(wanted);
    std::vector<Entry>& bucket = buckets_[static_cast<std::size_t>(present_) & mask_];
    ordered_.resize(bucket.size());
    next_ = 0;
    std::size_t kept = 0;
    for (const Entry& entry : bucket) {  // without a branch: which are wanted cannot be foreseen
      ordered_[kept] = entry;
      kept += wanted(entry) ? 1U : 0U;
    }
    ordered_.resize(kept);
    bucket.clear();
    put_in_order(ordered_);
  }

  /// By time; of few entries each is put where as many lie before it as are earlier, which takes
  /// more comparisons than to sort, and no branch.
  static void put_in_order(std::vector<Entry>& entries) {
    constexpr std::size_t kFew = 128;
    const std::size_t n = entries.size();
    if constexpr (std::is_integral_v<Time>) {
      if (n <= kFew) {
        std::array<Entry, kFew> few;
        std::array<Time, kFew> times;
        std::array<Time, kFew> places{};
        for (std::size_t k = 0; k < n; ++k) {
          few[k] = entries[k];
          times[k] = entries[k].time;
        }
        for (std::size_t j = 0; j < n; ++j) {
          const Time time = times[j];
          for (std::size_t k = 0; k <= j; ++k) places[k] += time < times[k] ? 1 : 0;
          for (std::size_t k = j + 1; k < n; ++k) places[k] += time <= times[k] ? 1 : 0;
        }
        for (std::size_t k = 0; k < n; ++k) entries[static_cast<std::size_t>(places[k])] = few[k];
        return;
      }
    }
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return a.time < b.time; });
  }

  template <class Wanted>
  void next_year(const Wanted& wanted) {
    year_end_ += static_cast<std::int64_t>(buckets_.size()) / 2;
    std::size_t kept = 0;
    for (const Entry& entry : far_) {
      if (!wanted(entry)) continue;
      const std::int64_t number = Clock::steps(entry.time - origin_, shift_);
      if (number < year_end_) {
        buckets_[static_cast<std::size_t>(number) & mask_].push_back(entry);
      } else {
        far_[kept++] = entry;
      }
    }
    far_.resize(kept);
  }

  Time origin_ = 0;
  int shift_ = 0;
  std::size_t mask_ = 0;
  std::int64_t present_ = 0;   ///< number of the bucket that is open
  std::int64_t year_end_ = 0;  ///< number of the first bucket whose entries are in `far_`
  std::vector<std::vector<Entry>> buckets_;
  std::vector<Entry> ordered_;  ///< the open bucket, in order of time from `next_` on
  std::size_t next_ = 0;
  std::vector<Entry> late_;  ///< a heap: added to the open bucket after it was put in order
  std::vector<Entry> far_;
  bool taking_late_ = false;
};

}  // namespace carom::event
