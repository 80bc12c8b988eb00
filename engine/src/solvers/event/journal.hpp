#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "solvers/event/physics.hpp"

namespace carom::event {

/// What an impact adds to the counts, where it is counted with this ball.
struct JournalShare {
  std::uint32_t ball_ball_halves = 0;  ///< two for an impact that only this ball counts
  std::uint32_t ball_wall = 0;
  double overlap = 0;
  std::uint64_t group = 0;  ///< a fingerprint of all that touched, where more than two did
};

/// What has happened to the flights of a tile since a moment: enough to compare two tiles ball by
/// ball, and to take back what happened after any moment since.
template <class P>
class Journal {
 public:
  using S = typename P::Scalar;
  using Time = typename P::Time;
  using Disk = typename P::Disk;
  static constexpr Index kNone = 0xffffffffU;

  struct Flight {
    S x, y, vx, vy;
    Time start;

    explicit Flight(const Disk& disk)
        : x(disk.x), y(disk.y), vx(disk.vx), vy(disk.vy), start(disk.start) {}
    void restore(Disk& disk) const {
      disk.x = x;
      disk.y = y;
      disk.vx = vx;
      disk.vy = vy;
      disk.start = start;
    }
    [[nodiscard]] bool operator==(const Flight&) const = default;
  };

  using Share = JournalShare;

  struct Entry {
    Time time;
    Flight before;
    double overlap;
    Index ball;
    Index next;  ///< the ball's entry after this one
  };

  /// Whose a ball is.
  enum Role : char { kOwned, kShared, kCopy };

  /// REQUIRES: every ball noted later is below `slots`; they are all owned.
  void reset(std::size_t slots) {
    entries_.clear();
    renewed_.clear();
    shares_.clear();
    border_.clear();
    sum_ = {};
    first_.assign(slots, kNone);
    last_.assign(slots, kNone);
    roles_.assign(slots, kOwned);
  }
  void clear() {
    for (const Entry& entry : entries_) first_[entry.ball] = kNone;
    entries_.clear();
    renewed_.clear();
    shares_.clear();
    border_.clear();
    sum_ = {};
  }
  /// REQUIRES: nothing is noted of the ball.
  void set_role(Index ball, Role role) { roles_[ball] = role; }
  [[nodiscard]] Role role(Index ball) const { return roles_[ball]; }

  /// `after`: the flight that begins, where it is known already.
  void note(Index ball, const Disk& before, const Disk& after, typename P::At now,
            const Share& share) {
    const auto number = static_cast<Index>(entries_.size());
    entries_.push_back({now, Flight(before), share.overlap, ball, kNone});
    (first_[ball] == kNone ? first_[ball] : entries_[last_[ball]].next) = number;
    last_[ball] = number;
    note_speed(after);
    const Role role = roles_[ball];
    if (role != kOwned) border_.push_back(number);
    if (role != kCopy) add(share);
    if (share.ball_ball_halves != 1 || share.group != 0) shares_.emplace_back(number, share);
  }
  void note_speed(const Disk& disk) {
    const auto vx = static_cast<double>(disk.vx);
    const auto vy = static_cast<double>(disk.vy);
    fastest_square_ = std::max(fastest_square_, vx * vx + vy * vy);
  }
  void note_renewal(Index ball) { renewed_.push_back(ball); }
  /// Keeps the first `kept` entries.
  void shorten(std::size_t kept) {
    for (std::size_t k = kept; k < entries_.size(); ++k) first_[entries_[k].ball] = kNone;
    entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(kept), entries_.end());
    while (!border_.empty() && border_.back() >= kept) border_.pop_back();
    while (!shares_.empty() && shares_.back().first >= kept) shares_.pop_back();
    for (std::size_t k = kept; k-- > 0;) {
      Entry& entry = entries_[k];
      if (entry.next >= kept) {
        entry.next = kNone;
        last_[entry.ball] = static_cast<Index>(k);
      }
      first_[entry.ball] = static_cast<Index>(k);
    }
    sum_ = {};
    auto other = shares_.begin();
    for (std::size_t k = 0; k < kept; ++k) {
      Share share{1, 0, entries_[k].overlap, 0};
      if (other != shares_.end() && other->first == k) share = (other++)->second;
      if (roles_[entries_[k].ball] != kCopy) add(share);
    }
  }
  /// The fingerprint of the group of an entry.
  [[nodiscard]] std::uint64_t group(Index entry) const {
    if (shares_.empty()) return 0;
    const auto at =
        std::lower_bound(shares_.begin(), shares_.end(), entry,
                         [](const auto& share, Index number) { return share.first < number; });
    return at != shares_.end() && at->first == entry ? at->second.group : 0;
  }
  /// What all that is not of copies adds to the counts.
  [[nodiscard]] const Share& sum() const { return sum_; }
  /// Entries of copies and shared balls, in order.
  [[nodiscard]] const std::vector<Index>& border() const { return border_; }

  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  /// Balls whose squares were renewed, some of them more than once.
  [[nodiscard]] const std::vector<Index>& renewed() const { return renewed_; }
  /// The number of the ball's first entry, or kNone.
  [[nodiscard]] Index first(Index ball) const { return first_[ball]; }
  /// Of all flights noted since this was last set.
  [[nodiscard]] double fastest_square() const { return fastest_square_; }
  void set_fastest_square(double square) { fastest_square_ = square; }
  [[nodiscard]] std::size_t bytes() const {
    return entries_.capacity() * sizeof(Entry) +
           (renewed_.capacity() + 2 * last_.capacity()) * sizeof(Index);
  }

 private:
  void add(const Share& share) {
    sum_.ball_ball_halves += share.ball_ball_halves;
    sum_.ball_wall += share.ball_wall;
    sum_.overlap = std::max(sum_.overlap, share.overlap);
  }

  std::vector<Entry> entries_;                   ///< in the order of time
  std::vector<std::pair<Index, Share>> shares_;  ///< of entries that are not of a pair alone
  std::vector<Index> border_;
  std::vector<Role> roles_;
  Share sum_;
  std::vector<Index> renewed_;
  std::vector<Index> first_;
  std::vector<Index> last_;  ///< of balls that have a first
  double fastest_square_ = 0;
};

}  // namespace carom::event
