#include "solvers/event/resolutions.hpp"

#include <algorithm>

namespace carom::event {

void Resolutions::reset(std::size_t balls) {
  number_of_.assign(balls, -1);
  balls_.clear();
  resolutions_.clear();
}

auto Resolutions::with(std::span<const Index> balls) -> Chosen {
  Chosen chosen(resolutions_.size());
  for (const Index i : balls) {
    if (contains(i)) chosen.sets_[set_of(i)] = 1;
  }
  return chosen;
}

void Resolutions::take_back(const Chosen& chosen) {
  std::erase_if(balls_, [&](Index i) {
    if (!contains(chosen, i)) return false;
    number_of_[i] = -1;
    return true;
  });
  for (std::size_t k = resolutions_.size(); k-- > 0;) {
    if (chosen.sets_[sets_.find(static_cast<std::uint32_t>(k))] != 0) take_back(resolutions_[k]);
  }
}

void Resolutions::take_back(Resolution& resolution) {
  counts_.take_back(resolution.counts, resolution.counts_after);
  book_.take_back(resolution.kept, resolution.kept_after);
  const std::size_t lines = resolution.lines_after - resolution.lines;
  notes_.take_back(resolution.lines, lines);
  for (Resolution& other : resolutions_) {
    if (other.lines <= resolution.lines) continue;
    other.lines -= lines;
    other.lines_after -= lines;
  }
  resolution.counts_after = resolution.counts;
  resolution.kept_after = resolution.kept;
  resolution.lines_after = resolution.lines;
}

}  // namespace carom::event
