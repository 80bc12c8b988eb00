#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "carom/crew.hpp"
#include "numbers/exact_sum.hpp"
#include "solvers/event/domains/block_flight.hpp"
#include "solvers/event/domains/block_sort.hpp"
#include "solvers/event/domains/blocks.hpp"
#include "solvers/event/domains/domain_loop.hpp"
#include "solvers/event/domains/halo_width.hpp"
#include "solvers/event/domains/window_span.hpp"
#include "solvers/event/event_loop.hpp"

namespace carom::event {

/// Balls solved window by window in domains of the plane, with the bits that one event loop over
/// all balls has.
///
///     wall_computation    each worker: its share of the flights, sorted into blocks of the plane
///     pair_computation    each worker: its domains, each an event loop over the balls it owns and
///                         those of a halo around them
///     pair_resolution     each worker: compares the halos of its domains with their owners
///
/// Domains whose halo differs are solved again with a wider one, until none differs.  All that
/// lasts from one window to the next is a flight for each ball.
///
/// Why the bits are those of one event loop.  Suppose that nothing differs any more, and let T be
/// the first moment at which an owner has its ball do something else than one event loop would.
/// What a ball does at T follows from the flights, up to T, of itself and of a ball that it meets
/// then; owners have the true ones up to T.  From the start of the window both have gone no
/// farther than their owners' `displacement`.  So at the start the other was no farther from what
/// the domain owns than those two displacements and the radii: `check` made sure that all balls so
/// near were loaded, followed to the end of the window, and did the same there as at their owners.
/// So the domain had the true flights of both up to T, and both in its lists.  Nor did it have the
/// ball meet another that was not truly there: that one would have come from so near, by its
/// displacement in the domain, and been found to differ.  So it had the ball do the true thing,
/// against the assumption.  What shares an instant is not done by domains at all.
/// Halos, windows and domains do not matter for the result: they decide what it costs.
///
/// A window in which impacts share an instant and a ball is solved by one EventLoop of all balls,
/// from the same flights.
///
/// With few balls and one worker there is one domain without a halo; its window goes on over
/// frames.
///
/// How flights are sorted: block_sort.hpp; how long a window is: window_span.hpp; how wide a halo:
/// halo_width.hpp; how a domain is solved: domain_loop.hpp.
///
/// Threads: `work` for the workers; the other members while no phase runs.
template <class P>
class Domains {
 public:
  using Disk = typename P::Disk;

  explicit Domains(const BasicRules<double>& rules);

  /// Takes these flights, the balls in their order; `now` is not before any of their starts.
  /// `spins`: of the balls; empty: none.  `lefts`: the fixed ball at which each began, or kUnknown;
  /// empty: none.
  void reset(const std::vector<Disk>& flights, FixedTime now, const std::vector<double>& spins,
             const std::vector<Index>& lefts = {});
  void set_workers(std::size_t workers);
  /// No window is longer, from the next `reset` on.
  void limit_windows(FixedTime longest) { wanted_longest_ = longest; }
  /// See HaloWidth.
  void follow_beyond(double diameters) { halo_width_.follow_beyond(diameters); }
  /// Gives the number of the phase to start with, Phase::kFrameDone where `until` is now.
  [[nodiscard]] std::size_t aim(FixedTime until);
  /// Counts time from `by` ticks later on.
  void rebase(FixedTime by);

  enum : std::size_t { kSort, kSolve, kCheck, kPhases };
  void work(std::size_t phase, Share share);
  /// What comes next: a phase, or Phase::kFrameDone when all is done up to the aim.
  [[nodiscard]] std::size_t finish(std::size_t phase);

  [[nodiscard]] FixedTime now() const { return now_; }
  [[nodiscard]] Disk flight(std::size_t ball) const;
  /// What `flight` reads, ahead.
  void fetch(std::size_t ball) const;
  [[nodiscard]] double spin(std::size_t ball) const;
  /// The fixed ball at which its flight began; kUnknown: none.
  [[nodiscard]] Index left(std::size_t ball) const;
  [[nodiscard]] const Motion<P>& motion() const { return *motion_; }
  [[nodiscard]] Counts counts() const;
  [[nodiscard]] Costs costs() const;
  /// The energy that impacts have taken since `reset`, and drag from flights that are over; nothing
  /// where only drag takes any.
  [[nodiscard]] std::vector<double> losses() const;
  /// Windows are so often none for domains that another way is faster, or a ball has come to rest,
  /// which only the other ways go on with.
  [[nodiscard]] bool stuck() const { return stuck_; }

  [[nodiscard]] std::uint64_t windows() const { return windows_; }
  /// Domains solved again.
  [[nodiscard]] std::uint64_t solved_again() const { return again_; }
  [[nodiscard]] std::size_t domains() const { return regions_.size(); }
  [[nodiscard]] std::size_t bytes() const;
  /// About so many, without having any: of all flights, and of the domains that workers solve.
  static std::size_t bytes_of_flights(std::size_t balls, std::size_t workers, bool spins);
  static std::size_t bytes_of_workers(std::size_t balls, std::size_t workers);

 private:
  /// What a domain knows of a ball of its halo.
  struct Ghost {
    std::uint64_t history;
    Index memory;
    float distance;
    float displacement;
    bool followed;
  };
  /// What lasts of a domain in the window.
  struct Region {
    BlockRange blocks;
    std::array<int, 2> halo{0, 0};  ///< in blocks; 0: all of the axis is loaded
    double wider = 1;               ///< than other halos, as it had to be solved again
    double reach = 0;               ///< of its halo
    double radius = 0;              ///< the largest of its balls
    bool covers = false;            ///< its halo is all there is
    bool unusual = false;
    bool differs = false;
    float displacement = 0;  ///< the largest of its balls
    typename DomainLoop<P>::Tally tally;
    std::vector<Ghost> ghosts;
  };
  /// What the owner of a ball knows of it in the window.
  struct Outcome {
    std::uint64_t history = 0;
    float displacement = 0;
  };
  struct alignas(128) Workspace {
    std::unique_ptr<DomainLoop<P>> domain;
    double seconds = 0;
    Costs beside_pairs;
  };

  [[nodiscard]] bool alone() const { return regions_.size() == 1; }
  // The start: domains_start_body.hpp.
  void decompose();
  void choose_radii(const std::vector<Disk>& flights);
  [[nodiscard]] WindowSpan::Gas gas_of(const std::vector<Disk>& flights) const;

  // The phases: domains_body.hpp.
  [[nodiscard]] std::size_t begin_window();
  [[nodiscard]] typename DomainLoop<P>::Memory memory_of_domains() const;
  void scatter(Share share);
  void solve_alone(Workspace& workspace);
  [[nodiscard]] std::size_t end_window();
  void solve_by_one_loop();
  /// Whether something carries a ball at the end of the window: domains know of no such balls.
  [[nodiscard]] bool any_rests() const;
  void close_window();
  void number_balls() const;  // domains_state_body.hpp

  // Several domains: domains_halo_body.hpp.
  void solve(Region& region, Workspace& workspace);
  void load_halo(const Region& region, DomainLoop<P>& domain) const;
  [[nodiscard]] DomainWindow window_of(Region& region) const;
  void keep(Region& region, DomainLoop<P>& domain);
  void check(Region& region) const;
  [[nodiscard]] std::size_t judge();
  void add_tally(const typename DomainLoop<P>::Tally& tally);

  std::shared_ptr<const Motion<P>> motion_;
  double normal_radius_ = 0;
  double spacing_ = 1;
  double skin_ = 1;
  double balls_of_domain_ = 1;
  std::size_t workers_ = 1;
  std::size_t movers_ = 0;

  std::unique_ptr<Blocks> blocks_;
  std::vector<Region> regions_;
  std::vector<std::size_t> to_solve_;
  std::atomic<std::size_t> taken_{0};  ///< of these
  std::vector<Workspace> workspaces_{1};

  HugeVector<BlockFlight> flights_;  ///< at the start of the window, by block
  HugeVector<BlockFlight> next_;     ///< at its end, in the same order
  std::vector<double> spins_;
  std::vector<double> next_spins_;
  std::vector<Index> lefts_;  ///< as of DomainLoop; empty where it does not matter
  std::vector<Index> next_lefts_;
  std::vector<Outcome> outcomes_;
  BlockSort<P> sort_;
  mutable std::vector<Index> memory_;  ///< where each ball is; empty: not looked for yet

  FixedTime from_ = 0;  ///< the start of the window
  FixedTime now_ = 0;
  FixedTime until_ = 0;  ///< its end
  FixedTime target_ = 0;
  WindowSpan span_{motion_->rules().scale};
  HaloWidth halo_width_;
  FixedTime wanted_longest_ = kNever;
  bool counted_ = false;
  bool open_ = false;  ///< one domain: its window is not at its end
  bool by_one_loop_ = false;
  bool stuck_ = false;
  std::uint32_t odd_windows_ = 0;
  std::size_t tried_again_ = 0;  ///< domains, in this window

  Counts counts_;
  std::uint64_t halves_ = 0;  ///< of impacts between balls: one for each of the two
  ExactSum<double> lost_;
  std::uint64_t windows_ = 0;
  std::uint64_t again_ = 0;
};

}  // namespace carom::event
