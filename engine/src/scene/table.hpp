#pragma once

#include <string_view>
#include <tuple>

#include "carom/names.hpp"
#include "carom/scene.hpp"
#include "scene/key.hpp"
#include "scene/limits.hpp"
#include "scene/script_lines.hpp"

namespace carom::scene {

/// The one table of a scene's keys: the reader, the checks of numbers, the writer and the schema
/// are made from it.  A new key is a member of its object and a line here.

/// The words of an enumeration.
inline constexpr const auto& names_of(Method) {
  return kMethodNames;
}
inline constexpr const auto& names_of(Fill::Arrangement) {
  return kArrangementNames;
}
inline constexpr const auto& names_of(Box::Origin) {
  return kOriginNames;
}

template <>
struct Table<Box> {
  static constexpr std::string_view kName = "the box";
  static constexpr std::string_view kAbout = "The rectangle the balls live in.";
  static constexpr std::tuple kKeys{
      key("width", &Box::width, "Length in x.").limited(Limit::positive).required("20"),
      key("height", &Box::height, "Length in y.").limited(Limit::positive).required("10"),
      key("periodic", &Box::periodic,
          "Axes that wrap: what leaves on one side comes in on the other."),
      key("origin", &Box::origin,
          "corner: the box spans [0, width] x [0, height]; center: [-width/2, width/2] x "
          "[-height/2, height/2].")};
};

inline constexpr std::string_view kRestitution =
    "Speed after an impact to speed before, along the normal: 1 loses nothing, 0 sticks.";
inline constexpr std::string_view kSwitch =
    "false: switched off, until a script or a key switches it on.";

template <>
struct Table<Walls> {
  static constexpr std::string_view kName = "walls";
  static constexpr std::string_view kAbout =
      "The sides that are not periodic are solid. Without it balls leave through them.";
  static constexpr std::tuple kKeys{
      key("restitution", &Walls::restitution, kRestitution).limited(Limit::fraction).always(),
      key("on", &Walls::on, kSwitch)};
};

template <>
struct Table<Collisions> {
  static constexpr std::string_view kName = "collisions";
  static constexpr std::string_view kAbout =
      "Balls collide. Without it they pass through each other.";
  static constexpr std::tuple kKeys{
      key("restitution", &Collisions::restitution, kRestitution).limited(Limit::fraction).always(),
      key("on", &Collisions::on, kSwitch)};
};

template <>
struct Table<Drag> {
  static constexpr std::string_view kName = "drag";
  static constexpr std::string_view kAbout = "dv/dt = -rate v.";
  static constexpr std::tuple kKeys{key("rate", &Drag::rate, "1/s, the same for every ball.")
                                        .limited(Limit::not_negative)
                                        .required("0.1")};
};

template <>
struct Table<Friction> {
  static constexpr std::string_view kName = "friction";
  static constexpr std::string_view kAbout = "Coulomb friction at impacts; balls spin.";
  static constexpr std::tuple kKeys{key("balls", &Friction::balls, "Coefficient between balls.")
                                        .limited(Limit::not_negative)
                                        .always(),
                                    key("walls", &Friction::walls, "Coefficient at walls.")
                                        .limited(Limit::not_negative)
                                        .always()};
};

template <>
struct Table<Attraction> {
  static constexpr std::string_view kName = "attraction";
  static constexpr std::string_view kAbout =
      "Every ball attracts every other with strength m / (d^2 + softening^2).";
  static constexpr std::tuple kKeys{
      key("strength", &Attraction::strength, "Negative: they repel.").required("1"),
      key("softening", &Attraction::softening, "A length.").limited(Limit::not_negative).always()};
};

template <>
struct Table<Effects> {
  static constexpr std::string_view kName = "effects";
  static constexpr std::string_view kAbout =
      "The whole list of what is simulated: an effect that is not named is not simulated.";
  static constexpr std::tuple kKeys = std::apply(
      [](const auto&... entries) { return std::tuple{key(entries.name, entries.slot)...}; },
      kEffects);
};

template <>
struct Table<Ball> {
  static constexpr std::string_view kName = "a ball";
  static constexpr std::string_view kAbout = "A disk.";
  static constexpr std::tuple kKeys{
      key("position", &Ball::position, "Its centre [x, y].").required("[3, 5]"),
      key("velocity", &Ball::velocity, "[x, y]; must be 0 for a fixed ball."),
      key("radius", &Ball::radius).limited(Limit::positive).always(),
      key("mass", &Ball::mass).limited(Limit::positive),
      key("spin", &Ball::spin, "rad/s, counter-clockwise; used with friction."),
      key("fixed", &Ball::fixed, "Never moves, as if its mass were infinite."),
      key("glyph", &Ball::glyph, "The ASCII character it is drawn with.")};
};

template <>
struct Table<Fill> {
  static constexpr std::string_view kName = "a fill";
  static constexpr std::string_view kAbout =
      "Many equal balls; they avoid the balls and fills before them.";
  static constexpr std::tuple kKeys{
      key("count", &Fill::count).required("200").at_most(kMostBalls),
      key("radius", &Fill::radius).limited(Limit::positive).always(),
      key("mass", &Fill::mass).limited(Limit::positive).always(),
      key("temperature", &Fill::temperature,
          "Gaussian velocities of variance temperature / mass in each component, with zero "
          "momentum in all.")
          .limited(Limit::not_negative)
          .always(),
      key("arrangement", &Fill::arrangement).always(),
      key("region", &Fill::region,
          "Lower left and upper right corner of the part they lie in, whole. Default: the box."),
      key("glyph", &Fill::glyph, "The ASCII character it is drawn with.")};
};

template <>
struct Table<SolverChoice> {
  static constexpr std::string_view kName = "the solver";
  static constexpr std::string_view kAbout = "How the scene is computed.";
  static constexpr std::tuple kKeys{
      key("method", &SolverChoice::method,
          "Default: event where it can take the scene, else overlap."),
      key("step", &SolverChoice::step, "Seconds; default 1/240.").limited(Limit::positive).always(),
      key<Form::digits>("digits", &SolverChoice::digits, "Decimal digits that event computes with.")
          .always()};
};

template <>
struct Table<NewStep> {
  static constexpr std::string_view kName = "the solver in a script";
  static constexpr std::string_view kAbout{};
  static constexpr std::tuple kKeys{
      key("step", &NewStep::step, "A new step, seconds.").limited(Limit::positive)};
};

template <class Line>
inline constexpr auto kAt = key("at", &Line::at,
                                "Seconds of the frame clock, which runs on while paused.")
                                .limited(Limit::not_negative)
                                .required("1.5");
template <class Line>
inline constexpr auto kCommand = key("command", &Line::command).required("\"pause\"");

template <>
struct Table<AddLine> {
  static constexpr std::string_view kName = "the command \"add\"";
  static constexpr std::string_view kAbout{};
  static constexpr std::tuple kKeys{
      kAt<AddLine>, kCommand<AddLine>,
      key("ball", &AddLine::ball).required(R"({"position": [1, 1], "radius": 0.5})")};
};
template <>
struct Table<RemoveLine> {
  static constexpr std::string_view kName = "the command \"remove\"";
  static constexpr std::string_view kAbout{};
  static constexpr std::tuple kKeys{
      kAt<RemoveLine>, kCommand<RemoveLine>,
      key("ball", &RemoveLine::ball, "Its number at that time, from 0; default: the newest.")};
};
template <>
struct Table<PauseLine> {
  static constexpr std::string_view kName = "the command \"pause\"";
  static constexpr std::string_view kAbout{};
  static constexpr std::tuple kKeys{kAt<PauseLine>, kCommand<PauseLine>};
};
template <>
struct Table<ResumeLine> {
  static constexpr std::string_view kName = "the command \"resume\"";
  static constexpr std::string_view kAbout{};
  static constexpr std::tuple kKeys{kAt<ResumeLine>, kCommand<ResumeLine>};
};
template <>
struct Table<SetLine> {
  static constexpr std::string_view kName = "the command \"set\"";
  static constexpr std::string_view kAbout{};
  static constexpr std::tuple kKeys{
      kAt<SetLine>, kCommand<SetLine>,
      key("effects", &SetLine::effects,
          "New values for effects that the scene names; what is not named keeps its value."),
      key("solver", &SetLine::solver)};
};
template <>
struct Table<QuitLine> {
  static constexpr std::string_view kName = "the command \"quit\"";
  static constexpr std::string_view kAbout{};
  static constexpr std::tuple kKeys{kAt<QuitLine>, kCommand<QuitLine>};
};
template <>
struct Table<AnyLine> {
  static constexpr std::string_view kName = "a script line";
  static constexpr std::string_view kAbout{};
  static constexpr std::tuple kKeys{kAt<AnyLine>, kCommand<AnyLine>};
};

template <>
struct Table<SavedFlight> {
  static constexpr std::string_view kName = "a flight";
  static constexpr std::string_view kAbout =
      "A flight as exactly as the method holds it: decimal numbers in quotes.";
  static constexpr std::tuple kKeys{
      key<Form::decimal>("start", &SavedFlight::start,
                         "When it began, in ticks of the present epoch of the clock.")
          .required("\"-1234\""),
      key<Form::decimal>("position", &SavedFlight::position).required(R"(["3", "5"])"),
      key<Form::decimal>("velocity", &SavedFlight::velocity).required(R"(["1", "0"])"),
      key<Form::decimal>("spin", &SavedFlight::spin),
      key("left", &SavedFlight::left, "The fixed ball at which it began."),
      key("carried", &SavedFlight::support,
          "The axes along which something carries it: 1 for x, 2 for y, 3 for both; 4 to 7 sliding "
          "along a wall with friction, 8 and 9 rolling, 10 turning in a corner; 11 in a contact "
          "island at rest, 12 in one that moves, 13 joining it.")
          .at_most(13),
      key("left_out", &SavedFlight::left_out,
          "The energy, in joules, that a flight of an elastic contact island is counted without.")};
};

template <>
struct Table<SavedJam> {
  static constexpr std::string_view kName = "what was counted of jams";
  static constexpr std::string_view kAbout =
      "What method event has counted to find balls that are jammed.";
  static constexpr std::tuple kKeys{
      key<Form::decimal>("since", &SavedJam::since,
                         "When the present span of time began, in ticks of the present epoch of "
                         "the clock.")
          .required("\"-1234\""),
      key("impacts", &SavedJam::impacts, "In that span.").always(),
      key("found", &SavedJam::found, "How often the present jam has been found; 0: there is none.")
          .at_most(kMostJamsFound),
      key("found_before", &SavedJam::found_before, "The same of the last one.")
          .at_most(kMostJamsFound),
      key("lasts", &SavedJam::lasts, "For how many spans a jam lasts.").at_most(kMostJamSpans),
      key("spans", &SavedJam::spans, "Since a jam was found, or was over; 64: or more.")
          .at_most(kMostJamSpans)};
};

template <>
struct Table<Continuation> {
  static constexpr std::string_view kName = "a continuation";
  static constexpr std::string_view kAbout =
      "Where a saved run stood, so that it goes on bit for bit; written by carom run --save.";
  static constexpr std::tuple kKeys{
      key("time", &Continuation::time, "Simulated seconds.").limited(Limit::not_negative).always(),
      key("clock", &Continuation::clock, "Seconds of the frame clock.")
          .limited(Limit::not_negative)
          .always(),
      key("paused", &Continuation::paused).always(),
      key("clock_origin", &Continuation::clock_origin,
          "Seconds of the frame clock when a pause last ended.")
          .limited(Limit::not_negative),
      key("time_origin", &Continuation::time_origin, "Simulated seconds when a pause last ended.")
          .limited(Limit::not_negative),
      key("step_origin", &Continuation::step_origin,
          "Simulated seconds at step number 0 of the present step.")
          .limited(Limit::not_negative)
          .always(),
      key("steps", &Continuation::steps, "Whole steps since then.").always(),
      key("tick", &Continuation::tick, "Of the clock of method event, seconds: a power of two.")
          .limited(Limit::power_of_two),
      key("jam", &Continuation::jam),
      key("rests", &Continuation::rests, "Method event looked for contacts that rest."),
      key<Form::streamed>("flights", &Continuation::flights,
                          "Of method event: of each ball, in order, where and how fast it left "
                          "its last impact.")};
};

template <>
struct Table<Scene> {
  static constexpr std::string_view kName = "a scene";
  static constexpr std::string_view kAbout =
      "Colliding balls in a box. Units are the scene's own, any consistent set: metres, seconds, "
      "kilograms. The origin is the lower left corner of the box, x to the right, y up.";
  static constexpr std::tuple kKeys{
      key<Form::unused>("$schema", &Scene::about,
                        "This schema, for editors: \"scene.schema.json\"."),
      key<Form::line>("name", &Scene::name,
                      "One line of text, shown on the status line. Default: the file's name."),
      key("about", &Scene::about, "What the scene shows."),
      key("box", &Scene::box).required(R"({"width": 20, "height": 10})"),
      key("effects", &Scene::effects).always(),
      key<Form::streamed>("balls", &Scene::balls, "The balls one by one."),
      key("fill", &Scene::fills, "Many balls at once, drawn from the seed."),
      key("seed", &Scene::seed,
          "What the fills are drawn from: the same seed gives the same scene on every machine.")
          .always(),
      key("solver", &Scene::solver).always(),
      key<Form::workers>("workers", &Scene::workers,
                         "Worker threads: \"per-ball\" or a number. Default: one per ball up to "
                         "256 balls, above that one per core. The result never depends on it.")
          .at_most(kMostWorkers),
      key("duration", &Scene::duration, "Simulated seconds of a headless run.")
          .limited(Limit::not_negative)
          .always(),
      key("frame_rate", &Scene::frame_rate,
          "Frames per second of the frame clock. The trajectory does not depend on it.")
          .limited(Limit::positive)
          .always(),
      key<Form::script>("script", &Scene::script,
                        "Commands at times of the frame clock; sorted by time, lines of one time "
                        "in their order."),
      key("continuation", &Scene::continuation)};
};

}  // namespace carom::scene
