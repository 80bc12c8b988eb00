#include "view/threads_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "view/panel.hpp"
#include "view/wrap.hpp"

namespace carom {
namespace {

constexpr int kWordy = 56;     // from here on lanes are called "worker 12"
constexpr int kMarkApart = 4;  // cells between two marks that go through all lanes
constexpr int kOther = 2;      // rows: control, legend
constexpr int kTwoNames = 12;  // so many rows have two with names of barriers

/// The characters of a lane.
struct Signs {
  char32_t computes;
  char32_t partly;  ///< less than half a cell
  char32_t waits;
  char32_t mark;
};
constexpr Signs kAsciiSigns{U'#', U'+', U'~', U'|'};
constexpr Signs kLineSigns{U'█', U'▌', U'─', U'│'};

constexpr char32_t kAsciiLevels[] = {U' ', U'.', U':', U'-', U'=', U'+', U'*', U'#', U'@'};
constexpr char32_t kLineLevels[] = {U' ', U'▁', U'▂', U'▃', U'▄', U'▅', U'▆', U'▇', U'█'};

class Painter {
 public:
  Painter(const ThreadsView& view, int columns, int rows, Glyphs glyphs)
      : view_(view),
        lanes_(view.lanes),
        ascii_(glyphs == Glyphs::ascii),
        signs_(ascii_ ? kAsciiSigns : kLineSigns),
        canvas_(columns, rows),
        left_(1 + static_cast<int>(columns >= kWordy
                                       ? label(0).size()
                                       : fmt::format("{}", lanes_.workers.size()).size())),
        names_(rows >= kTwoNames ? 2 : 1),
        cells_(std::max(0, columns - left_)),
        per_cell_(cells_ > 0 ? static_cast<double>(lanes_.end - lanes_.begin) / cells_ : 0) {}

  Canvas paint() {
    const std::vector<std::string> words = wrapped(view_.now, canvas_.columns);
    if (cells_ < 1 || lanes_.empty() || !(per_cell_ > 0)) {
      paint_words(0, words);
      return std::move(canvas_);
    }
    find_marks();
    paint_names();
    const int other = names_ + kOther;
    const int most = canvas_.rows - other - 1;
    const int explained =
        words.empty() ? 0 : std::max(kRowsOfWords, static_cast<int>(words.size()));
    const auto room =
        static_cast<std::size_t>(std::max(1, canvas_.rows - other - std::min(explained, most)));
    paint_control(names_);
    int row = names_ + 1;
    const bool all = room >= lanes_.workers.size();
    const auto some = busiest(view_.computed, all ? lanes_.workers.size() : room - 1);
    for (const std::size_t worker : some) paint_lane(row++, label(worker), lanes_.workers[worker]);
    if (!all) paint_sum(row++);
    paint_legend(row++, all);
    paint_words(row, words);
    return std::move(canvas_);
  }

 private:
  [[nodiscard]] std::string label(std::size_t worker) const {
    const auto digits = fmt::format("{}", lanes_.workers.size() - 1).size();
    return fmt::format("worker {:>{}}", worker, digits);
  }
  [[nodiscard]] double time_at(int cell) const {
    return static_cast<double>(lanes_.begin) + cell * per_cell_;
  }
  [[nodiscard]] int cell_at(std::int64_t time) const {
    return static_cast<int>(static_cast<double>(time - lanes_.begin) / per_cell_);
  }
  [[nodiscard]] bool happened(int cell) const {
    return time_at(cell) < static_cast<double>(view_.until);
  }

  /// Marks go through all lanes where they leave enough room between them.
  void find_marks() {
    std::vector<int> marks;
    for (const Passage& passage : lanes_.passages) {
      if (passage.at <= view_.until) marks.push_back(std::min(cells_ - 1, cell_at(passage.at)));
    }
    if (static_cast<int>(marks.size()) * kMarkApart > cells_) return;
    marked_.assign(static_cast<std::size_t>(cells_), false);
    for (const int mark : marks) marked_[static_cast<std::size_t>(mark)] = true;
  }

  /// The names of barriers, each ending at its mark, as far as there is room; a tick where there is
  /// none.  The first and the last barrier of a frame go first.
  void paint_names() {
    const auto last = static_cast<std::uint32_t>(view_.barriers.size() - 1);
    for (const bool outer : {true, false}) {
      for (const Passage& passage : lanes_.passages) {
        if (passage.at > view_.until) break;
        const bool is_outer = passage.barrier == 0 || passage.barrier == last;
        if (is_outer == outer) paint_name(passage);
      }
    }
  }

  void paint_name(const Passage& passage) {
    const std::string& name = view_.barriers[passage.barrier];
    const int size = static_cast<int>(name.size());
    const int mark = left_ + std::min(cells_ - 1, cell_at(passage.at));
    const int begin = std::max(left_, mark - size + 1);
    for (int row = 0; row < names_; ++row) {
      if (!is_free(row, begin - 1, begin + size + 1)) continue;
      canvas_.write(begin, row, name, Ink::notice);
      return;
    }
    if (is_free(names_ - 1, mark, mark + 1))
      canvas_.put(mark, names_ - 1, ascii_ ? U'\'' : U'╷', Ink::notice);
  }

  [[nodiscard]] bool is_free(int row, int begin, int end) const {
    for (int column = std::max(0, begin); column < std::min(end, canvas_.columns); ++column) {
      if (canvas_.holds(column, row) && canvas_.at(column, row).character != U' ') return false;
    }
    return end <= canvas_.columns + 1;
  }

  /// It orders frames, and waits in between.
  void paint_control(int row) {
    paint_lane(row, "control", {});
    for (const Passage& passage : lanes_.passages) {
      if (passage.barrier == 0 && passage.at <= view_.until)
        canvas_.put(left_ + std::min(cells_ - 1, cell_at(passage.at)), row, signs_.computes,
                    Ink::computes);
    }
  }

  void paint_lane(int row, const std::string& name, const std::vector<Stretch>& lane) {
    if (left_ > static_cast<int>(name.size())) {
      canvas_.write(0, row, name, Ink::status);
    } else {
      const auto digits = name.find_first_of("0123456789");
      canvas_.write(0, row, digits == std::string::npos ? "c" : name.substr(digits), Ink::status);
    }
    for (int cell = 0; cell < cells_ && happened(cell); ++cell) {
      const double part = computing_in(lane, time_at(cell), time_at(cell + 1)) / per_cell_;
      const Ink ink = part > 0 ? Ink::computes : Ink::waits;
      char32_t sign = part >= 0.5 ? signs_.computes : part > 0 ? signs_.partly : signs_.waits;
      if (is_marked(cell) && !(part >= 0.5)) {
        canvas_.put(left_ + cell, row, signs_.mark, Ink::status);
      } else {
        canvas_.put(left_ + cell, row, sign, ink);
      }
    }
  }

  void paint_words(int row, const std::vector<std::string>& words) {
    for (const std::string& line : words) canvas_.write(0, row++, line, Ink::notice);
  }

  /// How many of all workers compute, as heights.
  void paint_sum(int row) {
    canvas_.write(0, row, left_ > 4 ? fmt::format("all {}", lanes_.workers.size()) : "all",
                  Ink::status);
    const double all = per_cell_ * static_cast<double>(lanes_.workers.size());
    std::vector<double> computed(static_cast<std::size_t>(cells_));
    for (const std::vector<Stretch>& lane : lanes_.workers) {
      for (const Stretch& stretch : lane) add(stretch, computed);
    }
    for (int cell = 0; cell < cells_ && happened(cell); ++cell) {
      const double part = computed[static_cast<std::size_t>(cell)] / all;
      const auto level = static_cast<std::size_t>(std::ceil(8 * std::clamp(part, 0.0, 1.0)));
      canvas_.put(left_ + cell, row, (ascii_ ? kAsciiLevels : kLineLevels)[level], Ink::computes);
    }
  }

  /// What of the stretch lies in each cell.
  void add(const Stretch& stretch, std::vector<double>& computed) const {
    const auto begin = static_cast<double>(stretch.begin);
    const auto end = static_cast<double>(stretch.end);
    for (int cell = std::max(0, cell_at(stretch.begin)); cell < cells_ && time_at(cell) < end;
         ++cell) {
      computed[static_cast<std::size_t>(cell)] +=
          std::max(0.0, std::min(end, time_at(cell + 1)) - std::max(begin, time_at(cell)));
    }
  }

  void paint_legend(int row, bool all) {
    canvas_.put(0, row, signs_.computes, Ink::computes);
    canvas_.write(2, row, "computes", Ink::status);
    canvas_.put(12, row, signs_.waits, Ink::waits);
    canvas_.write(14, row, "waits", Ink::status);
    std::vector<std::string> words{fmt::format("waiting {:.0f} %", 100 * share_of_waiting(lanes_))};
    const std::size_t last = most_often_last(lanes_);
    if (last < lanes_.workers.size())
      words.push_back(fmt::format("last to arrive: worker {}", last));
    if (!all) words.push_back(fmt::format("the busiest of {} workers", lanes_.workers.size()));
    int column = 22;
    for (const std::string& word : words) {
      if (column + static_cast<int>(word.size()) > canvas_.columns) break;
      canvas_.write(column, row, word, Ink::status);
      column += static_cast<int>(word.size()) + 3;
    }
  }

  [[nodiscard]] bool is_marked(int cell) const {
    return !marked_.empty() && marked_[static_cast<std::size_t>(cell)];
  }

  const ThreadsView& view_;
  const Lanes& lanes_;
  bool ascii_;
  Signs signs_;
  Canvas canvas_;
  int left_;
  int names_;  // rows of names
  int cells_;
  double per_cell_;
  std::vector<bool> marked_;  // empty: no marks through the lanes
};

}  // namespace

Canvas threads_panel(const ThreadsView& view, int columns, int rows, Glyphs glyphs) {
  return framed(Painter(view, columns - kFrame, rows - kFrame, glyphs).paint(), view.title, glyphs);
}

}  // namespace carom
