#include "view/settings_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "carom/names.hpp"
#include "export/output_file.hpp"
#include "view/settings.hpp"

namespace carom {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 4> kKeys{"glyphs", "palette", "fps", "mouse"};

[[noreturn]] void refuse(const fs::path& file, const std::string& place,
                         const std::string& message) {
  throw std::runtime_error(fmt::format("{}: {}: {}", file.string(), place, message));
}

/// "line 3, column 5" of a byte, counted from 1.
std::string place_of(const std::string& text, std::size_t byte) {
  const std::string before = text.substr(0, byte == 0 ? 0 : byte - 1);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const auto last = before.rfind('\n');
  const std::size_t column = last == std::string::npos ? before.size() + 1 : before.size() - last;
  return fmt::format("line {}, column {}", line, column);
}

/// Null where there is no file.
Json parsed(const fs::path& file) {
  std::error_code error;
  if (file.empty() || !fs::exists(file, error)) return nullptr;
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream || fs::is_directory(file, error))
    throw std::runtime_error(file.string() + ": cannot be read");
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& wrong) {
    refuse(file, place_of(text, wrong.byte), "is not valid JSON");
  }
}

template <class Value, class Named>
std::optional<Value> word(const Json& value, const fs::path& file, const std::string& key,
                          const std::string& words, const Named& named) {
  if (value.is_string()) {
    if (const auto known = named(value.get<std::string>())) return known;
  }
  refuse(file, '/' + key, fmt::format("must be {}, got {}", words, value.dump()));
}

int frames_per_second(const Json& value, const fs::path& file) {
  if (value.is_number_integer()) {
    const double number = value.get<double>();
    if (number >= Settings::kSlowest && number <= Settings::kFastest) return value.get<int>();
  }
  refuse(file, "/fps",
         fmt::format("must be a whole number from {} to {}, got {}", Settings::kSlowest,
                     Settings::kFastest, value.dump()));
}

}  // namespace

fs::path settings_file() {
  const char* const config = std::getenv("XDG_CONFIG_HOME");
  if (config != nullptr && fs::path(config).is_absolute())
    return fs::path(config) / "carom" / "config.json";
  const char* const home = std::getenv("HOME");
  if (home == nullptr || *home == '\0') return {};
  return fs::path(home) / ".config" / "carom" / "config.json";
}

StoredSettings read_settings(const fs::path& file) {
  StoredSettings settings;
  const Json all = parsed(file);
  if (all.is_null()) return settings;
  if (!all.is_object()) throw std::runtime_error(file.string() + ": must be a JSON object");
  for (const auto& [key, value] : all.items()) {
    if (key == "glyphs") {
      settings.glyphs =
          word<Glyphs>(value, file, key, R"("ascii", "blocks" or "braille")", glyphs_named);
    } else if (key == "palette") {
      settings.palette =
          word<Background>(value, file, key, R"("any", "dark" or "light")", background_named);
    } else if (key == "fps") {
      settings.fps = frames_per_second(value, file);
    } else if (key == "mouse") {
      if (!value.is_boolean())
        refuse(file, "/mouse", fmt::format("must be true or false, got {}", value.dump()));
      settings.mouse = value.get<bool>();
    } else {
      refuse(file, '/' + key,
             fmt::format("unknown key, the nearest one is {}", nearest_word(key, kKeys)));
    }
  }
  return settings;
}

void remember_glyphs(const fs::path& file, Glyphs glyphs) {
  if (file.empty()) throw std::runtime_error("there is no home folder");
  Json all = parsed(file);
  if (all.is_null()) all = Json::object();
  all["glyphs"] = name_of(glyphs);
  fs::create_directories(file.parent_path());
  OutputFile output("settings", file.string());
  output.write(all.dump(2) + '\n');
  output.commit();
}

}  // namespace carom
