#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "carom/crew.hpp"
#include "contact/cell_grid.hpp"
#include "contact/pair_list.hpp"
#include "state/balls.hpp"
#include "state/domain.hpp"

namespace carom::overlap {

/// The pairs that method `overlap` looks at in a step: all of them, cached once, where there are
/// few balls; else a Verlet list of neighbours, each worker with its part.
///
/// The list holds until a ball has moved half the skin since it was made. Every choice gives the
/// same result.
///
/// Threads: `note_moves`, `search` and `find_touching` each by one worker; the rest by one thread.
class PairSearch {
 public:
  enum class Pairs { automatic, all, neighbours };

  PairSearch(const Balls& balls, const Domain& domain, Pairs pairs)
      : balls_(balls), domain_(domain), choice_(pairs) {}
  PairSearch(const PairSearch&) = delete;
  PairSearch& operator=(const PairSearch&) = delete;

  /// Forgets the list.
  void set_workers(std::size_t workers);
  void forget();
  /// Balls closer than this factor of the sum of their radii count as touching.
  void stretch(double factor) { stretch_ = factor; }

  /// Caches all pairs, unless there is a list for that or they are cached.
  void cache_all_pairs();
  [[nodiscard]] bool uses_list() const;
  /// There is a list, stale or not.
  [[nodiscard]] bool listed() const { return listed_; }
  [[nodiscard]] bool is_stale() const;

  /// What a worker has noted of moves is forgotten.
  void begin_moves(std::size_t worker) { workers_[worker].moved_square = 0; }
  /// Notes how far the balls [begin, end), Flight::kBlock at the most, have moved since the list
  /// was made.
  void note_moves(std::size_t worker, std::size_t begin, std::size_t end);

  /// Sorts the balls into cells, for a list whose parts `search` then finds.
  void sort(double step);
  void search(Share share);
  /// Both, by one thread.
  void build(double step);

  /// Appends a worker's pairs that touch, and gives the deepest overlap; see contact/touching.hpp.
  double find_touching(Share share, std::vector<Pair>& touching) const;
  /// All pairs that touch, or, without stretch, overlap, in rising order.
  [[nodiscard]] std::vector<Pair> all_touching() const { return all_within(stretch_); }
  [[nodiscard]] std::vector<Pair> all_overlapping() const { return all_within(1); }
  /// The same after balls were pushed: the list is renewed where they have gone too far for it.
  [[nodiscard]] std::vector<Pair> overlapping_after_pushes(double step);

 private:
  // What one worker writes, apart from what others write.
  struct alignas(128) Worker {
    PairList neighbours;
    double moved_square = 0;  // of the ball that has moved farthest since the list was made
  };

  [[nodiscard]] std::vector<Pair> all_within(double stretch) const;

  const Balls& balls_;
  const Domain& domain_;
  Pairs choice_;
  PairList all_pairs_;
  CellGrid grid_;
  std::array<Balls::Column, 2> anchor_;  // where the balls were when the list was made
  double skin_ = 0;
  double stretch_ = 1;
  double near_ = 0;  // how far apart balls are that touch by the stretch alone
  bool listed_ = false;
  std::vector<Worker> workers_;
};

}  // namespace carom::overlap
