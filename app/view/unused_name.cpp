#include "view/unused_name.hpp"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <system_error>

namespace carom {

std::string unused_name(const std::string& folder, const std::string& scene,
                        const std::string& ending) {
  constexpr std::size_t kLongest = 60;
  std::string stem;
  for (const char character : scene.substr(0, kLongest)) {
    const bool plain = std::isalnum(static_cast<unsigned char>(character)) != 0;
    if (plain) {
      stem += character;
    } else if (!stem.empty() && stem.back() != '-') {
      stem += '-';
    }
  }
  while (!stem.empty() && stem.back() == '-') stem.pop_back();
  if (stem.empty()) stem = "carom";
  for (int number = 1;; ++number) {
    std::string name = fmt::format("{}/{}-{}{}", folder, stem, number, ending);
    std::error_code ignored;
    if (!std::filesystem::exists(std::filesystem::symlink_status(name, ignored))) return name;
  }
}

}  // namespace carom
