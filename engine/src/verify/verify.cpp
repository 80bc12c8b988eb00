#include "carom/verify.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "carom/scene_file.hpp"
#include "verify/cases.hpp"

namespace carom {

namespace {

using hard::Case;
using hard::Line;
using hard::Trial;

std::vector<Case> all_cases() {
  std::vector<Case> all;
  for (auto* const family : {hard::simultaneous_cases, hard::timing_cases, hard::loss_cases,
                             hard::contact_cases, hard::event_contact_cases, hard::symmetry_cases,
                             hard::long_cases, hard::fluid_cases, hard::start_cases}) {
    for (Case& each : family()) all.push_back(std::move(each));
  }
  return all;
}

CaseResult run_line(const Case& each, const Line& line, const VerifyRequest& request) {
  CaseResult result;
  result.name = each.name;
  result.method = line.method;
  result.measure = line.measure;
  result.limit = line.limit;
  result.not_for = line.not_for;
  const auto begin = std::chrono::steady_clock::now();
  try {
    Trial trial{hard_scene(result.name), request.seed, request.thorough};
    trial.scene.solver.method = line.method;
    trial.scene.workers = 1;  // where the number of workers is not what is tried
    trial.scene.per_ball = false;
    result.value = line.value(trial);
    result.passed = result.value <= result.limit;
  } catch (const std::exception& error) {
    result.value = std::numeric_limits<double>::quiet_NaN();
    result.failure = error.what();
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> result;
  for (const Case& each : all_cases()) {
    const std::string name(each.name);
    result.push_back({name, hard_scene(name).about});
  }
  return result;
}

Scene hard_scene(const std::string& name) {
  const std::string_view text = hard::hard_scene_text(name);
  if (text.empty()) throw std::invalid_argument(fmt::format("there is no hard case '{}'", name));
  return parse_scene(text, name);
}

std::vector<CaseResult> verify(const VerifyRequest& request,
                               const std::function<void(const CaseResult&)>& tell) {
  std::vector<CaseResult> results;
  for (const Case& each : all_cases()) {
    if (!request.name.empty() && request.name != each.name) continue;
    for (const Line& line : each.lines) {
      results.push_back(run_line(each, line, request));
      tell(results.back());
    }
  }
  if (results.empty()) {
    throw std::invalid_argument(fmt::format("there is no hard case '{}'", request.name));
  }
  return results;
}

}  // namespace carom
