#include "checkpoint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>

#include "carom/report.hpp"
#include "carom/scene_file.hpp"
#include "export/output_file.hpp"
#include "options.hpp"

namespace carom {
namespace {

constexpr const char* kFirstLine = "carom checkpoint 2";

/// Lines of a name and its values.
class Lines {
 public:
  explicit Lines(std::istream& in) : in_(in) {}

  /// The values of the next line, which has this name.
  std::istringstream next(const std::string& name) {
    std::string line;
    std::getline(in_, line);
    if (!line.starts_with(name + ' ')) throw std::invalid_argument(name);
    return std::istringstream(line.substr(name.size() + 1));
  }

 private:
  std::istream& in_;
};

template <class Number>
void take(std::istream& line, Number& value) {
  std::string word;
  if (!(line >> word)) throw std::invalid_argument("a number");
  if constexpr (std::is_floating_point_v<Number>) {
    value = std::strtod(word.c_str(), nullptr);
  } else {
    value = static_cast<Number>(std::strtoull(word.c_str(), nullptr, 10));
  }
}

/// Calls `visit` with what is summed up or kept of measurements.
template <class M, class Visit>
void for_each_number(M& m, Visit visit) {
  visit(m.ball_ball);
  visit(m.ball_wall);
  visit(m.joint_impacts);
  visit(m.resting_contacts);
  visit(m.jammed);
  visit(m.islands_again);
  visit(m.missed_hits);
  visit(m.energy_initial);
  visit(m.energy_largest);
  visit(m.momentum_initial.x());
  visit(m.momentum_initial.y());
  visit(m.max_overlap);
}

std::string text_of(const Measurements& measured) {
  std::string text = "measured";
  for_each_number(measured, [&](const auto& value) { text += fmt::format(" {}", value); });
  return text + '\n';
}

}  // namespace

CheckpointFile::CheckpointFile(std::string file, double seconds, std::string run)
    : file_(std::move(file)), every_(seconds), run_(std::move(run)) {}

std::optional<Checkpoint> CheckpointFile::read() const {
  std::error_code ignored;
  if (file_.empty() || !std::filesystem::exists(file_, ignored)) return {};
  std::ifstream in(file_, std::ios::binary);
  if (!in) throw UsageError(fmt::format("--checkpoint: {}: cannot be read", file_));
  std::string line;
  std::getline(in, line);
  if (line != kFirstLine) {
    throw UsageError(
        fmt::format("--checkpoint: '{}' exists and is not a checkpoint: name another file", file_));
  }
  std::getline(in, line);
  if (line != "run " + run_) {
    throw UsageError(fmt::format(
        "--checkpoint: '{}' is of another run, whose scene or options differ: remove it, or name "
        "another file",
        file_));
  }
  try {
    Checkpoint result;
    Lines lines(in);
    {
      auto values = lines.next("frames");
      take(values, result.frame);
      take(values, result.first_frame);
      take(values, result.start_time);
    }
    {
      auto values = lines.next("measured");
      for_each_number(result.measured, [&](auto& value) { take(values, value); });
    }
    {
      auto values = lines.next("numbers");
      Bookkeeping& bookkeeping = result.bookkeeping;
      take(values, bookkeeping.next_id);
      take(values, bookkeeping.next_event);
      std::size_t count = 0;
      take(values, count);
      bookkeeping.ids.resize(count);
      for (std::size_t& id : bookkeeping.ids) take(values, id);
    }
    {
      auto values = lines.next("energies");
      std::size_t count = 0;
      take(values, result.bookkeeping.energy_input);
      take(values, count);
      result.bookkeeping.losses.resize(count);
      for (double& loss : result.bookkeeping.losses) take(values, loss);
    }
    auto values = lines.next("files");
    std::size_t count = 0;
    take(values, count);
    for (; count > 0; --count) {
      auto& [option, length] = result.files.emplace_back();
      values >> option;
      take(values, length);
    }
    const std::string scene{std::istreambuf_iterator<char>(in), {}};
    result.scene = parse_scene(scene, file_);
    return result;
  } catch (const std::invalid_argument&) {
    throw UsageError(fmt::format("--checkpoint: '{}' is damaged: remove it", file_));
  }
}

bool CheckpointFile::due() const {
  return !file_.empty() && Clock::now() - last_ >= every_;
}

void CheckpointFile::write(const Checkpoint& checkpoint) {
  std::string text = fmt::format("{}\nrun {}\nframes {} {} {}\n", kFirstLine, run_,
                                 checkpoint.frame, checkpoint.first_frame, checkpoint.start_time);
  text += text_of(checkpoint.measured);
  const Bookkeeping& bookkeeping = checkpoint.bookkeeping;
  text += fmt::format("numbers {} {} {} {}\n", bookkeeping.next_id, bookkeeping.next_event,
                      bookkeeping.ids.size(), fmt::join(bookkeeping.ids, " "));
  text += fmt::format("energies {} {} {}\n", bookkeeping.energy_input, bookkeeping.losses.size(),
                      fmt::join(bookkeeping.losses, " "));
  text += fmt::format("files {}", checkpoint.files.size());
  for (const auto& [option, length] : checkpoint.files) {
    text += fmt::format(" {} {}", option, length);
  }
  OutputFile file("--checkpoint", file_);
  file.write(text + '\n' + write_scene(checkpoint.scene));
  file.commit();
  last_ = Clock::now();
}

void CheckpointFile::remove() const {
  if (!file_.empty()) (void)unlink(file_.c_str());
}

}  // namespace carom
