#pragma once

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

#include "contact/pair_friction.hpp"
#include "contact/pair_impact.hpp"
#include "numbers/scalar.hpp"
#include "solvers/event/disk.hpp"
#include "solvers/event/islands/stepped_flight.hpp"
#include "solvers/event/lanes.hpp"
#include "solvers/event/meeting.hpp"
#include "solvers/event/physics.hpp"
#include "solvers/event/rules.hpp"
#include "solvers/event/solver_box.hpp"
#include "solvers/event/support.hpp"
#include "trajectory/pair_time.hpp"

namespace carom::event {

template <class S>
Vec<double> in_double(const Vec<S>& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

/// Flights and impacts: pure functions of one flight or two.
///
/// Holds: no result depends on when it is asked for, nor on the order of a pair.
template <class P>
class Motion {
 public:
  using S = typename P::Scalar;
  using Time = typename P::Time;
  using At = typename P::At;
  using Disk = BallFlight<S>;
  using Species = BasicSpecies<S>;
  using Rules = BasicRules<S>;

  explicit Motion(Rules rules);

  /// Where a flight is at `now`, not wrapped.
  [[nodiscard]] Vec<S> place(const Disk& disk, At now) const;
  [[nodiscard]] Vec<S> velocity(const Disk& disk, At now) const;
  /// Both at once.
  [[nodiscard]] Flight<S> at(const Disk& disk, At now) const;
  /// From a to b, the shorter way round periodic axes.
  [[nodiscard]] Vec<S> way(const Vec<S>& a, const Vec<S>& b) const;
  [[nodiscard]] Vec<S> wrapped(const Vec<S>& at) const;

  /// When two balls meet; one of them may be fixed.  `from_contact`: the flight of the one that is
  /// not fixed began with an impact of the two.
  /// May say never for a meeting after `until`.
  [[nodiscard]] Time pair_event(const Disk& a, const Disk& b, bool from_contact = false,
                                At until = P::Clock::never()) const;
  /// The same bits where flights are straight and neither ball is fixed or supported, quickly.
  [[nodiscard, gnu::always_inline]] Time straight_pair_event(const Disk& a, const Disk& b) const {
    const bool swap = b.start < a.start;
    const Disk& earlier = swap ? b : a;
    const Disk& later = swap ? a : b;
    const S elapsed = rules_.scale.seconds(later.start - earlier.start);
    const std::array<S, 2>& periods = box_.periods();
    const S x = multiply_add(S(-earlier.vx), elapsed, S(later.x - earlier.x));
    const S y = multiply_add(S(-earlier.vy), elapsed, S(later.y - earlier.y));
    const Vec<S> r{nearest(x, periods[0], S(periods[0] / 2)),
                   nearest(y, periods[1], S(periods[1] / 2))};
    const Vec<S> v{later.vx - earlier.vx, later.vy - earlier.vy};
    const Time ticks =
        rules_.scale.ticks(pair_time(r, v, S(species(a).radius + species(b).radius)));
    return ticks == P::Clock::never() ? ticks : Time(later.start + ticks);
  }
  /// When a ball meets a wall, or has flown so far that its flight starts again.
  /// May be later than it is where that is after `until`.
  /// `spin`: at the start of the flight; null where balls have none.
  [[nodiscard]] Meeting<P> alone(const Disk& disk, At until = P::Clock::never(),
                                 const S* spin = nullptr) const;
  /// Starts the flight again where it is at `now`.
  void carry(Disk& disk, At now, S* spin = nullptr) const;
  /// The spin at `now` of a ball that had this one at the start of its flight.
  [[nodiscard]] S spin_at(const Disk& disk, const S& spin, At now) const;
  /// `spin`: of the ball, counter-clockwise; null where balls have no friction.
  /// Gives the energy that the impact takes.
  double bounce(Disk& disk, S* spin, Index wall, At now) const;
  /// A jammed ball that has bounced off a wall stays there.  Where nothing is lost: if gravity
  /// presses it to the wall, so that it is back shortly; it goes along the wall with that.  Else:
  /// if its speed across is rounding of that along it.  Gives the energy that this takes.
  double end_bounce(Disk& disk, Index wall) const;
  struct Strike {
    double overlap;  ///< how deep the two overlapped, as a part of the smaller radius
    double lost;     ///< the energy that it takes
  };
  /// The impact of two balls.
  Strike strike(Disk& a, S* spin_a, Disk& b, S* spin_b, At now) const;
  /// What friction does in such an impact, to balls that are where they meet, r apart; gives the
  /// energy it takes.
  double apply_friction(Disk& a, S& spin_a, Disk& b, S& spin_b, const Vec<S>& r) const;
  /// The same at a wall, that the ball comes to at the speed `arrival`.
  double apply_wall_friction(Disk& disk, S& spin, std::size_t axis, int side,
                             const S& arrival) const;
  /// What drag, and friction with the walls it slides along, take from a flight till `now`; `spin`:
  /// at its start.
  [[nodiscard]] double flight_loss(const Disk& disk, const S* spin, At now) const;
  /// What a wall does to a ball that slides along it or turns against it.
  struct Slide {
    Index wall;
    double impulse;     ///< along the normal
    double tangential;  ///< that the ball loses, as in Impact
    double lost;        ///< the energy that it takes
  };
  /// The slides of a flight till `now`: none, one, or two in a corner.
  [[nodiscard]] std::vector<Slide> slides_of(const Disk& disk, const S* spin, At now) const;
  [[nodiscard]] bool loses_in_flight() const {
    return rules_.drag_rate > 0 || (rests_ && rules_.spins && rules_.wall_friction > 0);
  }

  [[nodiscard]] const Rules& rules() const { return rules_; }
  [[nodiscard]] const typename P::Law& law() const { return law_; }
  [[nodiscard]] const SolverBox<S>& box() const { return box_; }
  [[nodiscard]] const Species& species(const Disk& disk) const {
    return rules_.all_species[disk.species];
  }
  [[nodiscard]] bool fixed(const Disk& disk) const { return species(disk).fixed(); }
  [[nodiscard]] bool one_species() const { return plain_species_ == 1; }
  [[nodiscard]] double largest_radius() const { return largest_radius_; }
  [[nodiscard]] const std::array<S, 2>& periods() const { return box_.periods(); }
  /// How far along an axis a flight may go before it starts again; infinite where it may go on.
  [[nodiscard]] S farthest(std::size_t axis) const {
    return box_.periodic(axis) ? reach_[axis] : never<S>();
  }

  /// Gravity or drag acts.
  [[nodiscard]] bool bends() const { return bends_; }
  /// Contacts come to rest, as impacts lose energy or balls lie still.
  [[nodiscard]] bool rests() const { return rests_; }
  /// Gravity presses balls together whose contacts can come to rest.
  [[nodiscard]] bool contacts_last() const { return rests_ && pull_ > 0; }
  /// Balls lose energy that nothing presses together.
  [[nodiscard]] bool clusters() const { return rests_ && !(pull_ > 0); }
  /// Nothing loses energy along a normal: contacts rest only where nothing moves along it.
  [[nodiscard]] bool elastic() const { return elastic_; }
  /// The same of impacts alone: something else may take energy.
  [[nodiscard]] bool elastic_impacts() const { return elastic_impacts_; }
  /// Nothing loses energy but drag.
  [[nodiscard]] bool keeps_energy() const {
    return elastic_impacts_ && rules_.friction == 0 && rules_.wall_friction == 0;
  }
  /// It moves, and nothing carries it.
  [[nodiscard]] bool flies(const Disk& disk) const {
    return disk.species < plain_species_ && !fixed(disk);
  }

  /// What a ball flies by.
  [[nodiscard]] const typename P::Law& law_of(const Disk& disk) const {
    if (disk.species < plain_species_) [[likely]] {
      return law_;
    }
    return supported_laws_[species(disk).support];
  }

  /// The answer of the law that the ball flies by.
  template <class Question>
  [[nodiscard, gnu::always_inline]] auto ask(const Disk& disk, const Question& question) const {
    if constexpr (std::is_same_v<typename P::Law, BallisticLaw<S>>) {
      if (!bends_) return question(StraightLaw<S>{});
    }
    return question(law_of(disk));
  }

  /// How far a place is from touching a wall (negative: beyond), and where touching leaves it.
  struct Wall {
    S gap;
    S stop;
  };
  [[nodiscard]] Wall wall(const Disk& disk, const Vec<S>& at, Index wall) const;
  /// When it meets this wall.
  [[nodiscard]] Time wall_event(const Disk& disk, Index wall) const;

  /// Whether an impact of the two is one of ever more in ever less time; one may be fixed.
  [[nodiscard]] bool jammed(const Disk& a, const Disk& b, At now) const;

  // Contacts that rest, where rests(): motion_rest_body.hpp.
  /// What carries it: the axes along which walls do, 1 for x, 2 for y, or one of the above.
  [[nodiscard]] unsigned support(const Disk& disk) const { return species(disk).support; }
  void set_support(Disk& disk, unsigned axes) const {
    disk.species = static_cast<Index>(disk.species % plain_species_ + axes * plain_species_);
  }
  /// It is one of an island.
  [[nodiscard]] bool in_island(const Disk& disk) const { return support(disk) >= kResting; }
  /// It has been looked at together with those of its island that are near.
  [[nodiscard]] bool stepped(const Disk& disk) const {
    return support(disk) == kResting || support(disk) == kStepped;
  }
  /// Lets walls carry it where it touches them, is pressed to them and leaves them no more; on one
  /// with friction it slides or rolls.
  /// Gives the energy of the bounces that it no longer does.
  double support_on_walls(Disk& disk, S* spin) const;
  /// At the end of its slide: the spin of what rolls.
  void settle(const Disk& disk, S& spin) const;
  /// Puts what slides along a wall, and is above another by no more than the rounding of its place,
  /// at that one: lifted by rounding in each of its bounces, it would bounce for ever.
  void put_at_end(Disk& disk) const;
  /// The same on the very top of a fixed ball.
  double support_on_fixed_disk(Disk& disk, const Disk& fixed_disk) const;
  /// Rule 2: whether two that touch part no more: so slowly that the run cannot tell.
  [[nodiscard]] bool stays_together(const Vec<S>& r, const Vec<S>& v, const S& reach) const;
  [[nodiscard]] bool stay_together(const Disk& a, const Disk& b) const {
    return stays_together(way({a.x, a.y}, {b.x, b.y}), {b.vx - a.vx, b.vy - a.vy},
                          S(species(a).radius + species(b).radius));
  }
  /// Whether both have been hit within the clock's resolution, or little more.
  [[nodiscard]] bool collapses(const Disk& a, const Disk& b, At now) const;
  /// Rule 3: whether an impact of the two loses all, and they go on as an island; one of them may
  /// be fixed. r: from a to b.
  [[nodiscard]] bool sticks(const Disk& a, const Disk& b, const Vec<S>& r, At now) const;
  /// The same for a ball of an island that comes to a wall at this speed.
  [[nodiscard]] bool sticks_to_wall(const Disk& disk, const S& speed, At now) const;
  /// Islands are stepped every 2^this ticks.
  [[nodiscard]] int step_shift() const { return step_shift_; }
  /// What gravity makes in a step.
  [[nodiscard]] const S& speed_of_step() const { return speed_of_step_; }
  [[nodiscard]] const S& pull() const { return pull_; }
  /// The flight of what is stepped until the next step.
  [[nodiscard]] SteppedFlight stepped_flight(At start, At next) const;
  /// The same from one step to the next.
  [[nodiscard]] SteppedFlight whole_flight() const {
    return stepped_flight(Time(0), P::Clock::span(1, step_shift_));
  }
  /// Of one of an island; `next`: the step at which its flight ends.
  [[nodiscard]] GravityOfFlight gravity_of(const Disk& disk, At now, At next) const;
  /// The energy that gravity has given to what is stepped ahead of what it falls until the middle
  /// of its flight.
  [[nodiscard]] double given_ahead(const Disk& disk, At now, At next) const;
  /// The seconds of a step.
  [[nodiscard]] S seconds_of_step() const { return speed_of_step_ / pull_; }
  /// Rule 3, where nothing loses energy along a normal: two that slip past each other and approach
  /// faster meet at an impact.
  [[nodiscard]] S lasting_speed(const S& slip, const S& reach) const;

 private:
  void add_supported_species();
  void add_supported_laws();
  /// A ball on one wall with friction, and how it moves along it.
  struct Track {
    std::size_t along;  ///< axis
    int turns;          ///< a spin of 1 moves its lowest point by turns * radius along the axis
    S grip;             ///< the most that friction accelerates it
  };
  [[nodiscard]] Track track(unsigned axes) const;
  void grip(Disk& disk, S& spin) const;
  double support_in_corner(Disk& disk, const S& spin) const;
  /// What two walls do to a ball that turns between them.
  struct Corner {
    Vec<S> load;  ///< on the wall of either axis, for a mass of 1
    S slower;     ///< of the spin's size, in a second
  };
  [[nodiscard]] Corner corner(const Disk& disk, const S& spin) const;
  [[nodiscard]] bool slides(const Disk& disk) const {
    return support(disk) >= kSlides && support(disk) < kRolls;
  }
  /// Which way it slides: 1 or -1.
  [[nodiscard]] int slide_sign(const Disk& disk) const { return support(disk) % 2 == 1 ? 1 : -1; }
  /// How long it slides on.
  [[nodiscard]] S slide_wait(const Disk& disk, const S& spin) const;
  /// When two meet whose speeds fade at different rates.
  [[nodiscard]] S unlike_wait(const Disk& one, const Disk& other, const Relative<S>& relative,
                              const S& reach, At until) const;
  /// Rule 1: whether what leaves at v, pressed back by a, stays.
  [[nodiscard]] bool stays_down(const S& v, const S& a, const S& restitution, const S& reach) const;
  [[nodiscard]] S meeting_wait(const Disk& earlier, const Disk& later, const S& reach,
                               bool from_contact, At until) const;
  /// Whether a ball that touches a fixed one, r away, has just room between it and the wall that
  /// supports it: it goes on along both, however rounding puts it.
  [[nodiscard]] bool just_fits(const Disk& ball, const Vec<S>& r) const;
  /// Whether the step of their island has seen to it that they do not meet before the next one.
  [[nodiscard]] bool stepped_together(const Disk& a, const Disk& b) const;
  /// Rule 3: how far an impact may leave contacts to close until the next step, at least.
  [[nodiscard]] S left_open() const;
  /// Something carries it that can: a wall, or an island.
  [[nodiscard]] bool has_support(const Disk& disk) const;
  /// Whether it all but touches a wall.
  [[nodiscard]] bool is_at_wall(const Disk& disk, At now) const;
  [[nodiscard]] bool just_hit(const Disk& disk, const S& reach, const S& speed, At now,
                              const S& part) const;
  /// Of a ball that is stopped.
  [[nodiscard]] double moving_energy(const Disk& disk, const S& speed) const;
  [[nodiscard]] FrictionBody<S> friction_body(const Disk& disk, const S& spin) const;
  /// Whether it goes less than a quick bound says within `wait`, and so far it is from all that it
  /// can meet alone.
  [[nodiscard]] bool stays_clear(const Disk& disk, double wait) const requires kIsDouble<S>;
  [[nodiscard]] Meeting<P> wall_meeting(const Disk& disk, std::size_t axis, bool low,
                                        bool high) const;

  Rules rules_;
  typename P::Law law_;
  SolverBox<S> box_;
  std::array<S, 2> reach_;  ///< how far along a periodic axis a flight may go
  /// What it can meet alone, in lanes: sides that are there, and how far a flight may go.
  TwoLanes low_side_{};
  TwoLanes high_side_{};
  TwoLanes farthest_{};
  bool bends_ = false;
  bool rests_ = false;
  bool elastic_ = false;
  bool elastic_impacts_ = false;
  std::vector<typename P::Law> supported_laws_;  ///< by what carries
  double largest_radius_ = 0;
  std::size_t plain_species_ = 1;  ///< without what carries them
  S pull_ = 0;                     ///< gravity's size
  int step_shift_ = 0;
  S speed_of_step_ = 0;
};

}  // namespace carom::event
