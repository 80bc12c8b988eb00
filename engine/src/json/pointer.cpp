#include "json/pointer.hpp"

#include "json/text.hpp"

namespace carom::json {

std::string pointer_step(std::string_view key) {
  std::string step;
  for (const char c : key) {
    if (c == '~') {
      step += "~0";
    } else if (c == '/') {
      step += "~1";
    } else {
      step += c;
    }
  }
  return printable(step);
}

}  // namespace carom::json
