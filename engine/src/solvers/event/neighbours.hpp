#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/cells.hpp"
#include "solvers/event/disk.hpp"
#include "solvers/event/huge_pages.hpp"
#include "solvers/event/motion.hpp"
#include "solvers/event/short_lists.hpp"

namespace carom::event {

/// For every ball the balls it may meet before either leaves the square around it.
///
/// A ball is listed with another where their squares are so near that the balls could touch.  When
/// a ball leaves its square it gets a new one, shifted the way it flies.
///
/// Holds: lists are mutual.  Squares and lists never change a result, only what is looked at.
/// Squares and distances are in double whatever the run computes in; when a flight leaves its
/// square is not.
template <class P>
class Neighbours {
 public:
  using Disks = HugeVector<typename P::Disk>;
  using Lists = ShortLists<14>;
  /// Its square, its cell, its list where that is not longer than most, and an entry of its cell's.
  static constexpr std::size_t kBytesOfBall = 2 * sizeof(double) + sizeof(std::uint32_t) +
                                              sizeof(Lists::Node) + sizeof(ShortLists<6>::Node);

  explicit Neighbours(const Motion<P>& motion)
      : motion_(motion),
        periods_{static_cast<double>(motion.periods()[0]),
                 static_cast<double>(motion.periods()[1])} {}

  void reset(const Disks& disks, typename P::At now);
  /// All balls that are within two of the largest radii of a place, and some others.
  [[nodiscard]] std::span<const Index> around(double x, double y);
  /// A new square and list for a ball; gives the neighbours it did not have before.
  [[nodiscard]] std::span<const Index> renew(const Disks& disks, Index i, typename P::At now) {
    return renew(disks, i, motion_.at(disks[i], now));
  }
  /// The same where it is known where the ball is and how fast.
  [[nodiscard]] std::span<const Index> renew(const Disks& disks, Index i,
                                             const Flight<typename P::Scalar>& here);
  /// When the ball leaves its square, or a little before.
  [[nodiscard, gnu::always_inline]] typename P::Time leaving(const typename P::Disk& disk, Index i,
                                                             typename P::At now) const {
    return leaving(disk, i, motion_.at(disk, now), now);
  }
  [[nodiscard]] typename P::Time leaving(const typename P::Disk& disk, Index i,
                                         const Flight<typename P::Scalar>& here,
                                         typename P::At now) const;

  [[nodiscard]] const Lists& lists() const { return lists_; }
  /// Half the side of a square.
  [[nodiscard]] double skin() const { return skin_; }

  /// Brings what belongs to a ball, or to the search around it, near to the processor.
  void fetch(Index i) const {
    __builtin_prefetch(&lists_.first(i));
    __builtin_prefetch(&centres_[i]);
  }
  void fetch_cells(Index i) const;
  void fetch_search(Index i) const;  ///< once the cells and its list are there

 private:
  using S = typename P::Scalar;

  struct Centre {
    double x, y;
  };

  [[nodiscard]] double radius(const typename P::Disk& disk) const {
    return static_cast<double>(motion_.species(disk).radius);
  }
  void choose_skin(const Disks& disks, double area);
  void set_square(const typename P::Disk& disk, Index i, const Flight<S>& here);
  [[nodiscard]] std::uint32_t cell_of(const Centre& at) const { return plane_.at(at.x, at.y); }
  [[nodiscard]] std::uint32_t gather(std::uint32_t cell);
  [[nodiscard]] std::uint32_t keep_near(const Disks& disks, Index i, std::uint32_t candidates);
  void list(const Disks& disks, Index i);
  template <class Visit>
  void each_cell_around(Index i, Visit visit) const;

  const Motion<P>& motion_;
  std::array<double, 2> periods_;
  double skin_ = 0;
  HugeVector<Centre> centres_;
  HugeVector<std::uint32_t> cell_;
  Lists lists_;
  Cells plane_;
  ShortLists<6> cells_;  ///< the balls of each
  std::vector<Index> found_;
  std::vector<Index> fresh_;
  std::uint32_t fresh_count_ = 0;
  std::vector<Index> gone_;
};

}  // namespace carom::event
