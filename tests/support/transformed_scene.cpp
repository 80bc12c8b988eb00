#include "support/transformed_scene.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "support/random_numbers.hpp"

namespace carom::test {
namespace {

Effects in_units(Effects effects, const Units& to) {
  if (effects.gravity) effects.gravity->acceleration *= to.length / to.time / to.time;
  if (effects.drag) effects.drag->rate /= to.time;
  if (effects.attraction) {
    effects.attraction->strength *= to.length * to.length * to.length / to.time / to.time / to.mass;
    effects.attraction->softening *= to.length;
  }
  return effects;
}

void turn(Vec2& v, hard::Mirror mirror) {
  if (mirror == hard::Mirror::x) v.x() = -v.x();
  if (mirror == hard::Mirror::y) v.y() = -v.y();
  if (mirror == hard::Mirror::diagonal) std::swap(v.x(), v.y());
}

/// The ids of the balls at the end, where the script works on those of the start.
std::vector<std::size_t> ids_at_end(const Scene& scene, std::vector<std::size_t> ids) {
  std::size_t next = ids.size();
  for (const ScriptLine& line : scene.script) {
    if (std::holds_alternative<command::Quit>(line.command)) break;
    if (std::holds_alternative<command::Add>(line.command)) ids.push_back(next++);
    if (const auto* remove = std::get_if<command::Remove>(&line.command)) {
      const std::size_t ball = remove->ball.value_or(ids.size() - 1);
      if (ball < ids.size()) ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(ball));
    }
  }
  return ids;
}

/// Makes each line that removes a ball name the same ball by its number in the other order.
void rename_removed(Scene& scene, std::vector<std::size_t> ids, std::vector<std::size_t> others) {
  std::size_t next = ids.size();
  for (ScriptLine& line : scene.script) {
    if (std::holds_alternative<command::Quit>(line.command)) break;
    if (std::holds_alternative<command::Add>(line.command)) {
      ids.push_back(next);
      others.push_back(next++);
    }
    if (auto* remove = std::get_if<command::Remove>(&line.command)) {
      const auto ball = static_cast<std::ptrdiff_t>(remove->ball.value_or(ids.size() - 1));
      const auto other =
          std::find(others.begin(), others.end(), ids[static_cast<std::size_t>(ball)]);
      remove->ball = static_cast<std::size_t>(other - others.begin());
      ids.erase(ids.begin() + ball);
      others.erase(other);
    }
  }
}

}  // namespace

Scene in_units(const Scene& scene, const Units& to) {
  Scene result = hard::scaled(scene, to.length, to.time, to.mass);
  result.effects = in_units(scene.effects, to);
  for (ScriptLine& line : result.script) {
    line.at *= to.time;
    if (auto* add = std::get_if<command::Add>(&line.command)) {
      add->ball = hard::scaled({add->ball}, to.length, to.time, to.mass).front();
    }
    if (auto* set = std::get_if<command::SetEffects>(&line.command)) {
      set->effects = in_units(set->effects, to);
    }
    if (auto* set = std::get_if<command::SetStep>(&line.command)) set->step *= to.time;
  }
  return result;
}

Scene in_mirror(const Scene& scene, hard::Mirror mirror) {
  Scene result = hard::mirrored(scene, mirror);
  for (ScriptLine& line : result.script) {
    if (auto* add = std::get_if<command::Add>(&line.command)) {
      add->ball = hard::mirrored({add->ball}, mirror).front();
    }
    auto* set = std::get_if<command::SetEffects>(&line.command);
    if (set != nullptr && set->effects.gravity) turn(set->effects.gravity->acceleration, mirror);
  }
  return result;
}

Reordered reordered(const Scene& scene, std::uint64_t seed) {
  Reordered result{hard::listed(scene), {}};
  std::vector<Ball>& balls = result.scene.balls;
  std::vector<std::size_t> ids(balls.size());
  std::iota(ids.begin(), ids.end(), std::size_t{0});
  std::vector<std::size_t> others = ids;
  RandomNumbers random(seed);
  for (std::size_t i = others.size(); i > 1; --i) {
    std::swap(others[i - 1], others[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  }
  const std::vector<Ball> before = balls;
  for (std::size_t k = 0; k < others.size(); ++k) balls[k] = before[others[k]];
  rename_removed(result.scene, ids, others);
  const std::vector<std::size_t> at_end = ids_at_end(scene, ids);
  for (const std::size_t id : ids_at_end(result.scene, others)) {
    result.number.push_back(
        static_cast<std::size_t>(std::find(at_end.begin(), at_end.end(), id) - at_end.begin()));
  }
  return result;
}

}  // namespace carom::test
