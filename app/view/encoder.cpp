#include "view/encoder.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <tuple>
#include <vector>

namespace carom {
namespace {

/// Cells next to each other that are sent together, all of one look.
struct Run {
  int row = 0;
  int column = 0;
  int length = 0;
  Look look;
  bool blank = true;  ///< nothing but blanks: they look the same in any foreground
};

bool same_ground(const Look& a, const Look& b) {
  return a.back == b.back && a.reverse == b.reverse;
}

/// Where the cursor is and how it writes.
struct Pen {
  int column = -1;
  int row = -1;  // unknown
  Look look;
};

constexpr int kShortGap = 4;  // cells: crossed one by one

class EscapeWriter {
 public:
  EscapeWriter(const Canvas& canvas, const Palette& palette) : canvas_(canvas), palette_(palette) {}

  void write(const Run& run) {
    move(run.column, run.row);
    if (!run.blank || !same_ground(pen_.look, run.look)) {
      palette_.change(pen_.look, run.look, bytes_);
      pen_.look = run.look;
    }
    for (int i = 0; i < run.length; ++i)
      append_utf8(canvas_.at(run.column + i, run.row).character, bytes_);
    pen_.column += run.length;
    // Behind the last column a terminal may or may not have gone on to the next row.
    if (pen_.column >= canvas_.columns) pen_.row = -1;
  }

  /// How many bytes it takes to get to a run.
  [[nodiscard]] int way_to(const Run& run) const { return bytes_of_way(run.column, run.row); }
  [[nodiscard]] int row() const { return pen_.row; }

  std::string finish() {
    palette_.change(pen_.look, Look(), bytes_);
    return std::move(bytes_);
  }

 private:
  void move(int column, int row) {
    if (pen_.row == row && column > pen_.column && column <= pen_.column + kShortGap &&
        rewrite(column))
      return;
    bytes_ += way(column, row);
    pen_.column = column;
    pen_.row = row;
  }

  static int digits(int value) { return value < 10 ? 1 : value < 100 ? 2 : value < 1000 ? 3 : 4; }
  static int bytes_absolute(int column, int row) {
    return 3 + (row > 0 || column > 0 ? digits(row + 1) : 0) +
           (column > 0 ? 1 + digits(column + 1) : 0);
  }
  [[nodiscard]] int bytes_relative(int column, int row) const {
    const auto sequence = [](int times) { return 3 + (times == 1 ? 0 : digits(times)); };
    const int down = row - pen_.row;
    const int gap = column - pen_.column;
    int bytes = 0;
    if (down > 0 && down <= kShortGap) {
      bytes = down;
    } else if (down != 0) {
      bytes = sequence(std::abs(down));
    }
    if (gap == 0) return bytes;
    if (column == 0) return bytes + 1;
    return bytes + (gap < 0 && gap >= -kShortGap ? -gap : sequence(std::abs(gap)));
  }
  [[nodiscard]] int bytes_of_way(int column, int row) const {
    const int absolute = bytes_absolute(column, row);
    return pen_.row < 0 ? absolute : std::min(absolute, bytes_relative(column, row));
  }

  /// The shortest of what moves the cursor there.
  [[nodiscard]] std::string way(int column, int row) const {
    if (pen_.row < 0 || bytes_absolute(column, row) < bytes_relative(column, row)) {
      std::string absolute = "\x1B[";
      if (row > 0 || column > 0) absolute += number(row + 1);
      if (column > 0) absolute += ';' + number(column + 1);
      return absolute + 'H';
    }
    std::string relative;
    if (row > pen_.row && row <= pen_.row + kShortGap) {
      // Vertical tabulation: every terminal takes it as one row down, in the same column.
      relative.append(static_cast<std::size_t>(row - pen_.row), '\v');
    } else if (row != pen_.row) {
      relative = "\x1B[" + count(std::abs(row - pen_.row)) + (row > pen_.row ? 'B' : 'A');
    }
    const int gap = column - pen_.column;
    if (gap == 0) return relative;
    if (column == 0) return relative + '\r';
    if (gap < 0 && gap >= -kShortGap) return relative.append(static_cast<std::size_t>(-gap), '\b');
    return relative + "\x1B[" + count(std::abs(gap)) + (gap > 0 ? 'C' : 'D');
  }

  static std::string number(int value) { return std::to_string(value); }
  /// One is what a terminal takes where no number is.
  static std::string count(int value) { return value == 1 ? "" : number(value); }

  /// Writing the cells in between again, where they look as the pen writes, is shorter than moving.
  bool rewrite(int column) {
    for (int i = pen_.column; i < column; ++i) {
      const Cell& cell = canvas_.at(i, pen_.row);
      if (cell.character >= 0x80 || palette_.look(cell) != pen_.look) {
        // A blank shows no foreground, bold or dim.
        Look as_pen = pen_.look;
        const Look blank = palette_.look(cell);
        if (cell.character != U' ' || blank.reverse != as_pen.reverse || blank.back != as_pen.back)
          return false;
      }
    }
    for (int i = pen_.column; i < column; ++i)
      append_utf8(canvas_.at(i, pen_.row).character, bytes_);
    pen_.column = column;
    return true;
  }

  const Canvas& canvas_;
  const Palette& palette_;
  std::string bytes_;
  Pen pen_;
};

std::vector<Run> changes(const Canvas& before, const Canvas& after, const Palette& palette) {
  std::vector<Run> runs;
  for (int row = 0; row < after.rows; ++row) {
    for (int column = 0; column < after.columns; ++column) {
      const Cell& cell = after.at(column, row);
      const Cell& old = before.at(column, row);
      if (cell == old) continue;
      const Look look = palette.look(cell);
      if (cell.character == old.character && look == palette.look(old)) continue;
      const bool blank = cell.character == U' ';
      if (!runs.empty()) {
        Run& last = runs.back();
        const bool next = last.row == row && last.column + last.length == column;
        const bool fits =
            last.look == look || ((blank || last.blank) && same_ground(last.look, look));
        if (next && fits) {
          ++last.length;
          if (last.blank && !blank) last.look = look;
          last.blank = last.blank && blank;
          continue;
        }
      }
      runs.push_back({row, column, 1, look, blank});
    }
  }
  return runs;
}

std::string in_rows(const std::vector<Run>& runs, const Canvas& canvas, const Palette& palette) {
  EscapeWriter writer(canvas, palette);
  for (const Run& run : runs) writer.write(run);
  return writer.finish();
}

bool by_look(const Run& a, const Run& b) {
  const auto key = [](const Run& run) {
    return std::tuple(run.look.reverse, run.look.dim, run.look.bold, run.look.back,
                      run.blank ? kDefaultColor : run.look.fore);
  };
  return key(a) < key(b);
}

/// Runs look by look, of each always the one that the cursor gets to in the fewest bytes; blanks,
/// which look the same in all, on the way.
class Gathering {
 public:
  Gathering(const std::vector<Run>& runs, const Canvas& canvas, const Palette& palette)
      : runs_(runs), writer_(canvas, palette), rows_(static_cast<std::size_t>(canvas.rows)) {
    std::stable_sort(runs_.begin(), runs_.end(), by_look);
    written_.resize(runs_.size(), false);
    for (std::size_t i = 0; i < runs_.size(); ++i)
      rows_[static_cast<std::size_t>(runs_[i].row)].push_back(i);
  }

  std::string write() {
    for (std::size_t first = 0; first < runs_.size(); ++first) {
      if (written_[first]) continue;
      write(first);
      while (const auto next = nearest(runs_[first].look)) write(*next);
    }
    return writer_.finish();
  }

 private:
  void write(std::size_t run) {
    writer_.write(runs_[run]);
    written_[run] = true;
  }

  /// One of this look, or blank, that is nearer than a jump anywhere.
  [[nodiscard]] std::optional<std::size_t> nearest(const Look& look) const {
    constexpr int kAbove = 3;
    constexpr int kBelow = 5;
    constexpr int kJump = 8;
    std::optional<std::size_t> found;
    int fewest = kJump;
    const int last = static_cast<int>(rows_.size()) - 1;
    if (writer_.row() < 0) return found;
    for (int row = std::max(0, writer_.row() - kAbove);
         row <= std::min(last, writer_.row() + kBelow); ++row) {
      for (const std::size_t run : rows_[static_cast<std::size_t>(row)]) {
        const Run& candidate = runs_[run];
        if (written_[run] ||
            !(candidate.look == look || (candidate.blank && same_ground(candidate.look, look))))
          continue;
        const int bytes = writer_.way_to(candidate);
        if (bytes >= fewest) continue;
        fewest = bytes;
        found = run;
      }
    }
    return found;
  }

  std::vector<Run> runs_;
  EscapeWriter writer_;
  std::vector<std::vector<std::size_t>> rows_;  // the runs in each
  std::vector<bool> written_;
};

}  // namespace

std::string Encoder::show(const Canvas& canvas) {
  const bool whole = shown_.columns != canvas.columns || shown_.rows != canvas.rows;
  if (whole) shown_ = Canvas(canvas.columns, canvas.rows);
  const std::vector<Run> runs = changes(shown_, canvas, palette_);
  std::string bytes = in_rows(runs, canvas, palette_);
  std::string gathered = Gathering(runs, canvas, palette_).write();
  if (gathered.size() < bytes.size()) bytes = std::move(gathered);
  shown_ = canvas;
  return whole ? "\x1B[m\x1B[2J" + bytes : bytes;
}

void append_utf8(char32_t character, std::string& bytes) {
  const auto add = [&bytes](std::uint32_t byte) { bytes += static_cast<char>(byte); };
  const std::uint32_t code = character;
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0U | (code >> 6U));
    add(0x80U | (code & 0x3FU));
  } else if (code < 0x10000) {
    add(0xE0U | (code >> 12U));
    add(0x80U | ((code >> 6U) & 0x3FU));
    add(0x80U | (code & 0x3FU));
  } else {
    add(0xF0U | (code >> 18U));
    add(0x80U | ((code >> 12U) & 0x3FU));
    add(0x80U | ((code >> 6U) & 0x3FU));
    add(0x80U | (code & 0x3FU));
  }
}

}  // namespace carom
