#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "solvers/event/domains/approach.hpp"
#include "solvers/event/domains/block_flight.hpp"
#include "solvers/event/domains/bucket_queue.hpp"
#include "solvers/event/domains/cell_chains.hpp"
#include "solvers/event/domains/near_lists.hpp"
#include "solvers/event/domains/near_search.hpp"
#include "solvers/event/motion.hpp"
#include "solvers/event/sampled_costs.hpp"

namespace carom::event {

/// What a domain solves: a rectangle of the plane over a window of time.
struct DomainWindow {
  std::array<double, 2> middle{0, 0};
  std::array<double, 2> own{0, 0};      ///< half the sides of the rectangle whose balls it owns
  std::array<double, 2> loaded{0, 0};   ///< the same with its halo
  std::array<bool, 2> wraps{};          ///< the axis is periodic, and all of it is loaded
  std::array<bool, 2> whole{};          ///< all of the axis is loaded
  std::array<double, 2> lowest{0, 0};   ///< ends of the box, from the middle; where an axis is
  std::array<double, 2> highest{0, 0};  ///< periodic, no place is beyond
  bool halo = false;                    ///< balls may be loaded that the domain does not own
  double full = 0;   ///< balls of the halo no farther away are followed to the end,
  double reach = 0;  ///< those at this distance not at all, those between for part of the window
  double collisions = 1;  ///< that a ball has in it, about
  double skin = 0;        ///< balls are listed that can meet before either has gone this far
  FixedTime from = 0;
  FixedTime until = 0;
};

/// What a ball meets that is no ball, in the numbers of a domain: their last, as it is with Index.
constexpr Slot slot_mark(Index mark) {
  return static_cast<Slot>(mark);
}
inline constexpr Slot kFirstSlotMark = slot_mark(kFirstMark);

/// In single precision, and no greater.
/// REQUIRES: time >= 0.
inline float not_later(double time) {
  return static_cast<float>(time * (1 - 0x1p-23));
}

/// A domain: an event loop over some thousand balls and one window, all of it in the processor's
/// cache, made from flights alone and thrown away afterwards.
///
/// A ball keeps the earliest event that it is known to have; where its partner changes before, it
/// looks again then.  A pair is queued at a quick lower bound of its time (Approach).  Its exact
/// time, the same pure function that EventLoop uses, is worked out when that comes up, which for
/// most predictions is never.
///
/// What is rare is not done here: impacts of one instant that share a ball, or that are passed on
/// at once, and impacts after which two balls stay together or a wall supports one.  Then the
/// window is to be solved by EventLoop from the same flights.
///
/// Source: B. Lubachevsky, J. Comput. Phys. 94 (1991) 255: one event a ball.
template <class P>
class DomainLoop {
 public:
  using Disk = typename P::Disk;
  static constexpr std::size_t kMostBalls = 60000;
  static_assert(kMostBalls <= kFirstSlotMark);

  /// `normal_radius`: balls that are larger are few, and looked at one by one.
  DomainLoop(const Motion<P>& motion, double normal_radius);

  /// Of the flights to load from; they are to last until `start`.
  struct Memory {
    const BlockFlight* flights = nullptr;
    const double* spins = nullptr;  ///< null: balls have none
    const Index* lefts = nullptr;   ///< the number of the fixed ball at which each began, or
                                    ///< kUnknown; null: it does not matter
  };
  /// Forgets all balls.
  void begin(const DomainWindow& window, const Memory& memory);
  /// `memory`: the number of the flight.
  void load(Index memory, bool own);
  /// With all balls loaded.  False: the window is not for a domain.
  [[nodiscard]] bool start();
  /// Everything up to `until` has happened then.  False: the window is not for a domain.
  [[nodiscard]] bool advance_to(FixedTime until);

  [[nodiscard]] const DomainWindow& window() const { return window_; }
  [[nodiscard]] std::size_t size() const { return flights_.size(); }
  [[nodiscard]] const BlockFlight& flight(std::size_t k) const { return flights_[k]; }
  [[nodiscard]] const double* spin(std::size_t k) const {
    return spins_.empty() ? nullptr : &spins_[k];
  }
  /// The number of the fixed ball at which its flight began; kUnknown: none.
  [[nodiscard]] Index left(std::size_t k) const { return lefts_.empty() ? kUnknown : lefts_[k]; }
  [[nodiscard]] Index memory(std::size_t k) const { return memories_[k]; }
  [[nodiscard]] bool owns(std::size_t k) const { return sides_[k].own != 0; }
  /// It was followed to the end of the window.
  [[nodiscard]] bool followed(std::size_t k) const { return sides_[k].limit == kToTheEnd; }

  // Where there is a halo.
  /// Of everything that has happened to the ball in the window.
  [[nodiscard]] std::uint64_t history(std::size_t k) const { return tracks_[k].history; }
  /// Where it is at the end of the window, from the middle of the domain.
  [[nodiscard]] Vec<double> last_place(std::size_t k) const;
  /// How far it may have been from where it was at the start of the window; `last`: its last place.
  [[nodiscard]] float displacement(std::size_t k, const Vec<double>& last);
  /// From what the domain owns to where the ball was at the start; its radius, where it is larger
  /// than normal, taken off.
  [[nodiscard]] float distance(std::size_t k) const { return tracks_[k].distance; }

  /// Impacts of own balls; between two balls each counts one for either.
  struct Tally {
    std::uint64_t ball_halves = 0;
    std::uint64_t walls = 0;
    double max_overlap = 0;
    std::uint64_t events = 0;
    std::uint64_t predictions = 0;
    std::uint64_t stale = 0;
    std::uint64_t renewals = 0;
    std::vector<double> lost;  ///< energy, by impact
    Costs costs;               ///< of all but pairs, from a sample of the events
  };
  [[nodiscard]] const Tally& tally() const { return tally_; }
  [[nodiscard]] std::size_t bytes() const;
  /// Of one ball in it, about.
  static constexpr std::size_t bytes_of_ball() {
    constexpr std::size_t kCellAndQueue = 40;
    return sizeof(Loaded) + sizeof(BlockFlight) + sizeof(Path) + sizeof(Side) + sizeof(Track) +
           sizeof(Index) + NearLists::kBytesOfBall + NearSearch::kBytesOfBall + kCellAndQueue;
  }

 private:
  static constexpr float kToTheEnd = std::numeric_limits<float>::infinity();
  static constexpr std::uint8_t kAtWall = 1;   ///< a wall may be within its circle
  static constexpr std::uint8_t kFar = 2;      ///< its flight may have to start again in the window
  static constexpr std::uint8_t kAtFixed = 4;  ///< it falls, and a fixed ball is in its list
  /// What a ball is about to do.  Times are seconds from the start of the window.
  struct alignas(32) Side {
    float x = 0;  ///< middle of its safe circle
    float y = 0;
    double leaves = 0;          ///< when it leaves that
    float others = 0;           ///< nothing else comes before, where its event is at a bound
    float limit = kToTheEnd;    ///< it is not followed for longer
    std::uint16_t changes = 0;  ///< flights that it has begun
    std::uint16_t partner_changes = 0;   ///< what its partner had, when that was found
    Slot partner = slot_mark(kUnknown);  ///< of its event
    bool own : 1 = false;
    bool fixed : 1 = false;
    bool bounded : 1 = false;  ///< its event is at a lower bound of its time
    bool by_end : 1 = true;    ///< others in its list may be in another image
    std::uint8_t reasons = 0;  ///< of kAtWall, kFar, kAtFixed: its event is never at a bound
    [[nodiscard]] bool exactly() const { return reasons != 0; }
    [[nodiscard]] bool has(std::uint8_t reason) const { return (reasons & reason) != 0; }
    void set(std::uint8_t reason, bool holds) {
      reasons = static_cast<std::uint8_t>((reasons & ~reason) | (holds ? reason : 0));
    }
  };
  static_assert(sizeof(Side) == 32);
  /// What is compared with other domains.
  struct Track {
    std::uint64_t history = 0;
    float x = 0;  ///< where it was at the start of the window
    float y = 0;
    float square = 0;  ///< of the largest distance from there so far
    float distance = 0;
  };
  struct Loaded {
    float x;  ///< middle of its circle
    float y;
    Index memory;
    std::uint32_t cell;
    float distance;
    float limit;
    bool own;
  };
  static constexpr Index partner_of(const Side& side) {
    return side.partner < kFirstSlotMark ? Index{side.partner} : Index{side.partner} | 0xffff0000U;
  }

  // Loading: domain_load_body.hpp.
  [[nodiscard]] Path path_at_start(const BlockFlight& flight) const;
  void sort_into_slots();
  [[nodiscard]] bool any_rests() const;
  void list_all();
  void first_events();

  // Events: domain_loop_body.hpp.
  [[nodiscard]] double seconds(FixedTime time) const {
    return motion_.rules().scale.seconds(time - window_.from);
  }
  [[nodiscard]] double radius(Slot i) const { return motion_.species(flights_[i]).radius; }
  [[nodiscard]] double* spin_of(Slot i) { return spins_.empty() ? nullptr : &spins_[i]; }
  [[nodiscard]] Vec<double> place(Slot i, FixedTime now) const;
  [[nodiscard]] Vec<double> velocity(Slot i, FixedTime now) const;
  void note_change(Slot i, FixedTime now);
  void note_place(std::size_t i, double x, double y);
  void handle(Slot i, FixedTime now);
  void time_event(Slot i, FixedTime now);
  void meet(Slot i, Slot j, FixedTime now);
  /// Whether an impact of the two begins a contact that lasts.
  [[nodiscard]] bool sticks(Slot i, Slot j, FixedTime now) const;
  /// Whether the flight that has just begun is one that a wall supports.
  [[nodiscard]] bool rests_on_wall(Slot i) const;
  [[nodiscard]] bool rests_on_fixed(Slot i, Slot fixed) const;
  void end_flight(Slot i, FixedTime now);
  void fly_on(Slot i, FixedTime now);
  [[nodiscard]] Vec<double> ahead(const Vec<double>& v) const;
  void choose_circle(Slot i, FixedTime now);
  void renew(Slot i, FixedTime now);
  [[nodiscard]] double exit(Slot i, FixedTime now) const;
  void predict(Slot i, FixedTime now);
  void predict_both(Slot i, Slot j, FixedTime now);
  [[nodiscard]] Approach::Earliest earliest(Slot i, double since) const;
  [[nodiscard]] double straightened(double since) const;
  void settle(Slot i, Meeting<P> best, FixedTime now);
  void predict_exactly(Slot i, FixedTime now);
  void note_fixed(Slot i);
  void meet_fixed(Slot i, FixedTime now, double soonest, Meeting<P>& best);
  [[nodiscard]] bool may_reach(Slot i, Slot fixed, FixedTime now, double wait) const;
  void keep_bound(Slot i, double first, double others, Slot partner, FixedTime now);
  [[nodiscard]] bool make_exact(Slot i, FixedTime& now, FixedTime until);
  void queue(Slot i, FixedTime time);
  [[nodiscard]] FixedTime pair_event(Slot i, Slot j) const;
  [[nodiscard]] bool flies_far(const BlockFlight& flight, FixedTime until) const;
  void note_walls(Slot i);
  void note_ends(Slot i);

  const Motion<P>& motion_;
  double normal_radius_;
  double smallest_radius_ = 0;
  bool bends_;
  bool walls_;
  bool contacts_last_;           ///< gravity presses balls together that may come to rest
  bool books_flights_;           ///< what drag takes from a flight is counted when it ends
  bool falls_on_fixed_ = false;  ///< gravity acts, and some balls are fixed
  bool mixed_ = false;
  bool tracked_ = false;  ///< there may be a halo
  DomainWindow window_;
  double end_ = 0;                   ///< of the window, seconds from its start
  double skin_square_ = 0;           ///< a little less
  double near_ = 0;                  ///< lists reach so far beyond the two radii
  std::array<double, 2> periods_{};  ///< of the periodic axes
  std::array<double, 2> per_period_{};
  std::array<double, 2> inside_{};    ///< from the middle: circles there are not by an end
  std::array<double, 2> farthest_{};  ///< that a flight may go
  std::array<double, 2> slow_{};      ///< no flight goes so far that begins slower in the window
  std::array<double, 2> pull_{};      ///< half of what gravity pulls with, either way
  Approach approach_;
  double bend_ = 0;             ///< how far gravity bends a flight in the window
  double bend_per_square_ = 0;  ///< the same by the square of the time
  double slack_ = 0;            ///< of Approach
  Memory memory_;               ///< what is loaded from
  HugeVector<Loaded> loading_;
  HugeVector<BlockFlight> flights_;
  HugeVector<Path> paths_;
  HugeVector<Side> sides_;
  HugeVector<Track> tracks_;  ///< where there is a halo
  HugeVector<Index> memories_;
  std::vector<double> spins_;
  std::vector<Index> lefts_;      ///< where it falls on fixed balls
  std::vector<double> radii_;     ///< where they differ
  std::vector<Slot> large_;       ///< balls larger than normal
  std::vector<Slot> around_;      ///< by `renew`: in the cells around a ball,
  NearLists::Gathered gathered_;  ///< and near to it
  NearLists lists_;
  CellChains cells_;
  BucketQueue queue_;
  NearSearch search_;
  std::vector<std::uint32_t> ends_;  ///< of each cell, in the order of slots
  bool unusual_ = false;
  Tally tally_;
};

}  // namespace carom::event
