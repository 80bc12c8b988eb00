#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "contact/impact_log.hpp"
#include "solvers/event/disk.hpp"

namespace carom::event {

/// What an event loop tells of its impacts: lines in a log, if there is one.
///
/// The lines of impacts of the present instant can be taken back as long as it lasts.  What a ball
/// has slid ends with its flight, which can be taken back, too: it becomes a line when the instant
/// is over.
///
/// Holds: without a log nothing is kept.
class ImpactNotes {
 public:
  /// From now on lines go to this log, which must outlive this; null: to none.
  void write_to(ImpactLog* log) { log_ = log; }
  [[nodiscard]] bool wanted() const { return log_ != nullptr; }

  /// How many lines the log has.
  [[nodiscard]] std::size_t lines() const { return log_ == nullptr ? 0 : log_->impacts.size(); }
  /// The number that the lines of a joint impact share, if the next one is its first.
  [[nodiscard]] std::uint64_t next_event() const { return lines() + 1; }
  void add(const Impact& line) {
    if (log_ != nullptr) log_->impacts.push_back(line);
  }
  void add(const std::vector<Impact>& lines);
  /// The lines from `first` on tell together what was lost.
  void tell_loss(std::size_t first, double lost);
  /// Takes back `count` lines from number `first` on.
  void take_back(std::size_t first, std::size_t count);

  /// A ball's slide that ends at this instant.
  void add_slide(const Impact& slide) {
    if (log_ != nullptr) slides_.push_back(slide);
  }
  /// The ball's flight goes on after all, at this time.
  void take_back_slides(Index ball, double seconds);
  /// The instant is over.
  void keep_slides() {
    if (slides_.empty()) return;
    add(slides_);
    slides_.clear();
  }
  void forget_slides() { slides_.clear(); }

 private:
  ImpactLog* log_ = nullptr;
  std::vector<Impact> slides_;
};

}  // namespace carom::event
