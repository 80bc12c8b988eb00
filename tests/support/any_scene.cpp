#include "support/any_scene.hpp"

#include <algorithm>
#include <cmath>

#include "support/random_numbers.hpp"

namespace carom::test {
namespace {

class Maker {
 public:
  explicit Maker(std::uint64_t seed) : seed_(seed), random_(seed), lattice_(random_.below(3) == 0) {
    scene_.name = "any";
    scene_.seed = seed;
    scene_.workers = 1;
    scene_.duration = kAnySceneTime;
    scene_.solver.method = seed / 64 % 2 == 0 ? Method::event : Method::overlap;
  }

  Scene take() {
    box();
    scene_.effects = effects();
    if (event() && !scene_.effects.attraction && !losses_under_gravity() && one_in(4)) {
      scene_.solver.digits = 34;
    }
    if (one_in(3)) scene_.solver.step = 1.0 / pick({128, 256, 300});
    balls();
    if (!one_in(3)) script();
    return scene_;
  }

 private:
  bool one_in(int n) { return random_.below(n) == 0; }
  double pick(std::initializer_list<double> values) {
    return values.begin()[random_.below(static_cast<int>(values.size()))];
  }
  double number(double least, double most) {
    const double drawn = random_.between(least, most);
    return lattice_ ? std::round(drawn * 8) / 8 : drawn;
  }
  bool event() const { return scene_.solver.method == Method::event; }
  bool losses_under_gravity() const {
    return scene_.effects.gravity && loses_energy(scene_.effects);
  }

  void box() {
    columns_ = 3 + random_.below(4);
    rows_ = 3 + random_.below(4);
    scene_.box.width = columns_;
    scene_.box.height = rows_;
    for (bool& periodic : scene_.box.periodic) periodic = one_in(3);
    if (one_in(2)) scene_.box.origin = Box::Origin::center;
  }

  /// The set of effects that the seed stands for, with new values.
  Effects effects() {
    Effects made;
    if ((seed_ & 1U) != 0) made.walls = Walls{pick({1, 1, 0.9, 0.5, 0})};
    if ((seed_ & 2U) != 0) made.collisions = Collisions{pick({1, 1, 0.9, 0.5, 0})};
    if ((seed_ & 4U) != 0) made.gravity = Gravity{{number(-3, 3), number(-10, 2)}};
    if ((seed_ & 8U) != 0) made.drag = Drag{number(0, 1)};
    if ((seed_ & 16U) != 0) made.friction = Friction{number(0, 1), number(0, 1)};
    if ((seed_ & 32U) != 0) made.attraction = Attraction{number(-2, 2), pick({0.125, 0.5})};
    return made;
  }

  Ball ball(int cell) {
    Ball made;
    made.radius = mixture_ ? pick({0.125, 0.25, 0.375, 0.5}) : 0.375;
    made.mass = mixture_ ? pick({1, 1, 2, 8, 0.25}) : 1;
    const double play = 0.5 - made.radius;
    const int row = cell / columns_;
    made.position = scene_.box.lower() + Vec2{cell % columns_ + 0.5, row + 0.5};
    if (!lattice_)
      made.position += Vec2{random_.between(-play, play), random_.between(-play, play)};
    made.velocity = {number(-4, 4), number(-4, 4)};
    if (scene_.effects.friction) made.spin = number(-5, 5);
    return made;
  }

  void balls() {
    mixture_ = one_in(2);
    const int cells = columns_ * rows_;
    const int share = 2 + random_.below(4);
    for (int cell = 0; cell < cells; ++cell) {
      if (!one_in(share)) continue;
      scene_.balls.push_back(ball(cell));
      Ball& made = scene_.balls.back();
      if (!one_in(8)) continue;
      made.fixed = true;
      made.velocity = {0, 0};
      made.spin = 0;
    }
    if (scene_.balls.empty()) scene_.balls.push_back(ball(0));
  }

  Command line() {
    switch (random_.below(6)) {
      case 0:
      case 1: {
        command::SetEffects set{effects()};
        // Losses that come later are as good as those of the start, where 16 digits take them.
        if (scene_.solver.digits > 16) {
          if (set.effects.walls) set.effects.walls->restitution = 1;
          if (set.effects.collisions) set.effects.collisions->restitution = 1;
        }
        return set;
      }
      case 2:
        return command::Remove{};
      case 3:
        return command::Remove{static_cast<std::size_t>(random_.below(2))};
      case 4:
        return command::SetStep{1.0 / pick({100, 128, 400})};
      default:
        return command::Add{ball(random_.below(columns_ * rows_))};
    }
  }

  /// In order: lines at any time, a pause or two, and now and then the end.
  void script() {
    std::vector<double> times;
    for (int lines = 1 + random_.below(5); lines > 0; --lines) times.push_back(time(0, 1.4));
    std::sort(times.begin(), times.end());
    for (const double at : times) {
      const Command command = line();
      const auto* set = std::get_if<command::SetEffects>(&command);
      if (set != nullptr && seed_ % 64 == 0) continue;  // no effect to set
      scene_.script.push_back({at, command});
    }
    for (int pauses = random_.below(3); pauses > 0; --pauses) {
      const double at = time(0, 1.2);
      insert({at, command::Pause{}});
      insert({at + time(0, 0.7), command::Resume{}});
    }
    if (one_in(6)) insert({time(1.2, 2), command::Quit{}});
  }
  double time(double least, double most) {
    const double drawn = random_.between(least, most);
    return lattice_ ? std::round(drawn * 64) / 64 : drawn;
  }
  void insert(const ScriptLine& line) {
    auto& script = scene_.script;
    script.insert(std::upper_bound(script.begin(), script.end(), line,
                                   [](const auto& a, const auto& b) { return a.at < b.at; }),
                  line);
  }

  std::uint64_t seed_;
  RandomNumbers random_;
  bool lattice_;
  bool mixture_ = false;
  int columns_ = 0;
  int rows_ = 0;
  Scene scene_;
};

}  // namespace

Scene any_scene(std::uint64_t seed) {
  return Maker(seed).take();
}

}  // namespace carom::test
