#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "solvers/event/agenda.hpp"
#include "solvers/event/disk.hpp"
#include "solvers/event/huge_pages.hpp"
#include "solvers/event/motion.hpp"
#include "solvers/event/neighbours.hpp"

namespace carom::event {

/// What has happened so far.
struct Counts {
  std::uint64_t ball_ball = 0;
  std::uint64_t ball_wall = 0;
  std::uint64_t renewals = 0;  ///< squares left: neighbours listed anew
  std::uint64_t scans = 0;     ///< searches for the next impact of a ball
  std::uint64_t vain = 0;      ///< of them, because its partner had met another
  double max_overlap = 0;      ///< deepest overlap at an impact / smaller radius
};

/// Balls and their impacts in the order of time.
///
/// For each ball the earliest impact is kept that it is known to have; a pair is kept with the
/// first of its balls that has nothing earlier.  Whoever takes a ball from its partner leaves the
/// partner with a time before which nothing can happen to it, and that it is looked at again then.
///
/// Impacts of the same tick that share a ball, and those that a blow passes on to balls that touch,
/// are resolved together, by rules that do not see an order.
///
/// Holds: for every pair, the earlier of the two balls' `meets` is not after their impact.
/// Errors: std::runtime_error where impacts follow each other without time passing.
/// Source: B. Lubachevsky, How to simulate billiards and similar systems, J. Comput. Phys. 94
/// (1991) 255: one event a ball; A. Donev, S. Torquato, F. Stillinger, J. Comput. Phys. 202 (2005)
/// 737: lists of neighbours that events renew.
class Tile {
 public:
  explicit Tile(Rules rules);
  Tile(const Tile&) = delete;
  Tile& operator=(const Tile&) = delete;

  /// Takes these flights, the others are forgotten; `now` is not before any of their starts.
  /// `left`: the fixed ball at which each flight began, kUnknown where there is none; empty:
  /// nowhere.
  void reset(const std::vector<Disk>& disks, Ticks now, const std::vector<Index>& left = {});
  /// Everything up to `until` has happened then.
  void advance_to(Ticks until);
  /// Counts time from `by` ticks later on; nothing else changes.
  void rebase(Ticks by);

  [[nodiscard]] const HugeVector<Disk>& disks() const { return disks_; }
  /// The fixed ball at which a flight began; kUnknown where there is none or it does not matter.
  [[nodiscard]] Index left(Index i) const { return left_.empty() ? kUnknown : left_[i]; }
  [[nodiscard]] const Motion& motion() const { return motion_; }
  [[nodiscard]] const Counts& counts() const { return counts_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  void next_event(Index i, Ticks now);
  void meet(Index i, Ticks now);
  void meet_alone(Index i, Index partner, Ticks now);
  void forget(Index i);
  void look_again(Index i, Ticks now);
  void scan(Index i, Ticks now);
  template <bool kFalls>
  void look_at(Index i, const Index* others, std::uint32_t count, Ticks now, Meeting& best) const;
  void look_at(Index i, const Index* others, std::uint32_t count, Ticks now, Meeting& best) const;
  void look_at_pegs(Index i, const Index* others, std::uint32_t count, Meeting& best) const;
  void link(Index i, const Meeting& best);
  void unlink(Index i);
  void announce(Index i) { agenda_.add(disks_[i].due(), i); }
  void start_agenda(Ticks now);
  void fetch(std::span<const Agenda::Entry> entries, std::span<const Agenda::Entry> after) const;
  void watch(Ticks now);

  // Impacts of one instant that share a ball: tile_instant.cpp.
  struct Instant;
  void note_tie(Ticks at) const { ties_.insert(at); }
  [[nodiscard]] bool tied(Ticks now);
  void meet_jointly(Index i, Index partner, Ticks now);
  void add_member(Instant& instant, Index i, Ticks now) const;
  void add_contacts(Instant& instant, std::size_t member, Ticks now) const;
  [[nodiscard]] bool touch(Index i, Index j, Ticks now, const Vec<double>& r) const;

  Motion motion_;
  HugeVector<Disk> disks_;
  Neighbours neighbours_{motion_};
  Agenda agenda_;
  Counts counts_;
  std::vector<Index> left_;  ///< the fixed ball a flight began at; only where balls fall on pegs
  mutable std::set<Ticks> ties_;  ///< when two impacts may share a ball
  Ticks instant_ = 0;             ///< of the last impact
  std::size_t at_once_ = 0;       ///< impacts at that instant
};

}  // namespace carom::event
