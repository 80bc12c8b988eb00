#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "fill/random.hpp"
#include "verify/cases.hpp"
#include "verify/runs.hpp"

namespace carom::hard {

namespace {

/// N free balls in a line that fall together below the restitution at which they collapse.
/// Source: S. McNamara, W. Young, Phys. Fluids A 4 (1992) 496; B. Bernu, R. Mazighi, J. Phys. A 23
/// (1990) 5745: e < tan^2((pi/4)(1 - 2/N)), and 7 - 4 sqrt(3) for three.
struct Collapse {
  int balls;
  double critical;
};
constexpr std::array<Collapse, 5> kCollapse{
    {{3, 0.0717968}, {4, 0.171573}, {5, 0.259616}, {6, 0.333333}, {10, 0.527864}}};

template <class Measure>
double worst_collapse(const Trial& trial, Measure measure) {
  scene::Random random(trial.seed, 5);
  double worst = 0;
  for (const Collapse& line : kCollapse) {
    for (int k = 0; k < 4; ++k) {
      std::vector<Ball> balls;
      double x = 8;
      for (int i = 0; i < line.balls; ++i) {
        balls.push_back(ball(x, 2, 0, 0));
        x += 1.5 + random.uniform();
      }
      balls.front().velocity.x() = 1;
      balls.back().velocity.x() = -1;
      Scene scene = with_balls(trial.scene, balls);
      scene.effects.collisions->restitution = line.critical * (0.5 + 0.45 * random.uniform());
      worst = std::max(worst, measure(scene, run(scene, 60)));
    }
  }
  return worst;
}

double collapse_momentum(const Trial& trial) {
  return worst_collapse(trial, [](const Scene& scene, const Outcome& outcome) {
    return momentum_error(scene, outcome);
  });
}

double collapse_overlap(const Trial& trial) {
  return worst_collapse(trial, [](const Scene&, const Outcome& outcome) {
    double worst = outcome.measured.max_overlap;
    for (std::size_t i = 1; i < outcome.balls.size(); ++i) {
      const double gap = outcome.balls[i].position.x() - outcome.balls[i - 1].position.x();
      worst = std::max(worst, (1 - gap) / 0.5);
    }
    return worst;
  });
}

double collapse_impacts(const Trial& trial) {
  return worst_collapse(trial, [](const Scene&, const Outcome& outcome) {
    return static_cast<double>(outcome.measured.ball_ball);
  });
}

/// Lines of the table that ended without a contact at rest being reported.
double collapse_unreported(const Trial& trial) {
  double silent = 0;
  worst_collapse(trial, [&silent](const Scene&, const Outcome& outcome) {
    if (outcome.measured.resting_contacts == 0) ++silent;
    return 0.0;
  });
  return silent;
}

/// A ball dropped from a height of 1 on a floor.
struct Zeno {
  double g;
  double e;
  double fall;  ///< the time of the first fall

  explicit Zeno(const Scene& scene)
      : g(-scene.effects.gravity->acceleration.y()),
        e(scene.effects.walls->restitution),
        fall(std::sqrt(2 / g)) {}
  /// When the n-th flight after an impact is over: the first one is n = 1.
  [[nodiscard]] double landing(int n) const {
    double time = fall;
    for (int k = 1; k <= n; ++k) time += 2 * std::pow(e, k) * fall;
    return time;
  }
  [[nodiscard]] double rest() const { return fall * (1 + e) / (1 - e); }
};

double zeno_heights(const Trial& trial, int bounces) {
  const Zeno zeno(trial.scene);
  Simulation simulation(trial.scene);
  double worst = 0;
  for (int n = 1; n <= bounces; ++n) {
    simulation.advance_to((zeno.landing(n - 1) + zeno.landing(n)) / 2);
    const Ball now = simulation.state()[0];
    const double height = now.position.y() - now.radius + now.velocity.squaredNorm() / (2 * zeno.g);
    worst = std::max(worst, std::abs(height - std::pow(zeno.e, 2 * n)));
  }
  return worst;
}

double zeno_all_heights(const Trial& trial) {
  return zeno_heights(trial, 40);
}

/// Steps make each bounce a little late, not lower; these are still the same ones at the same time.
double zeno_first_heights(const Trial& trial) {
  return zeno_heights(trial, 5);
}

double zeno_rest_time(const Trial& trial) {
  const Zeno zeno(trial.scene);
  double moving = 0;
  double resting = 2 * zeno.rest();
  for (int k = 0; k < 60; ++k) {
    const double time = (moving + resting) / 2;
    const bool rests = run(trial.scene, time).balls[0].velocity.y() == 0;
    (rests ? resting : moving) = time;
  }
  return std::abs(resting / zeno.rest() - 1);
}

double zeno_after(const Trial& trial) {
  const Zeno zeno(trial.scene);
  Simulation simulation(trial.scene);
  simulation.advance_to(1.001 * zeno.rest());
  const std::uint64_t hits = simulation.measure().ball_wall;
  simulation.advance_to(1000 * zeno.rest());
  const Ball now = simulation.state()[0];
  return std::abs(now.position.y() - now.radius) + now.velocity.norm() +
         static_cast<double>(simulation.measure().ball_wall - hits);
}

/// The pile after its time; what it initially had to lose.
struct Pile {
  Outcome outcome;
  double drop;
  double won;       ///< the largest energy gained from one look to the next
  double restless;  ///< impacts in the last tenth of the time
};
constexpr int kSamples = 50;

/// The balls fall otherwise for each seed; with the first one, as the scene has them.
Scene dropped(const Trial& trial) {
  Scene scene = trial.scene;
  scene.seed += trial.seed - 1;
  return scene;
}

/// One run serves all measures of a method and a seed.
const Pile& settled_pile(const Trial& trial) {
  static std::map<std::pair<Method, std::uint64_t>, Pile> settled;
  const std::pair key{*trial.scene.solver.method, trial.seed};
  const auto known = settled.find(key);
  if (known != settled.end()) return known->second;
  Simulation simulation(dropped(trial));
  const double g = -trial.scene.effects.gravity->acceleration.y();
  const auto height = [g](const std::vector<Ball>& balls) {
    double sum = 0;
    for (const Ball& each : balls) sum += each.mass * g * each.position.y();
    return sum;
  };
  const double before = height(simulation.state());
  Pile pile{{}, 0, 0, 0};
  double energy = simulation.measure().energy_final;
  double impacts = 0;
  for (int sample = 1; sample <= kSamples; ++sample) {
    simulation.advance_to(trial.scene.duration * sample / kSamples);
    const Measurements now = simulation.measure();
    pile.won = std::max(pile.won, now.energy_final - energy);
    energy = now.energy_final;
    const auto sum = static_cast<double>(now.ball_ball + now.ball_wall);
    if (10 * sample <= 9 * kSamples) impacts = sum;
    pile.restless = sum - impacts;
  }
  pile.outcome = {simulation.state(), simulation.measure()};
  pile.drop = before - height(pile.outcome.balls);
  return settled.emplace(key, std::move(pile)).first->second;
}

double pile_motion(const Trial& trial) {
  const Pile& pile = settled_pile(trial);
  double kinetic = 0;
  for (const Ball& each : pile.outcome.balls) {
    kinetic += each.mass * each.velocity.squaredNorm() / 2 +
               each.mass * each.radius * each.radius * each.spin * each.spin / 4;
  }
  return kinetic / pile.drop;
}

double pile_gain(const Trial& trial) {
  const Pile& pile = settled_pile(trial);
  return pile.won / pile.drop;
}

double pile_impacts(const Trial& trial) {
  return settled_pile(trial).restless;
}

double pile_overlap(const Trial& trial) {
  const Pile& pile = settled_pile(trial);
  const std::vector<Ball>& balls = pile.outcome.balls;
  double worst = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double reach = balls[i].radius + balls[j].radius;
      const double gap = (balls[i].position - balls[j].position).norm();
      worst = std::max(worst, (reach - gap) / std::min(balls[i].radius, balls[j].radius));
    }
  }
  return worst;
}

}  // namespace

std::vector<Case> loss_cases() {
  return {
      {"collapse",
       {{Method::event, "momentum, relative", 1e-12, collapse_momentum},
        {Method::event, "overlap, in radii", 1e-9, collapse_overlap},
        {Method::event, "impacts", 1e5, collapse_impacts},
        {Method::event, "ends without a contact at rest", 0, collapse_unreported}}},
      {"zeno",
       {{Method::event, "bounce heights, in drops", 1e-12, zeno_all_heights},
        {Method::event, "time of rest, relative", 1e-12, zeno_rest_time},
        {Method::event, "off the floor, or impacts, after", 0, zeno_after},
        {Method::overlap, "first bounce heights, in drops", 1e-12, zeno_first_heights}}},
      {"pile",
       {{Method::event, "kinetic energy, of the drop", 1e-6, pile_motion},
        {Method::event, "overlap, in radii", 0.01, pile_overlap},
        {Method::event, "energy won, of the drop", 1e-6, pile_gain},
        {Method::event, "impacts after it came to rest", 0, pile_impacts},
        {Method::overlap, "kinetic energy, of the drop", 1e-6, pile_motion},
        {Method::overlap, "overlap, in radii", 0.01, pile_overlap}}},
  };
}

}  // namespace carom::hard
