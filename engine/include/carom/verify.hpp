#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "carom/scene.hpp"

namespace carom {

/// What a hard case gave: one measure of one method, held against its limit.
struct CaseResult {
  std::string name;  ///< of the case, as of its scene
  Method method = Method::event;
  std::string measure;  ///< what `value` is
  double value = 0;     ///< NaN where there is none
  double limit = 0;     ///< the most that is right
  bool passed = false;
  std::string not_for;  ///< why the method cannot meet it by its nature; empty: it must
  std::string failure;  ///< what stopped it; empty: nothing
  double seconds = 0;   ///< wall clock
};

/// A hard case: a scene that breaks simulators of this kind.
struct HardCase {
  std::string name;
  std::string about;
};

/// All of them, in the order in which they are run.
std::vector<HardCase> hard_cases();

/// The scene of a case, as in scenes/hard/NAME.json.
/// Errors: std::invalid_argument where there is no such case.
Scene hard_scene(const std::string& name);

/// Runs the cases and tells each result as it comes.
///
/// `seed`: of what the cases vary at random; the same seed gives the same values on every machine.
/// `thorough`: the long versions, which take minutes.
/// Errors: std::invalid_argument where there is no case `name` (empty: all); what a case throws is
/// its failure.
struct VerifyRequest {
  std::string name;
  std::uint64_t seed = 1;
  bool thorough = false;
};
std::vector<CaseResult> verify(const VerifyRequest& request,
                               const std::function<void(const CaseResult&)>& tell);

/// As JSON: cases, passed, failed; what a method cannot meet by its nature stands apart.
std::string to_json(const std::vector<CaseResult>& results);

}  // namespace carom
