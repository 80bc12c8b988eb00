#include <cmath>
#include <nlohmann/json.hpp>

#include "carom/accuracy.hpp"
#include "carom/report.hpp"

namespace carom {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& number) {
  return number ? Json(*number) : Json(nullptr);
}

/// The members of a run that should come to rest; null in all others.
void set_rest(Json& json, const AccuracyRow& row) {
  const auto set = [&](const char* name, const std::optional<MedianAndSpread>& value) {
    json[name] = value ? Json(value->median) : Json(nullptr);
    json[std::string(name) + "_spread"] = value ? Json(value->spread) : Json(nullptr);
  };
  const AccuracyRest& rest = *row.rest;
  set("equilibrium_residual", rest.equilibrium_residual);
  set("creep", rest.creep);
  set("kinetic_energy", rest.kinetic_energy);
  set("rest_time", rest.rest_time);
  set("dissipation_error", rest.dissipation_error);
  set("height", rest.height);
}

Json to_tree(const std::optional<MeanAndError>& mean) {
  if (!mean) return nullptr;
  return {{"mean", mean->mean}, {"standard_error", or_null(mean->standard_error)}};
}

/// The averages of a row beside those of the reference.
Json averages_of(const AccuracyStudy& study, const AccuracyRow& row) {
  Json json = Json::object();
  for (std::size_t i = 0; i < study.observables.size(); ++i) {
    Json& each = json[observable_name(study.observables[i])];
    each = i < row.averages.size() ? to_tree(row.averages[i]) : Json(nullptr);
    if (each.is_null()) continue;
    const auto& reference = study.averages[i];
    each["difference"] = reference ? Json(row.averages[i]->mean - reference->mean) : Json(nullptr);
  }
  return json;
}

Json to_tree(const AccuracyStudy& study, const AccuracyRow& row) {
  Json json;
  json["method"] = method_name(row.method);
  json["step"] = or_null(row.step);
  json["digits"] = row.digits;
  json["workers"] = row.workers;
  json["per_ball"] = row.per_ball;
  const bool failed = !row.failure.empty();
  const auto set = [&](const char* name, const auto& value) {
    json[name] = failed ? Json(nullptr) : Json(value);
  };
  set("seconds", row.seconds);
  set("seconds_fastest", row.fastest);
  set("seconds_slowest", row.slowest);
  set("seconds_quartiles", row.quartiles);
  set("cpu_seconds", row.cpu_seconds);
  set("repeats", row.repeats);
  set("seconds_per_simulated_second", study.seconds_per_simulated_second(row));
  set("position_error", or_null(row.position_error));
  set("energy_error", or_null(row.energy_error));
  set("max_overlap", row.max_overlap);
  set("ball_ball", row.ball_ball);
  set("ball_wall", row.ball_wall);
  set("horizon", or_null(row.horizon));
  set("horizon_resolution", row.horizon ? Json(row.horizon_resolution) : Json(nullptr));
  if (row.rest) set_rest(json, row);
  if (!study.observables.empty()) json["observables"] = averages_of(study, row);
  if (failed) json["failed"] = row.failure;
  return json;
}

}  // namespace

std::string to_json(const AccuracyStudy& study) {
  const AccuracyReference& reference = study.reference;
  Json json;
  json["version"] = version();
  json["scene"] = study.scene;
  json["time"] = study.time;
  json["balls"] = study.balls;
  json["smallest_radius"] = study.smallest_radius;
  json["seed"] = study.seed;
  json["machine"] = {{"processor", study.machine.processor},
                     {"cores", study.machine.cores},
                     {"system", study.machine.system}};
  json["compiler"] = study.machine.compiler;
  json["starts"] = study.starts;
  json["reference"] = {
      {"method", reference.equilibrium ? "equilibrium" : method_name(reference.method)},
      {"digits", reference.digits},
      {"step", or_null(reference.step)},
      {"checked_digits", reference.checked_digits},
      {"checked_step", or_null(reference.checked_step)},
      {"difference", reference.difference},
      {"holds_until", or_null(reference.holds_until)},
      {"seconds", reference.seconds},
      {"ball_ball", reference.ball_ball},
      {"ball_wall", reference.ball_wall}};
  if (!reference.absent.empty())
    json["reference"] = {{"method", nullptr}, {"absent", reference.absent}};
  if (!study.observables.empty()) {
    Json& means = json["reference"]["observables"];
    for (std::size_t i = 0; i < study.averages.size(); ++i) {
      means[observable_name(study.observables[i])] = to_tree(study.averages[i]);
    }
    json["reference"]["observables_digits"] = study.average_digits;
  }
  json["rows"] = Json::array();
  for (const AccuracyRow& row : study.rows) json["rows"].push_back(to_tree(study, row));
  json["ladder_end"] = study.ladder_end.empty() ? Json(nullptr) : Json(study.ladder_end);
  json["target"] = or_null(study.target);
  json["recommended"] =
      study.recommended ? to_tree(study, study.rows[*study.recommended]) : Json(nullptr);
  return json.dump(2) + '\n';
}

}  // namespace carom
