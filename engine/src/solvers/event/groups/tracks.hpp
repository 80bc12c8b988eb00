#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "contact/rest_rules.hpp"
#include "solvers/event/groups/path.hpp"
#include "solvers/event/groups/path_box.hpp"
#include "solvers/event/groups/path_meeting.hpp"
#include "solvers/event/groups/region_pairs.hpp"
#include "solvers/event/groups/spacing.hpp"
#include "solvers/event/groups/window_book.hpp"
#include "solvers/event/motion.hpp"

namespace carom::event {

/// What is known of all balls in the present window: their paths, the box that each path sweeps,
/// and the region around it for which pairs are listed.
///
/// Threads: those that are given different balls do not write what another one reads.
template <class P>
class Tracks {
 public:
  using S = typename P::Scalar;
  using Time = typename P::Time;
  using At = typename P::At;
  using Disk = typename P::Disk;
  using Path = typename Paths<P>::Path;
  using PathBall = typename PathMeeting<P>::Ball;

  struct Track {
    Segment<P> first;  ///< what it begins the window with
    Path path;         ///< from then on
    Bounds box;        ///< swept by its centre
    WindowOutcome outcome;
    bool changed = false;  ///< since the pairs were tested the last time
  };

  explicit Tracks(std::shared_ptr<const Motion<P>> motion) : motion_(std::move(motion)) {}

  /// Takes these flights at `now`; see ConflictGroups.  Gives the energy that walls take at once
  /// from balls that begin now and that they support.
  double reset(const std::vector<Disk>& flights, At now, const std::vector<Index>& left,
               const std::vector<S>& spins);
  /// The window begins with the flight that the one before has ended with.
  Track& begin(Index ball);
  /// The paths go from `now` to `until`.
  void set_box(Index ball, At now, At until);
  /// Makes the regions, wider than the boxes by `margin`.
  void set_regions(double margin);
  /// Counts time from `by` ticks later on.
  void rebase(At by);
  /// Balls that rest on this one, or carry it, move again.
  void wake_around(std::size_t ball, At now);

  [[nodiscard]] std::size_t size() const { return tracks_.size(); }
  [[nodiscard]] Track& operator[](std::size_t ball) { return tracks_[ball]; }
  [[nodiscard]] const Track& operator[](std::size_t ball) const { return tracks_[ball]; }
  [[nodiscard]] const Segment<P>& last(std::size_t ball) const { return tracks_[ball].path.back(); }
  [[nodiscard]] PathBall path_of(Index ball) const {
    return {ball, fixed_[ball] != 0, tracks_[ball].path};
  }
  /// Whether the ball flies on until then as if it were alone, and meets no wall.
  [[nodiscard]] bool flies_on(Index ball, At until) const;
  /// Whether its box is in its region.
  [[nodiscard]] bool inside_region(Index ball) const {
    return regions_[ball].contains(tracks_[ball].box, motion_->rules().domain.period);
  }
  /// The balls that are not fixed.
  [[nodiscard]] const std::vector<Index>& movers() const { return movers_; }
  [[nodiscard]] const std::vector<char>& fixed() const { return fixed_; }
  [[nodiscard]] const std::vector<double>& radii() const { return radii_; }
  [[nodiscard]] const std::vector<Bounds>& regions() const { return regions_; }
  [[nodiscard]] Spacing spacing() const;
  /// The energy that gravity has given to islands ahead of what they will have fallen at their next
  /// step.
  [[nodiscard]] double given_ahead(At now) const;

 private:
  double take(std::size_t ball, Segment<P> segment, At now);

  std::shared_ptr<const Motion<P>> motion_;
  std::vector<Track> tracks_;
  std::vector<Index> movers_;
  std::vector<char> fixed_;
  std::vector<double> radii_;
  std::vector<Bounds> regions_;
};

template <class P>
double Tracks<P>::reset(const std::vector<Disk>& flights, At now, const std::vector<Index>& left,
                        const std::vector<S>& spins) {
  const std::size_t n = flights.size();
  tracks_.assign(n, {});
  fixed_.assign(n, 0);
  radii_.resize(n);
  regions_.resize(n);
  movers_.clear();
  double lost = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Index began_at = left.empty() ? kUnknown : left[i];
    lost += take(i, {flights[i], began_at, spins.empty() ? S(0) : spins[i]}, now);
  }
  return lost;
}

template <class P>
double Tracks<P>::take(std::size_t ball, Segment<P> segment, At now) {
  Disk& flight = segment.flight;
  double lost = 0;
  radii_[ball] = static_cast<double>(motion_->species(flight).radius);
  if (motion_->fixed(flight)) {
    fixed_[ball] = 1;
    flight.start = P::Clock::ever();
  } else {
    movers_.push_back(static_cast<Index>(ball));
    const unsigned support = motion_->support(flight);
    if (motion_->contacts_last() && support != kLying && support < kResting &&
        flight.start == now) {
      S* spin = motion_->rules().spins ? &segment.spin : nullptr;
      lost = std::max(motion_->support_on_walls(flight, spin), 0.0);
    }
  }
  tracks_[ball].first = segment;
  tracks_[ball].path.push_back(segment);
  set_box(static_cast<Index>(ball), now, now);
  return lost;
}

template <class P>
auto Tracks<P>::begin(Index ball) -> Track& {
  Track& track = tracks_[ball];
  track.first = track.path.back();
  track.path.assign(1, track.first);
  return track;
}

template <class P>
bool Tracks<P>::flies_on(Index ball, At until) const {
  const Segment<P>& segment = tracks_[ball].first;
  if (motion_->support(segment.flight) >= kStepped) return false;
  const S* spin = motion_->rules().spins ? &segment.spin : nullptr;
  return motion_->alone(segment.flight, until, spin).time > until;
}

template <class P>
void Tracks<P>::set_box(Index ball, At now, At until) {
  Track& track = tracks_[ball];
  track.box = fixed_[ball] != 0 ? box_of_fixed<P>(track.path.front().flight)
                                : box_of_path<P>(*motion_, track.path, now, until);
}

template <class P>
void Tracks<P>::set_regions(double margin) {
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    regions_[i] = tracks_[i].box;
    if (fixed_[i] != 0) continue;
    for (double& half : regions_[i].half) half += margin;
  }
}

template <class P>
Spacing Tracks<P>::spacing() const {
  double speeds = 0;
  double diameters = 0;
  for (const Index i : movers_) {
    const Disk& disk = last(i).flight;
    const auto x = static_cast<double>(disk.vx);
    const auto y = static_cast<double>(disk.vy);
    speeds += x * x + y * y;
    diameters += 2 * radii_[i];
  }
  const auto& rules = motion_->rules();
  return {movers_.size(), speeds, diameters, rules.domain, rules.gravity};
}

template <class P>
void Tracks<P>::rebase(At by) {
  const Time& shift = by;
  for (Track& track : tracks_) {
    if (track.first.flight.start != P::Clock::ever()) track.first.flight.start -= shift;
    for (Segment<P>& segment : track.path) {
      if (segment.flight.start != P::Clock::ever()) segment.flight.start -= shift;
    }
  }
}

template <class P>
double Tracks<P>::given_ahead(At now) const {
  double sum = 0;
  const int shift = motion_->step_shift();
  if (!(motion_->pull() > 0)) return sum;
  const Time next = P::Clock::span(P::Clock::steps(now, shift) + 1, shift);
  for (const Index i : movers_) {
    const Disk& disk = last(i).flight;
    if (motion_->support(disk) == kStepped) sum += motion_->given_ahead(disk, now, next);
  }
  return sum;
}

template <class P>
void Tracks<P>::wake_around(std::size_t ball, At now) {
  if (!motion_->contacts_last() || !motion_->rules().collisions) return;
  const Disk& gone = last(ball).flight;
  const Vec<S> here = motion_->wrapped(motion_->place(gone, now));
  for (const Index j : movers_) {
    Disk& disk = tracks_[j].path.back().flight;
    if (j == ball) continue;
    if (motion_->support(disk) != kResting && motion_->support(disk) != kLying) continue;
    const S reach = motion_->species(gone).radius + motion_->species(disk).radius;
    if (!near(motion_->way(here, motion_->place(disk, now)), reach, S(kNear))) continue;
    motion_->set_support(disk, kJoins);
  }
}

}  // namespace carom::event
