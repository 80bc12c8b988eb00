#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "carom/fluid.hpp"
#include "fill/random.hpp"
#include "verify/cases.hpp"
#include "verify/runs.hpp"
#include "verify/transform.hpp"

namespace carom::hard {

namespace {

/// Compressibility factors P A / (N k T).
/// Source: J. Kolafa, M. Rottner, Mol. Phys. 104 (2006) 3435.
struct Published {
  double packing;
  double compressibility;
};
constexpr std::array<Published, 6> kPublished{{{0.314159, 2.1514393},
                                               {0.392699, 2.7601235},
                                               {0.471239, 3.663691},
                                               {0.549779, 5.082362},
                                               {0.628319, 7.476491},
                                               {0.667588, 9.245785}}};

/// N equal balls on a lattice in a periodic box of its shape, at this packing.
Scene lattice(const Scene& scene, std::size_t columns, std::size_t rows, double packing,
              std::uint64_t seed) {
  Scene result = scene;
  const auto n = static_cast<double>(columns * rows);
  result.box.width = static_cast<double>(columns);
  result.box.height = static_cast<double>(rows) * std::sqrt(0.75);
  Fill& fill = result.fills.front();
  fill.count = columns * rows;
  fill.radius = std::sqrt(packing * result.box.width * result.box.height / (n * std::numbers::pi));
  result.seed = seed;
  return result;
}

/// Mean of blocks and its standard error.
struct Estimate {
  double mean = 0;
  double error = 0;
};
Estimate estimate(const std::vector<double>& blocks) {
  const auto n = static_cast<double>(blocks.size());
  Estimate result;
  for (const double each : blocks) result.mean += each / n;
  double square = 0;
  for (const double each : blocks) square += (each - result.mean) * (each - result.mean);
  result.error = std::sqrt(square / (n * (n - 1)));
  return result;
}

/// With f = 2 N - 2 velocity components on a sphere of constant energy, the mean of |v| is larger
/// than Maxwell's by this factor.
double microcanonical(double freedom) {
  return std::exp(std::lgamma(freedom / 2) - std::lgamma((freedom + 1) / 2)) *
         std::sqrt(freedom / 2);
}

/// How a block gives the compressibility.
enum class By {
  rate,   ///< of collisions: each passes on sigma m <v_n> along the line of the centres, so that
          ///< Z - 1 = (rate / N) (sigma / 2) sqrt(pi m / kT) in the canonical ensemble
  virial  ///< of its impulses, as in a series
};

Estimate compressibility(const Scene& scene, double packing, double effort, By by) {
  const auto n = static_cast<double>(scene.fills.front().count);
  Simulation simulation(scene);
  // k T = E / (N - 1) with the momentum at zero.
  const double temperature = simulation.measure().energy_final / (n - 1);
  const double sigma = 2 * scene.fills.front().radius;
  // Fluctuations live the longer the nearer the fluid is to freezing, at 0.70: a block has to
  // outlast them, or its scatter does not say how wrong the mean is.
  constexpr double kFreezing = 0.70;
  const double collisions = effort / (1 - packing / kFreezing);  // of a ball, in a block
  constexpr std::size_t kBlocks = 24;
  double time = 0;
  const auto count_to = [&](double until) {
    simulation.advance_to(time = until);
    return static_cast<double>(simulation.measure().ball_ball);
  };
  // Until the lattice is forgotten; its rate says how long a block is.
  constexpr double kSettling = 4;
  double settle = 1;
  while (count_to(settle) < kSettling * collisions * n / 2) settle *= 1.25;
  const double length = settle / kSettling;
  std::vector<double> blocks;
  if (by == By::virial) {
    FluidMeter meter(scene);
    meter.begin_at(time);
    simulation.record_impacts(true);
    for (std::size_t k = 0; k < kBlocks; ++k) {
      simulation.advance_to(time += length);
      const auto fluid = meter.measure(time, simulation.state(), simulation.take_impacts(true));
      blocks.push_back(fluid.Z.value());
    }
    return estimate(blocks);
  }
  double before = count_to(time);
  for (std::size_t k = 0; k < kBlocks; ++k) {
    const double after = count_to(time + length);
    const double rate = (after - before) / n / length;
    blocks.push_back(1 + rate * sigma * std::sqrt(std::numbers::pi / temperature) / 2 /
                             microcanonical(2 * n - 2));
    before = after;
  }
  return estimate(blocks);
}

/// The largest deviation from the published values, in standard errors.
template <By by>
double gas_pressure(const Trial& trial) {
  double worst = 0;
  for (const Published& each : kPublished) {
    const Scene scene = trial.thorough ? lattice(trial.scene, 64, 64, each.packing, trial.seed)
                                       : lattice(trial.scene, 29, 30, each.packing, trial.seed);
    const Estimate found = compressibility(scene, each.packing, trial.thorough ? 100 : 12, by);
    worst = std::max(worst, std::abs(found.mean - each.compressibility) / found.error);
  }
  return worst;
}

/// The speeds of a gas of equal masses whose balls were initially all equally fast, seen a hundred
/// times, sorted; `temperature` is k T / m.
struct Speeds {
  std::vector<double> sorted;
  double temperature = 0;
};
Speeds speeds_of_gas(const Trial& trial) {
  Scene scene = listed(trial.scene);
  scene::Random random(trial.seed, 6);
  Vec2 drift{0, 0};
  for (Ball& each : scene.balls) {
    const double x = 2 * random.uniform() - 1;
    const double y = std::sqrt(1 - x * x) * (random.uniform() < 0.5 ? -1 : 1);
    each.velocity = {x, y};
    drift += each.velocity / static_cast<double>(scene.balls.size());
  }
  for (Ball& each : scene.balls) each.velocity -= drift;
  Simulation simulation(scene);
  Speeds speeds;
  speeds.temperature =
      simulation.measure().energy_final / static_cast<double>(scene.balls.size() - 1);
  for (double time = 40; time < 240; time += 2) {
    simulation.advance_to(time);
    for (const Ball& each : simulation.state()) speeds.sorted.push_back(each.velocity.norm());
  }
  std::sort(speeds.sorted.begin(), speeds.sorted.end());
  return speeds;
}

/// Mean speed squared over mean square speed, pi / 4 where speeds are Maxwell's; in parts of it.
double maxwell_speeds(const Trial& trial) {
  const Speeds found = speeds_of_gas(trial);
  double speeds = 0;
  double squares = 0;
  const auto count = static_cast<double>(found.sorted.size());
  for (const double speed : found.sorted) {
    speeds += speed;
    squares += speed * speed;
  }
  const double ratio = (speeds / count) * (speeds / count) / (squares / count);
  return std::abs(ratio / (std::numbers::pi / 4) - 1);
}

/// The largest distance of the share of slower balls from Maxwell's 1 - exp(-v^2 / 2 T): the
/// statistic of Kolmogorov and Smirnov.
double maxwell_distribution(const Trial& trial) {
  const Speeds found = speeds_of_gas(trial);
  const auto count = static_cast<double>(found.sorted.size());
  double worst = 0;
  double below = 0;
  for (const double speed : found.sorted) {
    const double share = -std::expm1(-speed * speed / (2 * found.temperature));
    worst = std::max(worst, std::max(share - below / count, (below + 1) / count - share));
    ++below;
  }
  return worst;
}

/// Haff's law T0 / (1 + t / tH)^2 with 1 / tH = (1 - e^2) nu0 / 4,
/// nu0 = (8 eta chi / sigma) sqrt(T / (pi m)), chi that of Henderson's equation of state.
/// Source: P. Haff, J. Fluid Mech. 134 (1983) 401; D. Henderson, Mol. Phys. 30 (1975) 971.
double haff_cooling(const Trial& trial) {
  Scene scene = trial.scene;
  const Fill& fill = scene.fills.front();
  const double n = static_cast<double>(fill.count);
  const double eta =
      n * std::numbers::pi * fill.radius * fill.radius / (scene.box.width * scene.box.height);
  const double chi = (1 - 7 * eta / 16) / ((1 - eta) * (1 - eta));
  const double e = scene.effects.collisions->restitution;
  Simulation simulation(scene);
  // An elastic start would not matter: the fill draws from Maxwell's distribution.
  const double first = simulation.measure().energy_final / (n - 1);
  const double nu = 8 * eta * chi / (2 * fill.radius) * std::sqrt(first / std::numbers::pi);
  const double rate = (1 - e * e) * nu / 4;
  double worst = 0;
  for (double scaled = 0.25; scaled <= 2; scaled += 0.25) {
    simulation.advance_to(scaled / rate);
    const double expected = first / ((1 + scaled) * (1 + scaled));
    worst = std::max(worst, std::abs(simulation.measure().energy_final / (n - 1) / expected - 1));
  }
  return worst;
}

}  // namespace

std::vector<Case> fluid_cases() {
  return {
      {"gas",
       {{Method::event, "pressure off, in standard errors", 3, gas_pressure<By::rate>},
        {Method::event, "Z of a series off, the same", 3, gas_pressure<By::virial>}}},
      {"speeds",
       {{Method::event, "off Maxwell's pi / 4, relative", 0.01, maxwell_speeds},
        {Method::event, "off Maxwell's distribution", 0.01, maxwell_distribution}}},
      {"cooling", {{Method::event, "off Haff's law, relative", 0.07, haff_cooling}}},
  };
}

}  // namespace carom::hard
