#include "carom/verify.hpp"

#include <fmt/format.h>

#include <cmath>

#include "carom/report.hpp"
#include "commands.hpp"
#include "export/output_file.hpp"
#include "export/unfinished_files.hpp"
#include "standard_streams.hpp"

namespace carom {

namespace {

constexpr auto kHeading =
    "case       method   measure                                 value     limit        seconds\n";

/// Whole numbers as such, others with the digits that matter.
std::string measure_text(double value) {
  if (!std::isfinite(value)) return "-";
  if (value == std::trunc(value) && std::abs(value) < 1e6) return fmt::format("{:.0f}", value);
  return fmt::format("{:.2g}", value);
}

std::string verdict(const CaseResult& result) {
  if (!result.not_for.empty()) {
    return fmt::format("not for {}: {}", method_name(result.method), result.not_for);
  }
  return result.passed ? "ok" : "FAILED";
}

std::string line(const CaseResult& result) {
  std::string text =
      fmt::format("{:<10} {:<8} {:<36} {:>9} {:>9}  {:<6} {:>6.2f}\n", result.name,
                  method_name(result.method), result.measure, measure_text(result.value),
                  measure_text(result.limit), verdict(result), result.seconds);
  if (!result.failure.empty()) text += fmt::format("           {}\n", result.failure);
  return text;
}

void refuse_unknown_case(const std::string& name) {
  if (name.empty()) return;
  std::string names;
  for (const HardCase& each : hard_cases()) {
    if (each.name == name) return;
    names += (names.empty() ? "" : ", ") + each.name;
  }
  throw UsageError(fmt::format("--case: must be one of {}, got '{}'", names, name));
}

}  // namespace

int verify(const Options& options) {
  if (options.list) {
    for (const HardCase& each : hard_cases())
      print(fmt::format("{:<10} {}\n", each.name, each.about));
    return 0;
  }
  refuse_unknown_case(options.case_name);
  unfinished_files::remove_on_signals();
  OutputFile json("--json", options.json);
  const bool taken = is_standard_output(options.json);
  const auto say = [taken](const std::string& text) { taken ? print_error(text) : print(text); };

  VerifyRequest request;
  request.name = options.case_name;
  request.seed = options.seed.value_or(request.seed);
  request.thorough = options.thorough;
  say(kHeading);
  const std::vector<CaseResult> results =
      verify(request, [&say](const CaseResult& result) { say(line(result)); });

  std::size_t failed = 0;
  std::size_t asked = 0;
  double seconds = 0;
  for (const CaseResult& result : results) {
    seconds += result.seconds;
    if (!result.not_for.empty()) continue;
    ++asked;
    if (!result.passed) ++failed;
  }
  say(fmt::format("{} of {} passed, {} failed, in {:.0f} s with seed {}\n", asked - failed, asked,
                  failed, seconds, request.seed));
  json.write(to_json(results));
  json.commit();
  return failed == 0 ? 0 : 1;
}

}  // namespace carom
