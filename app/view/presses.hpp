#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "view/user_interface.hpp"

namespace carom {

/// Keys and mouse reports that wait to be acted on, in order; equal keys in a row count as one that
/// was pressed so many times.
class Presses {
 public:
  struct Press {
    Event event;
    int times = 1;
  };

  void add(const Event& event) {
    if (!waiting_.empty() && event.kind == Event::Kind::key && waiting_.back().event == event) {
      ++waiting_.back().times;
    } else if (is_drag(event) && !waiting_.empty() && is_drag(waiting_.back().event)) {
      waiting_.back().event = event;  // where the pointer is counts, not its way
    } else if (waiting_.size() < kMost) {
      waiting_.push_back({event, 1});
    }
  }
  [[nodiscard]] bool empty() const { return waiting_.empty(); }
  /// The first, with its repeats.
  [[nodiscard]] const Press& front() const { return waiting_.front(); }
  /// Some of the first have been acted on.
  void done(int times) {
    waiting_.front().times -= times;
    if (waiting_.front().times <= 0) waiting_.pop_front();
  }

 private:
  static bool is_drag(const Event& event) {
    return event.kind == Event::Kind::mouse && event.mouse.action == Mouse::Action::drag;
  }

  static constexpr std::size_t kMost = 10000;  // more than that is a flood, not wishes

  std::deque<Press> waiting_;
};

}  // namespace carom
