#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "carom/impact.hpp"
#include "carom/vector.hpp"
#include "contact/island.hpp"

namespace carom::contact {

/// A mirror image of the coordinates: the axes change places or not, then each is turned round or
/// not.
struct Frame {
  bool swaps = false;
  Vec2 sign{1, 1};

  [[nodiscard]] Vec2 into(const Vec2& v) const {
    return swaps ? Vec2{sign.x() * v.y(), sign.y() * v.x()}
                 : Vec2{sign.x() * v.x(), sign.y() * v.y()};
  }
  [[nodiscard]] Vec2 out(const Vec2& v) const {
    const Vec2 w{sign.x() * v.x(), sign.y() * v.y()};
    return swaps ? Vec2{w.y(), w.x()} : w;
  }
  /// What a turn counter-clockwise is multiplied by, either way.
  [[nodiscard]] double turn() const { return (swaps ? -1 : 1) * sign.x() * sign.y(); }
};

/// An island of method `overlap` in one step, with what it takes to move its balls.
///
/// It is solved in a frame, and in an order of its balls and contacts, that follow from where its
/// balls are and how they move: the same for a mirror image, and for any order of the balls.
struct LastingIsland {
  struct Member {
    std::uint32_t ball = 0;
    Vec2 start{0, 0};
    Vec2 before{0, 0};  // its velocity then
    Vec2 flown{0, 0};   // where and how fast it would be without contacts
    Vec2 flown_velocity{0, 0};
    Vec2 flight{0, 0};  // the way from start to flown
    Vec2 pull{0, 0};    // its acceleration by attraction at the start
    Vec2 pulled{0, 0};  // the speed that makes in half a step
    double inverse_mass = 0;
    double radius = 0;
    double spin = 0;
    bool woken = false;  // it was asleep at the start
    // Turns round periodic axes, where they are counted: in its flight, and beyond that.
    std::array<std::int64_t, 2> turned_flying{0, 0};
    std::array<std::int64_t, 2> turned{0, 0};
  };
  /// What a contact is beside its numbers.
  struct Source {
    double smaller = 0;       // the smaller radius
    std::uint32_t other = 0;  // the second ball, if it is no wall
    bool wall = false;
  };

  std::vector<Member> members;
  std::vector<IslandContact> contacts;  // first as they are in the box; after lay_out in the frame
  std::vector<Source> sources;
  std::vector<IslandBody> bodies;  // in the frame
  Frame frame;
  bool resolved = false;
  bool sleeps = false;
  bool driven = false;  // a ball of it, beyond a wall that was not near
  double push = 0;
  double lost = 0;              // energy, beside what flight took
  std::uint64_t ball_ball = 0;  // impacts with their restitution
  std::uint64_t ball_wall = 0;
  std::uint64_t jammed = 0;  // contacts, where nothing should lose energy, and some is lost
  double deepest = 0;        // overlap at the end of the step, by the smaller radius
  std::vector<Impact> impacts;

  void add_contact(const IslandContact& contact, const Source& source) {
    contacts.push_back(contact);
    sources.push_back(source);
  }
  /// Chooses the frame and the order, and turns all into it.
  void lay_out(const Vec2& acceleration, double step);
  /// Turns velocities and impulses back from the frame.
  void turn_back(IslandOutcome& outcome) const;
};

}  // namespace carom::contact
