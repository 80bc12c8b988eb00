#include "carom/verify.hpp"

#include <algorithm>
#include <string_view>

#include "carom/report.hpp"
#include "json/writer.hpp"

namespace carom {

namespace {

using json::Writer;

bool runs(const CaseResult& result) {
  return result.not_for.empty();
}

void put_case(Writer& writer, const CaseResult& result) {
  writer.begin_object()
      .put("name", result.name)
      .put("method", method_name(result.method))
      .put("measure", result.measure)
      .put("value", result.value)
      .put("limit", result.limit)
      .put("passed", result.passed)
      .put("seconds", result.seconds);
  if (!result.failure.empty()) writer.put("failure", result.failure);
  if (!runs(result)) writer.put("not_for", result.not_for);
  writer.end_object();
}

/// A case on a line.
void put_cases(Writer& writer, std::string_view name, const std::vector<CaseResult>& results,
               bool that_run) {
  writer.key(name).begin_list(Writer::Layout::lines);
  for (const CaseResult& result : results) {
    if (runs(result) == that_run) put_case(writer, result);
  }
  writer.end_list();
}

}  // namespace

std::string to_json(const std::vector<CaseResult>& results) {
  const auto run = std::count_if(results.begin(), results.end(), runs);
  const auto passed = std::count_if(results.begin(), results.end(), [](const CaseResult& result) {
    return runs(result) && result.passed;
  });
  std::string text;
  Writer writer([&](std::string_view part) { text += part; });
  writer.begin_object(Writer::Layout::lines);
  put_cases(writer, "cases", results, true);
  writer.put("passed", passed).put("failed", run - passed);
  if (run < std::ssize(results)) put_cases(writer, "not_for", results, false);
  writer.end_object().finish();
  return text;
}

}  // namespace carom
