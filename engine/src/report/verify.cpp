#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "carom/report.hpp"
#include "carom/verify.hpp"

namespace carom {

std::string to_json(const std::vector<CaseResult>& results) {
  using Json = nlohmann::ordered_json;
  Json cases = Json::array();
  Json not_for = Json::array();
  std::size_t passed = 0;
  for (const CaseResult& result : results) {
    Json entry = {{"name", result.name},       {"method", method_name(result.method)},
                  {"measure", result.measure}, {"value", nullptr},
                  {"limit", result.limit},     {"passed", result.passed},
                  {"seconds", result.seconds}};
    if (std::isfinite(result.value)) entry["value"] = result.value;
    if (!result.failure.empty()) entry["failure"] = result.failure;
    if (!result.not_for.empty()) {
      entry["not_for"] = result.not_for;
      not_for.push_back(std::move(entry));
      continue;
    }
    if (result.passed) ++passed;
    cases.push_back(std::move(entry));
  }
  const std::size_t failed = cases.size() - passed;
  Json json = {{"cases", std::move(cases)}, {"passed", passed}, {"failed", failed}};
  if (!not_for.empty()) json["not_for"] = std::move(not_for);
  return json.dump(2) + '\n';
}

}  // namespace carom
