#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "solvers/event/disk.hpp"
#include "solvers/event/event_queue.hpp"
#include "solvers/event/event_rate.hpp"
#include "solvers/event/huge_pages.hpp"
#include "solvers/event/motion.hpp"

namespace carom::event {

/// When the next event of each ball is, and with what: its `meets` and `partner`, and the event
/// queue.
///
/// A meeting is kept with both of its balls; a fixed ball waits for no other, as it can be the
/// partner of many.  A ball whose partner is taken from it keeps the time, as nothing can happen to
/// it before, and is due then.
///
/// Holds: of two that move, each is the other's partner, at the same time, or neither is.
template <class P>
class EventSchedule {
 public:
  using Time = typename P::Time;
  using At = typename P::At;
  using Disk = typename P::Disk;
  using Entry = typename EventQueue<typename P::Clock>::Entry;

  /// Of these balls; both must outlive this.
  EventSchedule(const Motion<P>& motion, HugeVector<Disk>& disks)
      : motion_(motion), disks_(disks) {}

  /// Nothing is due.  The balls are in a box of this area.
  void reset(At now, double area) {
    queue_.reset(now, ticks_of_bucket(area), std::clamp<std::size_t>(disks_.size() / 64, 16, 4096));
  }
  /// Notes when the ball is due.
  void add(Index i) { queue_.add(disks_[i].due(), i); }
  /// The first that is due by `until`; null: nothing is.  `prepare`: see EventQueue::first.
  template <class Prepare>
  [[nodiscard]] const Entry* first(At until, const Prepare& prepare) {
    const auto is_due = [this](const Entry& entry) {
      return disks_[entry.ball].due() == entry.time;
    };
    for (;;) {
      const Entry* entry = queue_.first(until, is_due, prepare);
      if (entry == nullptr || is_due(*entry)) return entry;
      queue_.drop_first();
    }
  }
  /// Takes out what `first` gave.
  void drop_first() { queue_.drop_first(); }

  /// What a ball meets next, if anything; who had it or its partner loses them.
  void link(Index i, const Meeting<P>& meeting) {
    if (meeting.partner == kUnknown) return;
    unlink(i);
    disks_[i].meets = meeting.time;
    disks_[i].partner = meeting.partner;
    if (meeting.partner >= kFirstMark || motion_.fixed(disks_[meeting.partner])) return;
    unlink(meeting.partner);
    disks_[meeting.partner].meets = meeting.time;
    disks_[meeting.partner].partner = i;
  }
  /// The ball meets nothing that is known.
  void unlink(Index i) {
    const Index j = disks_[i].partner;
    disks_[i].partner = kUnknown;
    if (j < kFirstMark && disks_[j].partner == i) {
      disks_[j].partner = kUnknown;
      add(j);
    }
  }
  /// Nothing is known of what the ball meets.
  /// REQUIRES: it is no other's partner.
  void forget(Index i) {
    disks_[i].meets = P::Clock::never();
    disks_[i].partner = kUnknown;
  }

  /// Counts time from `by` ticks later on.
  void rebase(At by) {
    for (Disk& disk : disks_) {
      if (disk.meets != P::Clock::never()) disk.meets -= by;
      if (disk.leaves != P::Clock::never()) disk.leaves -= by;
    }
    queue_.rebase(by);
  }

 private:
  /// A bucket of the queue holds about as many: enough to fetch what they need ahead of time.
  static constexpr double kPerBucket = 64;

  // It decides how long a bucket is, and no result.
  [[nodiscard]] Time ticks_of_bucket(double area) const {
    using S = typename P::Scalar;
    BallsOfBox balls;
    balls.count = disks_.size();
    balls.area = area;
    balls.gravity = std::hypot(motion_.rules().gravity[0], motion_.rules().gravity[1]);
    for (const Disk& disk : disks_) {
      balls.add(static_cast<double>(motion_.species(disk).radius),
                static_cast<double>(S(disk.vx * disk.vx + disk.vy * disk.vy)));
    }
    const double rate = guessed_event_rate(balls);
    return rate > 0 ? motion_.rules().scale.ticks(kPerBucket / rate) : P::Clock::longest_flight();
  }

  const Motion<P>& motion_;
  HugeVector<Disk>& disks_;
  EventQueue<typename P::Clock> queue_;
};

}  // namespace carom::event
