#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "carom/scene.hpp"

namespace carom::scene {

/// How deep two disks are in each other, a length; 0 or less where they are apart or touch.
/// Touching is judged with an allowance for the rounding of the coordinates, a few units in their
/// last places, so that touching balls may be written in decimals.
double overlap_depth(const Box& box, const Vec2& a, double radius_a, const Vec2& b,
                     double radius_b);

/// Disks by place: finds those that a disk would overlap without looking at all of them.
/// Disks of like size, to a power of two, share a grid with cells a little wider than they are.
/// Scaling a scene by a power of two changes nothing.
class DiskGrid {
 public:
  explicit DiskGrid(const Box& box) : box_(box) {}

  /// Disks are numbered in the order in which they are put in.
  void insert(const Vec2& position, double radius);
  /// The numbers of the disks that overlap this one, in no order; at most so many.
  [[nodiscard]] std::vector<std::size_t> overlapping(const Vec2& position, double radius,
                                                     std::size_t at_most) const;
  [[nodiscard]] bool is_free(const Vec2& position, double radius) const;
  [[nodiscard]] std::size_t size() const { return disks_.size(); }

 private:
  using Cell = std::array<std::int64_t, 2>;
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  struct Disk {
    Vec2 position;
    double radius = 0;
    Cell cell{0, 0};
    std::uint32_t next = kNone;  // in the same bucket of its level
  };
  struct Level {
    int exponent = 0;                          // 2^exponent <= radius < 2^(exponent + 1)
    double per_length = 0;                     // cells to a length
    std::array<std::int64_t, 2> around{0, 0};  // cells around a periodic axis; 0: not periodic
    double largest = 0;                        // radius
    bool widest = false;                       // the cells take any disk of the level
    std::size_t count = 0;
    std::vector<std::uint32_t> buckets;
  };

  [[nodiscard]] Cell cell_of(const Level& level, const Vec2& position) const;
  void set_width(Level& level, double width) const;
  static std::size_t bucket(const Level& level, const Cell& cell);
  void put_into_bucket(Level& level, std::uint32_t number);
  void sort_anew(Level& level, std::size_t buckets);
  /// Calls `found` for each overlapping disk until it returns true.
  template <class Found>
  void visit(const Vec2& position, double radius, Found found) const;

  Box box_;
  std::vector<Disk> disks_;
  std::vector<Level> levels_;
};

}  // namespace carom::scene
