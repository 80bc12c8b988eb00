#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "carom/scene_file.hpp"

namespace carom {

namespace {

/// The shortest decimal that is read back to the same bits; -0 keeps its sign.
std::string number(double value) {
  const std::string text = fmt::format("{}", value);
  return text == "-0" ? "-0.0" : text;
}

std::string pair(const Vec2& value) {
  return fmt::format("[{}, {}]", number(value.x()), number(value.y()));
}

std::string text(std::string_view value) {
  std::string quoted = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      quoted += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

/// An object on one line, key by key.
class Line {
 public:
  Line& put(std::string_view key, std::string_view json) {
    body_ += fmt::format("{}\"{}\": {}", body_.empty() ? "" : ", ", key, json);
    return *this;
  }
  [[nodiscard]] std::string take() const { return "{" + body_ + "}"; }

 private:
  std::string body_;
};

bool is_plus_zero(double value) {
  return value == 0 && !std::signbit(value);
}

std::string ball(const Ball& ball) {
  const Ball defaults;
  Line line;
  line.put("position", pair(ball.position));
  if (!is_plus_zero(ball.velocity.x()) || !is_plus_zero(ball.velocity.y())) {
    line.put("velocity", pair(ball.velocity));
  }
  line.put("radius", number(ball.radius));
  if (ball.mass != defaults.mass) line.put("mass", number(ball.mass));
  if (!is_plus_zero(ball.spin)) line.put("spin", number(ball.spin));
  if (ball.fixed) line.put("fixed", "true");
  if (ball.glyph != 0) line.put("glyph", text(std::string_view(&ball.glyph, 1)));
  return line.take();
}

std::string json(const Walls& walls) {
  Line line;
  line.put("restitution", number(walls.restitution));
  if (!walls.on) line.put("on", "false");
  return line.take();
}
std::string json(const Collisions& collisions) {
  Line line;
  line.put("restitution", number(collisions.restitution));
  if (!collisions.on) line.put("on", "false");
  return line.take();
}
std::string json(const Gravity& gravity) {
  return pair(gravity.acceleration);
}
std::string json(const Drag& drag) {
  return Line().put("rate", number(drag.rate)).take();
}
std::string json(const Friction& friction) {
  return Line().put("balls", number(friction.balls)).put("walls", number(friction.walls)).take();
}
std::string json(const Attraction& attraction) {
  return Line()
      .put("strength", number(attraction.strength))
      .put("softening", number(attraction.softening))
      .take();
}

std::string effects(const Effects& effects) {
  Line line;
  for_each_effect([&](const auto& entry) {
    if (const auto& effect = effects.*entry.slot) line.put(entry.name, json(*effect));
  });
  return line.take();
}

std::string box(const Box& box) {
  Line line;
  line.put("width", number(box.width)).put("height", number(box.height));
  if (box.periodic[0] && box.periodic[1]) {
    line.put("periodic", R"(["x", "y"])");
  } else if (box.periodic[0] || box.periodic[1]) {
    line.put("periodic", box.periodic[0] ? R"(["x"])" : R"(["y"])");
  }
  if (box.origin == Box::Origin::center) line.put("origin", "\"center\"");
  return line.take();
}

std::string fill(const Fill& fill) {
  constexpr const char* kArrangements[] = {"random", "square", "hexagonal"};
  Line line;
  line.put("count", fmt::format("{}", fill.count));
  line.put("radius", number(fill.radius)).put("mass", number(fill.mass));
  line.put("temperature", number(fill.temperature));
  line.put("arrangement", text(kArrangements[static_cast<std::size_t>(fill.arrangement)]));
  if (fill.region) {
    line.put("region", fmt::format("[{}, {}]", pair((*fill.region)[0]), pair((*fill.region)[1])));
  }
  if (fill.glyph != 0) line.put("glyph", text(std::string_view(&fill.glyph, 1)));
  return line.take();
}

std::string solver(const SolverChoice& solver) {
  Line line;
  if (solver.method) {
    line.put("method", *solver.method == Method::overlap ? "\"overlap\"" : "\"event\"");
  }
  line.put("step", number(solver.step)).put("digits", fmt::format("{}", solver.digits));
  return line.take();
}

std::string script_line(const ScriptLine& entry) {
  Line line;
  line.put("at", number(entry.at));
  struct Visitor {
    Line& line;
    void operator()(const command::Add& add) const {
      line.put("command", "\"add\"").put("ball", ball(add.ball));
    }
    void operator()(const command::Remove& remove) const {
      line.put("command", "\"remove\"");
      if (remove.ball) line.put("ball", fmt::format("{}", *remove.ball));
    }
    void operator()(const command::Pause&) const { line.put("command", "\"pause\""); }
    void operator()(const command::Resume&) const { line.put("command", "\"resume\""); }
    void operator()(const command::SetEffects& set) const {
      line.put("command", "\"set\"").put("effects", effects(set.effects));
    }
    void operator()(const command::SetStep& set) const {
      line.put("command", "\"set\"").put("solver", Line().put("step", number(set.step)).take());
    }
    void operator()(const command::Quit&) const { line.put("command", "\"quit\""); }
  };
  std::visit(Visitor{line}, entry.command);
  return line.take();
}

/// A list of things, one on a line.
template <class Thing, class Write>
std::string list(const std::vector<Thing>& things, Write write) {
  std::string lines = "[";
  for (std::size_t i = 0; i < things.size(); ++i) {
    lines += i == 0 ? "\n    " : ",\n    ";
    lines += write(things[i]);
  }
  return lines + "\n  ]";
}

std::string flight(const SavedFlight& flight) {
  const auto two = [](const std::array<std::string, 2>& numbers) {
    return fmt::format("[{}, {}]", text(numbers[0]), text(numbers[1]));
  };
  Line line;
  line.put("start", text(flight.start));
  line.put("position", two(flight.position)).put("velocity", two(flight.velocity));
  if (!flight.spin.empty()) line.put("spin", text(flight.spin));
  if (flight.left) line.put("left", fmt::format("{}", *flight.left));
  if (flight.carried != 0) line.put("carried", fmt::format("{}", flight.carried));
  return line.take();
}

std::string continuation(const Continuation& continuation) {
  Line line;
  line.put("time", number(continuation.time))
      .put("clock", number(continuation.clock))
      .put("paused", continuation.paused ? "true" : "false");
  if (continuation.clock_origin) line.put("clock_origin", number(*continuation.clock_origin));
  if (continuation.time_origin) line.put("time_origin", number(*continuation.time_origin));
  line.put("step_origin", number(continuation.step_origin))
      .put("steps", fmt::format("{}", continuation.steps));
  if (continuation.tick) line.put("tick", number(*continuation.tick));
  if (continuation.rests) line.put("rests", "true");
  if (!continuation.flights.empty()) {
    line.put("flights", list(continuation.flights, flight));
  }
  return line.take();
}

}  // namespace

std::string write_scene(const Scene& scene) {
  std::string json = "{";
  const auto put = [&](std::string_view key, std::string_view value) {
    fmt::format_to(std::back_inserter(json), "{}\n  \"{}\": {}", json.size() == 1 ? "" : ",", key,
                   value);
  };
  if (!scene.name.empty()) put("name", text(scene.name));
  if (!scene.about.empty()) put("about", text(scene.about));
  put("box", box(scene.box));
  put("effects", effects(scene.effects));
  if (!scene.balls.empty()) put("balls", list(scene.balls, ball));
  if (!scene.fills.empty()) put("fill", list(scene.fills, fill));
  put("seed", fmt::format("{}", scene.seed));
  put("solver", solver(scene.solver));
  if (scene.workers) {
    put("workers", fmt::format("{}", *scene.workers));
  } else if (scene.per_ball) {
    put("workers", "\"per-ball\"");
  }
  put("duration", number(scene.duration));
  put("frame_rate", number(scene.frame_rate));
  if (!scene.script.empty()) put("script", list(scene.script, script_line));
  if (scene.continuation) put("continuation", continuation(*scene.continuation));
  return json + "\n}\n";
}

}  // namespace carom
