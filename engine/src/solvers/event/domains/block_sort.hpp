#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "carom/crew.hpp"
#include "solvers/event/domains/block_flight.hpp"
#include "solvers/event/domains/blocks.hpp"
#include "solvers/event/huge_pages.hpp"
#include "solvers/event/motion.hpp"

namespace carom::event {

/// Sorts flights into the blocks of the plane that they are in at a time.
///
/// Each worker counts its share of the flights by block, then all know where theirs go, and each
/// puts its share there.  The order in a block is that before.
///
/// Threads: `count` and `scatter` for the workers, each of its own share; the others in between.
template <class P>
class BlockSort {
 public:
  /// No more workers share the work.
  static constexpr std::size_t kMostWorkers = 16;

  /// A ball that is larger than normal.
  struct Large {
    Index memory;
    int block;
  };

  /// Nothing is known of the flights.
  void reset(const Blocks& blocks, std::size_t workers) {
    counts_.resize(std::min(workers, kMostWorkers));
    starts_.assign(blocks.all() + 1, 0);
    known_ = false;
  }
  /// There are so many flights; their blocks may be set where they are known.
  void make_room(std::size_t flights) { block_of_.resize(flights); }
  void set_block(std::size_t flight, Index block) { block_of_[flight] = block; }
  /// All have been set, or not all are right any more.
  void set_known(bool known) { known_ = known; }

  void count(const Motion<P>& motion, const Blocks& blocks, const HugeVector<BlockFlight>& flights,
             FixedTime now, Share share) {
    if (share.index >= kMostWorkers) return;
    share.count = std::min(share.count, kMostWorkers);
    std::vector<Index>& counts = counts_[share.index];
    counts.assign(blocks.all(), 0);
    const std::size_t first = share.begin(flights.size());
    const std::size_t last = share.end(flights.size());
    if (!known_) {
      const bool bends = motion.bends();
      for (std::size_t k = first; k < last; ++k) {
        const Vec<double> at = place(motion, bends, flights[k], now);
        block_of_[k] = blocks.at(at.x, at.y);
      }
    }
    for (std::size_t k = first; k < last; ++k) ++counts[block_of_[k]];
  }
  void place_blocks() {
    Index sum = 0;
    for (std::size_t b = 0; b + 1 < starts_.size(); ++b) {
      starts_[b] = sum;
      for (std::vector<Index>& counts : counts_) sum += std::exchange(counts[b], sum);
    }
    starts_.back() = sum;
  }
  /// Calls put(k, at) for each flight of the share: flight k goes to `at`.
  template <class Put>
  void scatter(std::size_t flights, Share share, const Put& put) {
    if (share.index >= kMostWorkers) return;
    share.count = std::min(share.count, kMostWorkers);
    std::vector<Index>& to = counts_[share.index];
    for (std::size_t k = share.begin(flights); k < share.end(flights); ++k) {
      put(k, to[block_of_[k]]++);
    }
  }
  /// Finds those of the sorted flights whose balls are larger.
  void find_large(const Motion<P>& motion, const HugeVector<BlockFlight>& sorted,
                  double normal_radius) {
    large_.clear();
    if (!(motion.largest_radius() > normal_radius)) return;
    for (std::size_t b = 0; b + 1 < starts_.size(); ++b) {
      for (Index k = starts_[b]; k < starts_[b + 1]; ++k) {
        if (motion.rules().all_species[sorted[k].species].radius > normal_radius) {
          large_.push_back({k, static_cast<int>(b)});
        }
      }
    }
  }

  /// Of each block in the sorted flights, and their number.
  [[nodiscard]] const std::vector<Index>& starts() const { return starts_; }
  [[nodiscard]] const std::vector<Large>& large() const { return large_; }
  [[nodiscard]] std::size_t bytes() const {
    std::size_t entries = block_of_.capacity() + starts_.capacity();
    for (const std::vector<Index>& counts : counts_) entries += counts.capacity();
    return entries * sizeof(Index);
  }

 private:
  static Vec<double> place(const Motion<P>& motion, bool bends, const BlockFlight& flight,
                           FixedTime now) {
    if (flight.start == kEver) return {flight.x, flight.y};
    if (bends) return motion.place(flight, now);
    const double since = motion.rules().scale.seconds(now - flight.start);
    return {flight.x + since * flight.vx, flight.y + since * flight.vy};
  }

  std::vector<std::vector<Index>>
      counts_;                   ///< by worker: flights in each block, then where they go
  std::vector<Index> block_of_;  ///< of each flight
  std::vector<Index> starts_;
  std::vector<Large> large_;
  bool known_ = false;  ///< the blocks of all flights
};

}  // namespace carom::event
