#include "view/instruments_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "view/panel.hpp"
#include "view/sparkline.hpp"

namespace carom {
namespace {

constexpr int kBeside = 66;    // columns from which the three stand beside each other
constexpr int kLeastPart = 5;  // of a part
constexpr int kLeastCurve = 4;
constexpr double kNoError = 1e-9;  // smaller errors of means are none
constexpr int kWidestNumber = 10;  // with a blank
constexpr char32_t kLevels[] = {U' ', U'▁', U'▂', U'▃', U'▄', U'▅', U'▆', U'▇', U'█'};

std::string short_number(double value) {
  return fmt::format("{:.4g}", value);
}

std::string average(const std::optional<TimeAverage>& value) {
  if (!value) return "-";
  const bool known = value->error && *value->error > kNoError * std::abs(value->mean);
  return known ? fmt::format("{:.4g} +-{:.1g}", value->mean, *value->error)
               : short_number(value->mean);
}

/// The classes of speeds in so many columns, a whole number of classes each.
int columns_of(std::size_t classes, int room) {
  for (int columns = static_cast<int>(classes); columns > 0; --columns) {
    if (columns <= room && static_cast<int>(classes) % columns == 0) return columns;
  }
  return 0;
}

/// A bar for each class, as high as it is full, and Maxwell's curve over the bars.
class Histogram {
 public:
  Histogram(const SpeedCounts& speeds, int columns, int rows, Glyphs glyphs)
      : speeds_(speeds), ascii_(glyphs == Glyphs::ascii), canvas_(columns, rows) {}

  Canvas paint() {
    const int rows = canvas_.rows - 1;  // the axis stands below
    const int columns = columns_of(speeds_.counts.size(), canvas_.columns);
    if (rows < 1 || columns < 1) {
      canvas_.write(0, 0, "no ball moves yet", Ink::status);
      return std::move(canvas_);
    }
    const std::vector<double> bars = merged(speeds_.counts, columns);
    const std::vector<double> curve = merged(speeds_.expected, columns);
    const double top = std::max(*std::max_element(bars.begin(), bars.end()),
                                *std::max_element(curve.begin(), curve.end()));
    for (int column = 0; column < columns; ++column) {
      const auto k = static_cast<std::size_t>(column);
      paint_bar(column, rows, bars[k] / top * rows,
                (static_cast<float>(column) + 0.5F) / static_cast<float>(columns));
      const int row = rows - 1 - static_cast<int>(std::min(curve[k] / top * rows, rows - 0.5));
      canvas_.put(column, row, ascii_ ? U'*' : U'•', Ink::notice);
    }
    const std::string last = short_number(speeds_.top);
    canvas_.write(0, rows, "0", Ink::status);
    canvas_.write(columns - static_cast<int>(last.size()), rows, last, Ink::status);
    const std::string legend = ascii_ ? "speed, * Maxwell" : "speed,   Maxwell";
    const int at = (columns - static_cast<int>(legend.size())) / 2;
    if (at > 1 && at + static_cast<int>(legend.size() + last.size()) < columns) {
      canvas_.write(at, rows, legend, Ink::status);
      if (!ascii_) canvas_.put(at + 7, rows, U'•', Ink::notice);
    }
    return std::move(canvas_);
  }

 private:
  static std::vector<double> merged(const std::vector<double>& classes, int columns) {
    std::vector<double> result(static_cast<std::size_t>(columns));
    for (std::size_t k = 0; k < classes.size(); ++k)
      result[k * result.size() / classes.size()] += classes[k];
    return result;
  }

  /// The colours are those of balls: twice the thermal speed is the fastest.
  void paint_bar(int column, int rows, double height, float part) {
    for (int row = 0; row < rows; ++row) {
      const double full = std::clamp(height - row, 0.0, 1.0);
      char32_t sign = kLevels[static_cast<std::size_t>(std::lround(8 * full))];
      if (ascii_) sign = full >= 0.75 ? U'#' : full >= 0.25 ? U'.' : U' ';
      canvas_.put(column, rows - 1 - row, sign, Ink::ball, std::min(1.F, kHottest * part));
    }
  }

  static constexpr float kHottest = 1.41F;  // four thermal speeds over twice the mean square's root

  const SpeedCounts& speeds_;
  bool ascii_;
  Canvas canvas_;
};

struct Value {
  std::string name;
  std::string text;
  const std::vector<double>* curve = nullptr;
};

/// Names, values and curves: a curve stands beside its value where the block is wide enough, else
/// below it while rows are left.
Canvas table(const std::vector<Value>& values, int columns, int rows, Glyphs glyphs) {
  Canvas block(columns, rows);
  std::size_t name = 0;
  std::size_t text = 0;
  for (const Value& value : values) {
    name = std::max(name, value.name.size());
    if (value.curve != nullptr) text = std::max(text, value.text.size());
  }
  const int at = static_cast<int>(name) + 1;
  const int curve = at + std::max(kWidestNumber, static_cast<int>(text) + 1);
  const bool beside = columns - curve >= kLeastCurve;
  int spare = rows - static_cast<int>(values.size());
  int row = 0;
  for (const Value& value : values) {
    block.write(0, row, value.name, Ink::status);
    block.write(at, row, value.text, Ink::status);
    if (value.curve != nullptr && beside) {
      lay_over(sparkline(*value.curve, columns - curve, glyphs), curve, row, block);
    } else if (value.curve != nullptr && spare > 0 && columns - at >= kLeastCurve) {
      --spare;
      ++row;
      lay_over(sparkline(*value.curve, columns - at, glyphs), at, row, block);
    }
    ++row;
  }
  return block;
}

std::vector<Value> averages_of(const InstrumentReadings& readings) {
  std::vector<Value> values{{"temperature", average(readings.temperature), &readings.temperatures},
                            {"pressure", average(readings.pressure), &readings.pressures},
                            {"Z", average(readings.Z), &readings.compressibilities}};
  if (readings.theory) values.push_back({"  theory", short_number(readings.theory->Z)});
  values.push_back({"impacts / s", average(readings.impacts_per_second), &readings.impact_rates});
  if (readings.theory)
    values.push_back({"  theory", short_number(readings.theory->impacts_per_second)});
  values.push_back(
      {"free path", readings.mean_free_path ? short_number(*readings.mean_free_path) : "-"});
  return values;
}

std::vector<Value> energies_of(const InstrumentReadings& readings) {
  const auto last = [](const std::vector<double>& values) {
    return values.empty() ? 0 : values.back();
  };
  std::vector<Value> values{
      {"kinetic", short_number(last(readings.kinetic)), &readings.kinetic},
      {"potential", short_number(last(readings.potential)), &readings.potential}};
  if (readings.input != 0) values.push_back({"input", short_number(readings.input)});
  values.push_back({"dissipated", short_number(last(readings.dissipated)), &readings.dissipated});
  values.push_back({"error", exponent(last(readings.error)), &readings.error});
  return values;
}

}  // namespace

Canvas instruments_panel(const InstrumentReadings& readings, int columns, int rows, Glyphs glyphs) {
  const std::string span = fmt::format("mean of {:.3g} s", readings.span);
  const auto speeds = [&](int wide, int high) {
    return framed(Histogram(readings.speeds, wide - kFrame, high - kFrame, glyphs).paint(),
                  "speeds", glyphs);
  };
  const auto averages = [&](int wide, int high) {
    return framed(table(averages_of(readings), wide - kFrame, high - kFrame, glyphs), span, glyphs);
  };
  const auto energies = [&](int wide, int high) {
    return framed(table(energies_of(readings), wide - kFrame, high - kFrame, glyphs), "energy",
                  glyphs);
  };
  Canvas panel(columns, rows);
  if (columns >= kBeside) {
    const int first = columns / 3;
    const int second = (columns - first) / 2;
    lay_over(speeds(first, rows), 0, 0, panel);
    lay_over(averages(second, rows), first, 0, panel);
    lay_over(energies(columns - first - second, rows), first + second, 0, panel);
    return panel;
  }
  int row = 0;
  const auto stack = [&](const auto& part, int wish) {
    const int high = std::min(wish, rows - row);
    if (high < kLeastPart) return;
    lay_over(part(columns, high), 0, row, panel);
    row += high;
  };
  const int tables = static_cast<int>(averages_of(readings).size() + energies_of(readings).size());
  const int room = rows - tables - 2 * kFrame;  // for the bars, where they leave any
  stack(averages, static_cast<int>(averages_of(readings).size()) + kFrame);
  stack(energies, static_cast<int>(energies_of(readings).size()) + kFrame);
  stack(speeds, std::max(room, kLeastPart));
  return panel;
}

}  // namespace carom
