#pragma once

#include <string>
#include <string_view>

namespace carom::json {

/// Whether a text is JSON, but for complaints.
bool is_well_formed(std::string_view text);
/// What is wrong with a text; empty: it is JSON, and nothing in it is a complaint.
std::string what_is_wrong(std::string_view text);
/// The text that a JSON text of quotes means.
/// REQUIRES: well-formed.
std::string meaning_of(std::string_view quoted);

}  // namespace carom::json
