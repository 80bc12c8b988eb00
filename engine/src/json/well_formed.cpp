#include "json/well_formed.hpp"

#include "json/reader.hpp"
#include "json/text.hpp"

namespace carom::json {
namespace {

/// What keeps a text from being JSON, or is complained of if so asked; empty: nothing.
std::string wrong_with(std::string_view text, bool complaints) {
  if (const auto problem = find_text_problem(text)) return problem->message;
  Reader reader(text);
  try {
    reader.skip();
    reader.end();
  } catch (const Malformed& malformed) {
    return malformed.message;
  }
  if (!complaints || reader.complaints().empty()) return "";
  return reader.complaints().front().message;
}

}  // namespace

bool is_well_formed(std::string_view text) {
  return wrong_with(text, false).empty();
}

std::string what_is_wrong(std::string_view text) {
  return wrong_with(text, true);
}

std::string meaning_of(std::string_view quoted) {
  return Reader(quoted).text();
}

}  // namespace carom::json
