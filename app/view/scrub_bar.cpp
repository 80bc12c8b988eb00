#include "view/scrub_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace carom {
namespace {

constexpr double kMegabyte = 1048576;

struct Places {
  std::string before;
  std::string after;
  int begin = 0;  // the first column of the bar
  int end = 0;    // behind its last
};

Places places_of(const ScrubBar& bar, int columns) {
  Places places;
  places.before = fmt::format(" {:.2f} s [", bar.first);
  places.after =
      fmt::format("] {:.2f} s  {:.1f} MB ", bar.last, static_cast<double>(bar.bytes) / kMegabyte);
  places.begin = static_cast<int>(places.before.size());
  places.end = std::max(places.begin + 1, columns - static_cast<int>(places.after.size()));
  return places;
}

}  // namespace

Canvas scrub_bar(const ScrubBar& bar, int columns, Glyphs glyphs) {
  Canvas row(columns, 1);
  const bool ascii = glyphs == Glyphs::ascii;
  const Places places = places_of(bar, columns);
  row.write(0, 0, places.before, Ink::status);
  row.write(places.end, 0, places.after, Ink::status);
  const double part = bar.last > bar.first ? (bar.now - bar.first) / (bar.last - bar.first) : 1;
  const int mark =
      places.begin +
      static_cast<int>(std::lround(std::clamp(part, 0.0, 1.0) * (places.end - places.begin - 1)));
  for (int column = places.begin; column < places.end; ++column) {
    const char32_t passed = ascii ? U'=' : U'━';
    const char32_t coming = ascii ? U'-' : U'─';
    row.put(column, 0, column < mark ? passed : coming, Ink::status);
  }
  row.put(mark, 0, ascii ? U'#' : U'█', Ink::notice);
  return row;
}

double moment_at(const ScrubBar& bar, int columns, int column) {
  const Places places = places_of(bar, columns);
  const int cells = std::max(1, places.end - places.begin - 1);
  const double part = std::clamp(static_cast<double>(column - places.begin) / cells, 0.0, 1.0);
  return part == 1 ? bar.last : bar.first + part * (bar.last - bar.first);
}

}  // namespace carom
