#pragma once

#include <cstdint>
#include <vector>

#include "carom/vector.hpp"
#include "contact/interior_point.hpp"

namespace carom::contact {

/// What a step of an island is exact to, of the speed that the acceleration makes in a step; that
/// of few contacts without friction is exact to less.
constexpr double kExact = 0x1p-14;

/// A ball of an island, at the start of a step.
struct IslandBody {
  double inverse_mass = 0;  ///< more than 0
  Vec2 before{0, 0};        ///< its velocity at the start of the step
  Vec2 free{0, 0};          ///< at its end, if nothing touched the ball
  Vec2 free_mean{0, 0};     ///< what would carry it through the step then
  double turning = 0;       ///< spin times radius, at the start
  Vec2 pull{0, 0};          ///< its acceleration beside that which all have
};

/// Two balls of an island that are near each other, or one and what never moves.
struct IslandContact {
  int a = 0;
  int b = -1;         ///< less than 0: a wall or a fixed ball
  Vec2 normal{0, 0};  ///< from a to b, or towards the wall
  double gap = 0;     ///< at the start; less than 0: they overlap
  double friction = 0;
  double restitution = 1;
};

/// What a step did to an island.
struct IslandOutcome {
  std::vector<Vec2> after;      ///< velocities at the end of the step
  std::vector<double> turning;  ///< spin times radius, at the end
  std::vector<Vec2> mean;       ///< the velocity that carries each ball through the step
  std::vector<double> normal;   ///< the normal impulse of each contact
  std::vector<double> along;    ///< and the one along (-n_y, n_x), by friction
  std::vector<char> bounced;    ///< by contact: an impact with its restitution
  bool solved = true;
};

/// One step of an island of balls that touch: the impulses by which no contact is closer than
/// touching at the end of the step, each within its friction cone (Moreau's time stepping).
///
/// Contacts that come together faster than `rest_speed` and carry an impulse bounce with their
/// restitution; the others close without a bounce. In the plane a friction cone has two edges, so a
/// step is one convex problem; where a contact slides, that problem would lift it by mu times the
/// slip, which is given back until nothing changes (Acary et al. 2011), so that Coulomb's law
/// holds. Energy never grows: where restitution in a joint impact would make any, the step goes as
/// far from the step without restitution towards it as the energy allows.
///
/// Holds: the outcome is a function of the island alone, with its masses, lengths and times in any
/// units that are powers of two times each other to the last bit.
/// Source: Moreau, Comput. Methods Appl. Mech. Eng. 177 (1999) 329; Anitescu, Math. Program. 105
/// (2006) 113; Acary, Cadoux, Lemarechal, Malick, ZAMM 91 (2011) 155.
class IslandStep {
 public:
  struct Rule {
    double step = 0;
    Vec2 acceleration{0, 0};  ///< of all bodies
    double rest_speed = 0;
    double speed = 0;   ///< the scale of speeds: what the acceleration makes in a step
    double fading = 1;  ///< what drag leaves of a velocity gained in the middle of the step
    bool keeps_energy =
        false;  ///< nothing is lost: what a joint impact cannot return is given back
  };

  /// REQUIRES: bodies are not fixed; step and speed are more than 0.
  void take(const std::vector<IslandBody>& bodies, const std::vector<IslandContact>& contacts,
            bool spins, const Rule& rule, IslandOutcome& outcome);

  /// Whether forces within the friction cones hold the island where it is: whether the balls, at
  /// rest now, would still be at rest at the end of a step.
  bool holds(const std::vector<IslandBody>& bodies, const std::vector<IslandContact>& contacts,
             bool spins, const Rule& rule);

 private:
  template <int D>
  struct Work {
    ContactProblem<D> problem;
    InteriorPoint<D> solver;
    std::vector<double> rooms;  // how fast each contact may close
    std::vector<double> slips;  // how fast each slides, as far as is known
    double goal = 0;            // how exactly it is solved, a speed
    bool revised = false;       // slips have been, on the way to the last answer
    bool returns = false;       // bounces have been reckoned in
    std::vector<double> impulses;
    std::vector<double> motion;
  };
  struct Island {
    const std::vector<IslandBody>& bodies;
    const std::vector<IslandContact>& contacts;
    const Rule& rule;
    double mass_unit = 1;
  };

  static void keep_apart(const Island& island, const std::vector<Vec2>& plastic, double solved,
                         std::vector<Vec2>& mean);
  template <int D>
  void take(Work<D>& work, const Island& island, IslandOutcome& outcome);
  template <int D>
  bool holds(Work<D>& work, const Island& island);
  /// The least impulses for these slips, or, if it `revises` them, for those that come out.
  template <int D>
  bool solve(Work<D>& work, const Island& island, const std::vector<char>& bounced, bool revises,
             std::vector<double>& slip, IslandOutcome& outcome);
  /// The same for the slips that come out.
  template <int D>
  bool solve(Work<D>& work, const Island& island, const std::vector<char>& bounced,
             IslandOutcome& outcome);
  template <int D>
  void pose(Work<D>& work, const Island& island, const std::vector<char>& bounces,
            const std::vector<double>& slip) const;

  Work<2> plain_;
  Work<3> turning_;
};

}  // namespace carom::contact
