#include "scene/keys.hpp"

#include <array>

#include "carom/effects.hpp"

namespace carom::scene {

namespace {

using Words = std::string_view;

constexpr std::array<Words, 2> kOrigins{"corner", "center"};
constexpr std::array<Words, 3> kArrangements{"random", "square", "hexagonal"};
constexpr std::array<Words, 2> kMethods{"overlap", "event"};
constexpr std::array<Words, 6> kCommands{"add", "remove", "pause", "resume", "set", "quit"};

constexpr std::array kBoxKeys{
    Key{"width", Type::number, true, nullptr, {}, "20"},
    Key{"height", Type::number, true, nullptr, {}, "10"},
    Key{"periodic", Type::axes},
    Key{"origin", Type::choice, false, nullptr, kOrigins},
};
constexpr Group kBox{"the box", kBoxKeys};

constexpr std::array kWallsKeys{Key{"restitution", Type::number}, Key{"on", Type::flag}};
constexpr Group kWalls{"walls", kWallsKeys};

constexpr std::array kCollisionsKeys{Key{"restitution", Type::number}, Key{"on", Type::flag}};
constexpr Group kCollisions{"collisions", kCollisionsKeys};

constexpr std::array kDragKeys{Key{"rate", Type::number, true, nullptr, {}, "0.1"}};
constexpr Group kDrag{"drag", kDragKeys};

constexpr std::array kFrictionKeys{Key{"balls", Type::number}, Key{"walls", Type::number}};
constexpr Group kFriction{"friction", kFrictionKeys};

constexpr std::array kAttractionKeys{Key{"strength", Type::number, true, nullptr, {}, "1"},
                                     Key{"softening", Type::number}};
constexpr Group kAttraction{"attraction", kAttractionKeys};

template <class Effect>
constexpr const Group* kGroupOf = nullptr;  // a pair of numbers
template <>
constexpr const Group* kGroupOf<Walls> = &kWalls;
template <>
constexpr const Group* kGroupOf<Collisions> = &kCollisions;
template <>
constexpr const Group* kGroupOf<Drag> = &kDrag;
template <>
constexpr const Group* kGroupOf<Friction> = &kFriction;
template <>
constexpr const Group* kGroupOf<Attraction> = &kAttraction;

constexpr std::array kEffectsKeys = std::apply(
    [](const auto&... entries) {
      const auto key = []<class Effect>(const EffectEntry<Effect>& entry) {
        const Group* group = kGroupOf<Effect>;
        return Key{entry.name, group == nullptr ? Type::pair : Type::object, false, group};
      };
      return std::array{key(entries)...};
    },
    kEffects);
constexpr Group kEffectsGroup{"effects", kEffectsKeys};

constexpr std::array kBallKeys{
    Key{"position", Type::pair, true, nullptr, {}, "[3, 5]"},
    Key{"velocity", Type::pair},
    Key{"radius", Type::number},
    Key{"mass", Type::number},
    Key{"spin", Type::number},
    Key{"fixed", Type::flag},
    Key{"glyph", Type::glyph},
};
constexpr Group kBall{"a ball", kBallKeys};

constexpr std::array kFillKeys{
    Key{"count", Type::whole, true, nullptr, {}, "200"},
    Key{"radius", Type::number},
    Key{"mass", Type::number},
    Key{"temperature", Type::number},
    Key{"arrangement", Type::choice, false, nullptr, kArrangements},
    Key{"region", Type::corners},
    Key{"glyph", Type::glyph},
};
constexpr Group kFill{"a fill", kFillKeys};

constexpr std::array kSolverKeys{
    Key{"method", Type::choice, false, nullptr, kMethods},
    Key{"step", Type::number},
    Key{"digits", Type::whole},
};
constexpr Group kSolver{"the solver", kSolverKeys};

constexpr std::array kSetSolverKeys{Key{"step", Type::number}};
constexpr Group kSetSolver{"the solver in a script", kSetSolverKeys};

constexpr Key kAt{"at", Type::number, true, nullptr, {}, "1.5"};
constexpr Key kCommand{"command", Type::choice, true, nullptr, kCommands, "\"pause\""};

constexpr std::array kScriptLineKeys{kAt, kCommand};
constexpr std::array kAddKeys{
    kAt, kCommand,
    Key{"ball", Type::object, true, &kBall, {}, R"({"position": [1, 1], "radius": 0.5})"}};
constexpr std::array kRemoveKeys{kAt, kCommand, Key{"ball", Type::whole}};
constexpr std::array kSetKeys{kAt, kCommand, Key{"effects", Type::object, false, &kEffectsGroup},
                              Key{"solver", Type::object, false, &kSetSolver}};
constexpr Group kAdd{"the command \"add\"", kAddKeys};
constexpr Group kRemove{"the command \"remove\"", kRemoveKeys};
constexpr Group kPause{"the command \"pause\"", kScriptLineKeys};
constexpr Group kResume{"the command \"resume\"", kScriptLineKeys};
constexpr Group kSet{"the command \"set\"", kSetKeys};
constexpr Group kQuit{"the command \"quit\"", kScriptLineKeys};

constexpr std::array kFlightKeys{
    Key{"start", Type::decimal, true, nullptr, {}, "\"-1234\""},
    Key{"position", Type::decimal_pair, true, nullptr, {}, R"(["3", "5"])"},
    Key{"velocity", Type::decimal_pair, true, nullptr, {}, R"(["1", "0"])"},
    Key{"spin", Type::decimal},
    Key{"left", Type::whole},
    Key{"carried", Type::whole},
};
constexpr Group kFlight{"a flight", kFlightKeys};

constexpr std::array kContinuationKeys{
    Key{"time", Type::number},        Key{"clock", Type::number},
    Key{"paused", Type::flag},        Key{"clock_origin", Type::number},
    Key{"time_origin", Type::number}, Key{"step_origin", Type::number},
    Key{"steps", Type::whole},        Key{"tick", Type::number},
    Key{"rests", Type::flag},         Key{"flights", Type::list, false, &kFlight},
};
constexpr Group kContinuation{"a continuation", kContinuationKeys};

constexpr std::array kSceneKeys{
    Key{"$schema", Type::text},
    Key{"name", Type::line_of_text},
    Key{"about", Type::text},
    Key{"box", Type::object, true, &kBox, {}, R"({"width": 20, "height": 10})"},
    Key{"effects", Type::object, false, &kEffectsGroup},
    Key{"balls", Type::list, false, &kBall},
    Key{"fill", Type::list, false, &kFill},
    Key{"seed", Type::whole},
    Key{"solver", Type::object, false, &kSolver},
    Key{"workers", Type::workers},
    Key{"duration", Type::number},
    Key{"frame_rate", Type::number},
    Key{"script", Type::list, false, &kScriptLine},
    Key{"continuation", Type::object, false, &kContinuation},
};

}  // namespace

constexpr Group kScriptLine{"a script line", kScriptLineKeys};
constexpr Group kScene{"a scene", kSceneKeys};

const Group& script_line_group(std::string_view command) {
  if (command == "add") return kAdd;
  if (command == "remove") return kRemove;
  if (command == "pause") return kPause;
  if (command == "resume") return kResume;
  if (command == "set") return kSet;
  if (command == "quit") return kQuit;
  return kScriptLine;
}

}  // namespace carom::scene
