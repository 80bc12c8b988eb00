#include "accuracy_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "carom/report.hpp"

namespace carom {
namespace {

constexpr int kColumns = 64;
constexpr int kRows = 18;
constexpr int kRowsToNumber = 3;     // rows with a number beside them
constexpr int kMargin = 10;          // of the numbers
constexpr int kDigitsOfDouble = 16;  // digits: what needs more is drawn at the lower edge
constexpr double kRoom = 0.5;        // decades below the lowest mark
constexpr double kLeastHeight = 1;   // decades

struct Mark {
  double x = 0;  // decimal logarithms
  double y = 0;
  Method method = Method::event;
  bool line = false;  // one of those a line joins: the first crew's, in double precision
  bool best = false;
  bool below = false;  // under the lower edge
};

struct Range {
  double low = 0;
  double high = 0;

  [[nodiscard]] int place(double value, int cells) const {
    const double part = high > low ? (value - low) / (high - low) : 0.5;
    return std::clamp(static_cast<int>(std::lround(part * (cells - 1))), 0, cells - 1);
  }
};

/// Rows of characters, row 0 at the top.
class Sheet {
 public:
  Sheet() : rows_(kRows, std::string(kColumns, ' ')) {}

  void set(int column, int row, char character) {
    rows_[static_cast<std::size_t>(kRows - 1 - row)][static_cast<std::size_t>(column)] = character;
  }
  void line(int from_column, int from_row, int to_column, int to_row) {
    const int steps = std::max(std::abs(to_column - from_column), std::abs(to_row - from_row));
    for (int i = 1; i < steps; ++i) {
      const double part = static_cast<double>(i) / steps;
      set(static_cast<int>(std::lround(from_column + part * (to_column - from_column))),
          static_cast<int>(std::lround(from_row + part * (to_row - from_row))), '.');
    }
  }
  [[nodiscard]] const std::string& row(int from_top) const {
    return rows_[static_cast<std::size_t>(from_top)];
  }

 private:
  std::vector<std::string> rows_;
};

std::vector<Mark> marks_of(const AccuracyStudy& study) {
  std::vector<Mark> marks;
  const std::vector<bool> best = best_choices(study);
  const bool by_horizon = study.judged_by_horizon();
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const AccuracyRow& row = study.rows[i];
    const double seconds = study.seconds_per_simulated_second(row);
    if (!row.failure.empty() || !(seconds > 0)) continue;
    std::optional<double> value = row.position_error;
    if (by_horizon) value = study.right_until(row);
    if (row.rest) value = AccuracyStudy::rest_error(row);
    if (!value || !std::isfinite(*value)) continue;
    const AccuracyRow& first = study.rows.front();
    Mark mark;
    mark.x = std::log10(seconds);
    mark.method = row.method;
    mark.line = row.workers == first.workers && row.per_ball == first.per_ball;
    mark.best = best[i];
    mark.below = *value == 0 || (!by_horizon && row.digits > kDigitsOfDouble);
    mark.y = mark.below ? 0 : std::log10(*value);
    marks.push_back(mark);
  }
  return marks;
}

void join(Sheet& sheet, const std::vector<Mark>& marks, Method method, const Range& x,
          const Range& y) {
  const Mark* before = nullptr;
  for (const Mark& mark : marks) {
    if (mark.method != method || !mark.line) continue;
    if (before != nullptr) {
      sheet.line(x.place(before->x, kColumns), y.place(before->y, kRows), x.place(mark.x, kColumns),
                 y.place(mark.y, kRows));
    }
    before = &mark;
  }
}

/// Decades below the axis, where there is room for them.
std::string decades(const Range& x) {
  std::string line(kColumns + 8, ' ');
  std::size_t free = 0;
  for (int decade = static_cast<int>(std::ceil(x.low)); decade <= x.high; ++decade) {
    const auto at = static_cast<std::size_t>(x.place(decade, kColumns));
    const std::string text = fmt::format("1e{}", decade);
    if (at < free) continue;
    line.replace(at, text.size(), text);
    free = at + text.size() + 1;
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

}  // namespace

std::string to_plot(const AccuracyStudy& study) {
  std::vector<Mark> marks = marks_of(study);
  if (marks.empty()) return "";
  Range x{marks.front().x, marks.front().x};
  std::optional<Range> y;
  bool below = false;
  for (const Mark& mark : marks) {
    x = {std::min(x.low, mark.x), std::max(x.high, mark.x)};
    below = below || mark.below;
    if (mark.below) continue;
    if (!y) y = Range{mark.y, mark.y};
    y = Range{std::min(y->low, mark.y), std::max(y->high, mark.y)};
  }
  const bool all_below = !y;
  if (!y) y = Range{0, 0};
  if (const double lacking = kLeastHeight - (y->high - y->low); lacking > 0) {
    y = Range{y->low - lacking / 2, y->high + lacking / 2};
  }
  if (below) y->low -= std::max(kRoom, (y->high - y->low) / kRows * 2);
  for (Mark& mark : marks) {
    if (mark.below) mark.y = y->low;
  }

  Sheet sheet;
  for (const Method method : {Method::overlap, Method::event}) join(sheet, marks, method, x, *y);
  for (const bool best : {false, true}) {  // the best lie above
    for (const Mark& mark : marks) {
      if (mark.best != best) continue;
      const char letter = mark.method == Method::overlap ? 'o' : 'e';
      sheet.set(x.place(mark.x, kColumns), y->place(mark.y, kRows),
                best ? static_cast<char>(letter - 'a' + 'A') : letter);
    }
  }

  const bool by_horizon = study.judged_by_horizon();
  std::string text = by_horizon ? "  predictability horizon, s\n" : "  error of position\n";
  if (study.reference.equilibrium) text = "  residual of equilibrium or overlap, the larger\n";
  for (int row = 0; row < kRows; ++row) {
    const double part = static_cast<double>(kRows - 1 - row) / (kRows - 1);
    std::string number;
    if (below && row == kRows - 1) {
      number = "0 or less";
    } else if (row % kRowsToNumber == 0 && !all_below) {
      number = fmt::format("{:.1e}", std::pow(10.0, y->low + part * (y->high - y->low)));
    }
    std::string line = fmt::format("{:>{}} |{}", number, kMargin - 1, sheet.row(row));
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  const std::string margin(kMargin, ' ');
  text += fmt::format("{}+{}\n{} {}\n", margin, std::string(kColumns, '-'), margin, decades(x));
  text += fmt::format("{} seconds per simulated second; o overlap, e event, O E the Pareto front\n",
                      margin);
  return text;
}

}  // namespace carom
