#include "scene/from_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace carom::scene {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double number(const Value& value) {
  return value.is_number() ? value.number : kUnknown;
}

/// Overwrites `target` where the object has the key.
void take(const Value& object, std::string_view key, double& target) {
  if (const Value* value = object.find(key)) target = number(*value);
}

void take(const Value& object, std::string_view key, bool& target) {
  const Value* value = object.find(key);
  if (value != nullptr && value->kind == Value::Kind::flag) target = value->flag;
}

void take(const Value& object, std::string_view key, std::string& target) {
  const Value* value = object.find(key);
  if (value != nullptr && value->kind == Value::Kind::text) target = value->text();
}

void take(const Value& object, std::string_view key, char& target) {
  const Value* value = object.find(key);
  if (value != nullptr && value->kind == Value::Kind::text && value->text().size() == 1) {
    target = value->text()[0];
  }
}

std::optional<std::uint64_t> whole(const Value& value) {
  if (value.kind == Value::Kind::whole && !value.flag) return value.magnitude;
  if (value.kind == Value::Kind::real && value.number >= 0 && value.number <= 0x1p53) {
    return static_cast<std::uint64_t>(value.number);
  }
  return std::nullopt;
}

void take(const Value& object, std::string_view key, std::uint64_t& target) {
  const Value* value = object.find(key);
  if (value != nullptr) target = whole(*value).value_or(target);
}

Vec2 pair(const Value& value) {
  if (value.kind != Value::Kind::list || value.items().size() != 2) return {kUnknown, kUnknown};
  return {number(value.items()[0]), number(value.items()[1])};
}

void take(const Value& object, std::string_view key, Vec2& target) {
  if (const Value* value = object.find(key)) target = pair(*value);
}

/// A word's number in a list of words; the target stays as it is for any other value.
template <class Enum>
void take_word(const Value& object, std::string_view key,
               std::initializer_list<std::pair<std::string_view, Enum>> words, Enum& target) {
  const Value* value = object.find(key);
  if (value == nullptr || value->kind != Value::Kind::text) return;
  for (const auto& [word, meaning] : words) {
    if (value->text() == word) target = meaning;
  }
}

Box take_box(const Value& root) {
  Box box;
  box.width = kUnknown;
  box.height = kUnknown;
  const Value* object = root.find("box");
  if (object == nullptr) return box;
  take(*object, "width", box.width);
  take(*object, "height", box.height);
  take_word(*object, "origin", {{"corner", Box::Origin::corner}, {"center", Box::Origin::center}},
            box.origin);
  const Value* periodic = object->find("periodic");
  if (periodic != nullptr && periodic->kind == Value::Kind::list) {
    for (const Value& axis : periodic->items()) {
      if (axis.kind != Value::Kind::text) continue;
      if (axis.text() == "x") box.periodic[0] = true;
      if (axis.text() == "y") box.periodic[1] = true;
    }
  }
  return box;
}

void take(const Value& value, Walls& walls) {
  take(value, "restitution", walls.restitution);
  take(value, "on", walls.on);
}
void take(const Value& value, Collisions& collisions) {
  take(value, "restitution", collisions.restitution);
  take(value, "on", collisions.on);
}
void take(const Value& value, Gravity& gravity) {
  gravity.acceleration = pair(value);
}
void take(const Value& value, Drag& drag) {
  take(value, "rate", drag.rate);
}
void take(const Value& value, Friction& friction) {
  take(value, "balls", friction.balls);
  take(value, "walls", friction.walls);
}
void take(const Value& value, Attraction& attraction) {
  take(value, "strength", attraction.strength);
  take(value, "softening", attraction.softening);
}

/// What the object names, on top of what `effects` holds already.
void take_effects(const Value& object, Effects& effects) {
  for_each_effect([&](const auto& entry) {
    const Value* value = object.find(entry.name);
    if (value == nullptr) return;
    auto& effect = effects.*entry.slot;
    if (!effect) effect.emplace();
    take(*value, *effect);
  });
}

Ball take_ball(const Value& object) {
  Ball ball;
  ball.position = {kUnknown, kUnknown};
  take(object, "position", ball.position);
  take(object, "velocity", ball.velocity);
  take(object, "radius", ball.radius);
  take(object, "mass", ball.mass);
  take(object, "spin", ball.spin);
  take(object, "fixed", ball.fixed);
  take(object, "glyph", ball.glyph);
  return ball;
}

Fill take_fill(const Value& object) {
  Fill fill;
  take(object, "count", fill.count);
  take(object, "radius", fill.radius);
  take(object, "mass", fill.mass);
  take(object, "temperature", fill.temperature);
  take(object, "glyph", fill.glyph);
  take_word(object, "arrangement",
            {{"random", Fill::Arrangement::random},
             {"square", Fill::Arrangement::square},
             {"hexagonal", Fill::Arrangement::hexagonal}},
            fill.arrangement);
  const Value* region = object.find("region");
  if (region != nullptr) {
    fill.region = {Vec2{kUnknown, kUnknown}, Vec2{kUnknown, kUnknown}};
    if (region->kind == Value::Kind::list && region->items().size() == 2) {
      fill.region = {pair(region->items()[0]), pair(region->items()[1])};
    }
  }
  return fill;
}

std::array<std::string, 2> decimals(const Value& object, std::string_view key) {
  std::array<std::string, 2> result;
  const Value* value = object.find(key);
  if (value == nullptr || value->kind != Value::Kind::list || value->items().size() != 2) {
    return result;
  }
  for (std::size_t k = 0; k < 2; ++k) {
    if (value->items()[k].kind == Value::Kind::text) result[k] = value->items()[k].text();
  }
  return result;
}

SavedFlight take_flight(const Value& object) {
  SavedFlight flight;
  take(object, "start", flight.start);
  flight.position = decimals(object, "position");
  flight.velocity = decimals(object, "velocity");
  take(object, "spin", flight.spin);
  if (const Value* left = object.find("left")) flight.left = whole(*left);
  if (const Value* axes = object.find("carried")) {
    flight.carried = static_cast<unsigned>(whole(*axes).value_or(0));
  }
  return flight;
}

Continuation take_continuation(const Value& object) {
  Continuation continuation;
  take(object, "time", continuation.time);
  take(object, "clock", continuation.clock);
  take(object, "paused", continuation.paused);
  if (const Value* clock = object.find("clock_origin")) continuation.clock_origin = number(*clock);
  if (const Value* time = object.find("time_origin")) continuation.time_origin = number(*time);
  take(object, "step_origin", continuation.step_origin);
  take(object, "steps", continuation.steps);
  if (const Value* tick = object.find("tick")) continuation.tick = number(*tick);
  take(object, "rests", continuation.rests);
  const Value* flights = object.find("flights");
  if (flights != nullptr && flights->kind == Value::Kind::list) {
    for (const Value& flight : flights->items()) {
      continuation.flights.push_back(take_flight(flight));
    }
  }
  return continuation;
}

void take_solver(const Value& root, SolverChoice& solver) {
  const Value* object = root.find("solver");
  if (object == nullptr) return;
  take(*object, "step", solver.step);
  if (object->find("method") != nullptr) {
    Method method = Method::overlap;
    take_word(*object, "method", {{"overlap", Method::overlap}, {"event", Method::event}}, method);
    solver.method = method;
  }
  std::uint64_t digits = 16;
  take(*object, "digits", digits);
  solver.digits = static_cast<int>(std::min<std::uint64_t>(digits, 1'000'000));
}

void take_workers(const Value& root, Scene& scene) {
  const Value* value = root.find("workers");
  if (value == nullptr) return;
  scene.per_ball = value->kind == Value::Kind::text;
  if (!scene.per_ball) scene.workers = whole(*value);
}

/// The command of a line; nothing where the line is not one.  `effects` is what holds before it.
void take_line(const Value& line, double at, Effects& effects, std::vector<ScriptLine>& script) {
  std::string word;
  take(line, "command", word);
  const Value* ball = line.find("ball");
  if (word == "add" && ball != nullptr) {
    script.push_back({at, command::Add{take_ball(*ball)}});
  } else if (word == "remove") {
    command::Remove remove;
    if (ball != nullptr) remove.ball = whole(*ball);
    script.push_back({at, remove});
  } else if (word == "pause") {
    script.push_back({at, command::Pause{}});
  } else if (word == "resume") {
    script.push_back({at, command::Resume{}});
  } else if (word == "quit") {
    script.push_back({at, command::Quit{}});
  } else if (word == "set") {
    if (const Value* changed = line.find("effects")) {
      // Only what is named is set: the line's effects are the present ones with its changes.
      Effects named;
      take_effects(*changed, effects);
      take_effects(*changed, named);
      for_each_effect([&](const auto& entry) {
        if (named.*entry.slot) named.*entry.slot = effects.*entry.slot;
      });
      script.push_back({at, command::SetEffects{named}});
    }
    const Value* solver = line.find("solver");
    if (solver != nullptr && solver->find("step") != nullptr) {
      script.push_back({at, command::SetStep{number(*solver->find("step"))}});
    }
  }
}

void take_script(const Value& root, Draft& draft) {
  const Value* list = root.find("script");
  if (list == nullptr || list->kind != Value::Kind::list) return;
  std::vector<double> at(list->items().size(), 0);
  for (std::size_t i = 0; i < at.size(); ++i) take(list->items()[i], "at", at[i]);
  std::vector<std::size_t> order(at.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // A time that is not known sorts to the end, as a NaN has no order of its own.
  const auto key = [&](std::size_t i) {
    return at[i] == at[i] ? at[i] : std::numeric_limits<double>::infinity();
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  Effects effects = draft.scene.effects;
  for (const std::size_t i : order) {
    take_line(list->items()[i], at[i], effects, draft.scene.script);
    draft.script_lines.resize(draft.scene.script.size(), i);
  }
}

}  // namespace

Draft draft_from_tree(const Value& root) {
  Draft draft;
  Scene& scene = draft.scene;
  take(root, "name", scene.name);
  take(root, "about", scene.about);
  scene.box = take_box(root);
  if (const Value* effects = root.find("effects")) take_effects(*effects, scene.effects);
  const Value* balls = root.find("balls");
  if (balls != nullptr && balls->kind == Value::Kind::list) {
    scene.balls.reserve(balls->items().size());
    for (const Value& ball : balls->items()) scene.balls.push_back(take_ball(ball));
  }
  const Value* fills = root.find("fill");
  if (fills != nullptr && fills->kind == Value::Kind::list) {
    for (const Value& fill : fills->items()) scene.fills.push_back(take_fill(fill));
  }
  take(root, "seed", scene.seed);
  take_solver(root, scene.solver);
  take_workers(root, scene);
  take(root, "duration", scene.duration);
  take(root, "frame_rate", scene.frame_rate);
  take_script(root, draft);
  if (const Value* object = root.find("continuation")) {
    scene.continuation = take_continuation(*object);
  }
  return draft;
}

}  // namespace carom::scene
