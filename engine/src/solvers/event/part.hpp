#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solvers/event/journal.hpp"
#include "solvers/event/regions.hpp"
#include "solvers/event/tile.hpp"

namespace carom::event {

/// A tile of the balls in one region of the plane, and of copies of the balls around it.
///
/// Each ball is owned by one part.  The copies fly on with what the part knows, and are checked
/// against their owners afterwards.
///
/// Threads: each part is one worker's; `check` and `admit` only read the other parts, which must
/// not change meanwhile.
template <class P>
class Part {
 public:
  using Disk = typename P::Disk;

  Part(const Rules& rules, std::size_t number, std::size_t parts);
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  /// Takes the balls of its region, and those within `halo` of it, from all flights, of which
  /// `places` are the places now.
  void reset(const Regions& regions, double halo, const std::vector<Disk>& flights,
             const std::vector<Vec<double>>& places, Ticks now);
  /// Tells all parts which of its balls they need from now on.  No ball has gone farther than
  /// `travelled` since the last time.
  void offer(const Regions& regions, double halo, double travelled, Ticks now);
  /// Takes what the others offer in place of the copies it has.
  void admit(const std::vector<const Part*>& parts, Ticks now);
  /// Corrects its copies as the last check found them, and goes on.
  void advance(Ticks from, Ticks until);
  /// Compares its copies with their owners over all since `advance` was told to begin.
  /// `speed` is more than that of any flight.
  void check(const std::vector<const Part*>& parts, double speed);
  /// Takes back what happened after `moment`.
  void undo(Ticks moment);
  void rebase(Ticks by);

  /// When a copy first differed that may have touched an owned ball since; kNever: none did.
  [[nodiscard]] Ticks differs() const { return differs_; }
  /// Of all flights it has had for some time.
  [[nodiscard]] double fastest_square() const { return journal_.fastest_square(); }
  /// What its own balls have gone through since `advance` was told to begin.
  [[nodiscard]] const JournalShare& impacts() const { return journal_.sum(); }
  /// Flights that began since then, those of copies too.
  [[nodiscard]] std::size_t events() const { return journal_.entries().size(); }

  [[nodiscard]] bool owns(Index ball) const {
    return slot_of_[ball] != kNobody && owner_[slot_of_[ball]] == number_;
  }
  [[nodiscard]] const Disk& flight(Index ball) const { return tile_.disks()[slot_of_[ball]]; }
  [[nodiscard]] const Tile<P>& tile() const { return tile_; }
  [[nodiscard]] const Journal<P>& journal() const { return journal_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  static constexpr Index kNobody = 0xffffffffU;
  static constexpr std::uint32_t kCorrected = 1U << 31;  // a mark on the owner, within `check`
  struct Offer {
    Disk flight;
    Index ball;
    std::uint32_t owner;
  };
  /// A flight of an owned ball of which others may have copies.
  struct News {
    typename Journal<P>::Flight after;
    Ticks time;
    std::uint64_t group;
    Index ball;
  };
  struct Correction {
    Index slot;
    Disk flight;
  };

  [[nodiscard]] Index slot_for(Index ball);
  void start(const std::vector<Disk>& disks, std::size_t more, Ticks now);
  void make_room(std::size_t more, Ticks now);
  void own(Index slot);
  void publish();
  [[nodiscard]] bool agrees(const News& news, Index slot) const;
  void correct(Index slot, Ticks differs, const Part& owner, double speed);

  std::uint32_t number_;
  Tile<P> tile_;
  Journal<P> journal_;
  std::vector<Index> slot_of_;  // by ball
  // By slot:
  std::vector<Index> ball_;
  std::vector<std::uint32_t> owner_;
  std::vector<char> owned_;
  std::vector<char> rim_;  // listed in rims_
  std::vector<std::uint32_t> stamp_;
  std::vector<Index> cursor_;  // the entry to compare next, where the stamp is this turn's

  std::vector<Index> copies_;  // slots of balls that others own
  std::vector<Index> rims_;    // slots of owned balls that may be near to other regions
  double depth_ = 0;           // no other owned ball is less deep inside the region
  std::vector<Index> free_;    // slots of nobody
  std::uint32_t turn_ = 0;
  Plot plot_;
  std::vector<std::vector<Offer>> offers_;  // by part
  std::vector<Correction> corrections_;
  std::vector<News> news_;
  std::vector<Index> copies_entries_;  // entries of copies
  Ticks until_ = 0;
  Ticks differs_ = kNever;
};

}  // namespace carom::event
