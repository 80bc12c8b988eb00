#include "solvers/event/impact_notes.hpp"

#include <algorithm>

namespace carom::event {

void ImpactNotes::add(const std::vector<Impact>& lines) {
  if (log_ != nullptr) log_->impacts.insert(log_->impacts.end(), lines.begin(), lines.end());
}

void ImpactNotes::tell_loss(std::size_t first, double lost) {
  if (first >= lines()) return;
  double told = 0;
  for (std::size_t k = first; k < lines(); ++k) told += log_->impacts[k].energy_lost;
  log_->impacts[first].energy_lost += lost - told;
}

void ImpactNotes::take_back(std::size_t first, std::size_t count) {
  if (count == 0 || log_ == nullptr) return;
  const auto at = log_->impacts.begin() + static_cast<std::ptrdiff_t>(first);
  const auto next = log_->impacts.erase(at, at + static_cast<std::ptrdiff_t>(count));
  // A joint impact is numbered as its first line.
  for (auto line = next; line != log_->impacts.end(); ++line) {
    if (line->event != 0) line->event -= count;
  }
}

void ImpactNotes::take_back_slides(Index ball, double seconds) {
  std::erase_if(slides_,
                [&](const Impact& slide) { return slide.a == ball && slide.time == seconds; });
}

}  // namespace carom::event
