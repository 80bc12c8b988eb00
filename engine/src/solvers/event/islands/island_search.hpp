#pragma once

#include <cstddef>
#include <vector>

#include "solvers/event/disk.hpp"
#include "solvers/event/huge_pages.hpp"
#include "solvers/event/islands/found_island.hpp"
#include "solvers/event/motion.hpp"
#include "solvers/event/neighbours.hpp"

namespace carom::event {

/// Finds contact islands: all balls that can be reached over near contacts of balls that are of an
/// island, or are about to be, and these contacts.
///
/// Holds: of many contacts the order is by place, which no numbering changes.
template <class P>
class IslandSearch {
 public:
  using S = typename P::Scalar;
  using Time = typename P::Time;
  using At = typename P::At;
  using Disk = typename P::Disk;
  using Island = FoundIsland<S>;

  /// What is known of the balls.
  struct Balls {
    const HugeVector<Disk>& disks;
    const std::vector<S>& spins;          ///< empty: they have none
    const Time& next_step;                ///< of islands; never(): none is stepped
    const std::vector<double>& left_out;  ///< see SteppedEnergy; empty: nothing is
  };

  /// All must outlive this.
  IslandSearch(const Motion<P>& motion, const Balls& balls, Neighbours<P>& neighbours)
      : motion_(motion),
        disks_(balls.disks),
        spins_(balls.spins),
        next_step_(balls.next_step),
        left_out_(balls.left_out),
        neighbours_(neighbours) {}

  /// There are `balls` balls.
  void reset(std::size_t balls) {
    number_.assign(balls, -1);
    joins_.assign(balls, 0);
    owner_.assign(balls, -1);
  }
  /// The islands that balls are of.  `until`: of those of many contacts, with what comes to them by
  /// then, if that is later than now.
  [[nodiscard]] std::vector<Island> of_step(const std::vector<Index>& balls, At now, Time until);
  /// The islands of groups of balls that meet something now; groups that share an island are one.
  /// Those of many contacts with what comes to them before the next step.
  [[nodiscard]] std::vector<Island> of_hits(const std::vector<std::vector<Index>>& groups, At now);

 private:
  /// Two that will meet.
  struct Coming {
    Index one, other;
    Time at;     ///< they meet
    bool close;  ///< they have a contact already
  };

  [[nodiscard]] Island of(const std::vector<Index>& balls, At now, Time until);
  /// Of the islands of many contacts the first that one of these balls is of; -1: of none.
  [[nodiscard]] int large_of(const std::vector<Island>& islands,
                             const std::vector<Index>& balls) const;
  /// Adds the island of these balls, with those of `islands` that it shares a ball with.
  void add(std::vector<Island>& islands, std::vector<Index> balls, At now, Time until);
  /// Nothing belongs to an island any more; drops those without balls.
  void finish(std::vector<Island>& islands);
  void join(Island& island, Index i, At now);
  void add_near(Island& island, std::size_t first, At now, bool joins);
  // island_coming_body.hpp
  /// The balls that fly near to one of the island, or meet one by `until`, and what does so with
  /// these; who meets whom is noted.
  void add_coming(Island& island, At now, Time until);
  void note_coming(Island& island, const Coming& pair) const;
  /// Where impacts lose energy: what comes faster than in a contact that lasts, and would close
  /// before the next step, bounces in this one.
  void note_bounces(Island& island) const;

  const Motion<P>& motion_;
  const HugeVector<Disk>& disks_;
  const std::vector<S>& spins_;
  const Time& next_step_;
  const std::vector<double>& left_out_;
  Time ends_ = P::Clock::never();  ///< when flights of what is stepped end; never(): unknown
  Neighbours<P>& neighbours_;
  std::vector<int> number_;  ///< in the island that is looked at; -1: none
  std::vector<char> joins_;  ///< it is of an island that is hit now
  std::vector<int> owner_;   ///< its island, of those that have been found; -1: none
};

}  // namespace carom::event
