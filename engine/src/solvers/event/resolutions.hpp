#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/disjoint_sets.hpp"
#include "solvers/event/counts.hpp"
#include "solvers/event/disk.hpp"
#include "solvers/event/energy_book.hpp"
#include "solvers/event/impact_notes.hpp"

namespace carom::event {

/// What has been resolved at one instant, group of balls by group, so that it can be taken back:
/// what each resolution has counted, booked and noted.
///
/// Resolutions that share a ball are taken back together, and no others.
///
/// Holds: after all are taken back, counts, losses and notes are as at the start of the instant.
/// The flights of the balls are not kept here: see FlightsBefore.
class Resolutions {
 public:
  /// All must outlive this.
  Resolutions(Counts& counts, EnergyBook& book, ImpactNotes& notes)
      : counts_(counts), book_(book), notes_(notes) {}

  /// Forgets all; there are `balls` balls.
  void reset(std::size_t balls);
  /// What was resolved stays resolved.
  void begin_instant() {
    for (const Index i : balls_) number_of_[i] = -1;
    balls_.clear();
    resolutions_.clear();
    book_.begin_simultaneous();
  }

  /// What is counted, booked and noted from here to `end` belongs to one group of balls.
  void begin() {
    const std::size_t number = resolutions_.size();
    sets_.make_room(number + 1);
    sets_.isolate(static_cast<std::uint32_t>(number));
    resolutions_.push_back({counts_, book_.kept(), notes_.lines(), {}, 0, 0});
  }
  void end() {
    Resolution& last = resolutions_.back();
    last.counts_after = counts_;
    last.kept_after = book_.kept();
    last.lines_after = notes_.lines();
  }
  /// The ball is one of the group.  Whether it was of none before.
  bool add(Index i) {
    const auto present = static_cast<std::uint32_t>(resolutions_.size() - 1);
    if (contains(i)) {
      sets_.merge(static_cast<std::uint32_t>(number_of_[i]), present);
      return false;
    }
    number_of_[i] = static_cast<int>(present);
    balls_.push_back(i);
    return true;
  }

  [[nodiscard]] bool any() const { return !balls_.empty(); }
  /// Whether the ball was in one.
  [[nodiscard]] bool contains(Index i) const { return number_of_[i] >= 0; }
  /// The balls of all of them.
  [[nodiscard]] const std::vector<Index>& balls() const { return balls_; }

  /// Those with one of these balls, and what shares balls with them; a flag for each set.
  class Chosen {
   public:
    explicit Chosen(std::size_t sets) : sets_(sets, 0) {}

   private:
    friend class Resolutions;
    std::vector<char> sets_;
  };
  [[nodiscard]] Chosen with(std::span<const Index> balls);
  [[nodiscard]] bool contains(const Chosen& chosen, Index i) {
    return contains(i) && chosen.sets_[set_of(i)] != 0;
  }
  /// Counts, losses and notes are as if these had not been; their balls are in none.
  void take_back(const Chosen& chosen);

 private:
  /// What one had changed, from its begin to its end.
  struct Resolution {
    Counts counts;
    std::size_t kept;   ///< by the book
    std::size_t lines;  ///< of the notes
    Counts counts_after;
    std::size_t kept_after;
    std::size_t lines_after;
  };
  [[nodiscard]] std::uint32_t set_of(Index i) {
    return sets_.find(static_cast<std::uint32_t>(number_of_[i]));
  }
  void take_back(Resolution& resolution);

  Counts& counts_;
  EnergyBook& book_;
  ImpactNotes& notes_;
  std::vector<Resolution> resolutions_;
  DisjointSets sets_;           ///< of those that share balls
  std::vector<Index> balls_;    ///< each once
  std::vector<int> number_of_;  ///< the resolution of a ball; -1: it is in none
};

}  // namespace carom::event
