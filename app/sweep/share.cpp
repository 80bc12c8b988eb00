#include "sweep/share.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "options.hpp"

namespace carom::sweeps {
namespace {

std::optional<std::size_t> number(std::string_view text) {
  std::size_t value = 0;
  const auto [stopped, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || stopped != text.data() + text.size()) return {};
  return value;
}

}  // namespace

TaskShare parse_share(const std::string& text) {
  const std::size_t slash = text.find('/');
  const auto index = number(std::string_view(text).substr(0, slash));
  const auto count =
      slash == std::string::npos ? std::nullopt : number(std::string_view(text).substr(slash + 1));
  if (!index || !count) {
    throw UsageError(fmt::format("--share: must be I/N, as in 0/4, got '{}'", text));
  }
  if (*count == 0 || *index >= *count) {
    throw UsageError(fmt::format(
        "--share: I must be from 0 to N - 1, got '{}'; the first share of 4 is 0/4", text));
  }
  return {*index, *count, "--share"};
}

TaskShare share_of_environment(
    const std::function<std::optional<std::string>(const char* name)>& look) {
  const auto value = [&](const char* name) -> std::optional<std::size_t> {
    const auto text = look(name);
    return text ? number(*text) : std::nullopt;
  };
  const auto checked = [](std::size_t index, std::size_t count, const char* from) {
    if (count == 0 || index >= count) {
      throw UsageError(fmt::format("{} says task {} of {}: give the share with --share I/N", from,
                                   index, count));
    }
    return TaskShare{index, count, from};
  };
  if (const auto id = value("SLURM_ARRAY_TASK_ID")) {
    const std::size_t least = value("SLURM_ARRAY_TASK_MIN").value_or(0);
    const std::size_t step = std::max<std::size_t>(1, value("SLURM_ARRAY_TASK_STEP").value_or(1));
    const std::size_t count = value("SLURM_ARRAY_TASK_COUNT").value_or(0);
    return checked((*id - least) / step, count, "Slurm (array)");
  }
  struct Source {
    const char* index;
    const char* count;
    const char* name;
  };
  for (const Source& source : {Source{"SLURM_PROCID", "SLURM_NTASKS", "Slurm"},
                               Source{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "Open MPI"},
                               Source{"PMI_RANK", "PMI_SIZE", "PMI"}}) {
    const auto index = value(source.index);
    const auto count = value(source.count);
    // A job of Slurm that starts one task, which may start others by MPI, says nothing.
    if (index && count && *count > 1) return checked(*index, *count, source.name);
  }
  return {};
}

}  // namespace carom::sweeps
