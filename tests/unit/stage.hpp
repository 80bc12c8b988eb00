#pragma once

#include <algorithm>
#include <chrono>
#include <csignal>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "view/encoder.hpp"
#include "view/user_interface.hpp"

namespace carom {

/// A stand-in for the terminal: its time passes only while the player waits, and as much more for
/// each look at the clock as a test says; events come when the test says.
class Stage : public UserInterface {
 public:
  struct Act {
    double at = 0;
    Event event;
    std::chrono::seconds unseen{0};  ///< passes before the event is told
  };
  struct Shot {
    double at = 0;
    std::string text;  ///< line by line

    [[nodiscard]] bool says(const std::string& words) const {
      return text.find(words) != std::string::npos;
    }
  };

  void key(double at, int key) { acts_.push_back({at, {Event::Kind::key, key, {}}, {}}); }
  void keys(double at, const std::string& keys) {
    for (const char each : keys) key(at, each);
  }
  void event(double at, Event event) { acts_.push_back({at, event, {}}); }
  void stop(double at, std::chrono::seconds unseen) {
    acts_.push_back({at, {Event::Kind::resumed, 0, {}}, unseen});
  }
  void resize(double at, Size size) {
    resizes_.emplace_back(at, size);
    event(at, {Event::Kind::resized, 0, {}});
  }

  [[nodiscard]] Size size() const override { return size_; }
  void show(const Canvas& canvas) override {
    Shot shot{seconds(), {}};
    for (int row = 0; row < canvas.rows; ++row) {
      for (int column = 0; column < canvas.columns; ++column)
        append_utf8(canvas.at(column, row).character, shot.text);
      shot.text += '\n';
    }
    shots.push_back(shot);
    now_ += drawing;
  }
  Event wait_until(Instant deadline) override {
    if (acts_.empty()) {
      if (deadline - now_ > std::chrono::hours{1}) return {Event::Kind::ended, SIGTERM, {}};
      now_ = std::max(now_, deadline);
      return {};
    }
    const Act act = acts_.front();
    const Instant when = Instant{} + std::chrono::duration_cast<Instant::duration>(
                                         std::chrono::duration<double>(act.at));
    if (when > std::max(deadline, now_)) {
      now_ = std::max(now_, deadline);
      return {};
    }
    acts_.pop_front();
    now_ = std::max(now_, when) + act.unseen;
    if (act.event.kind == Event::Kind::resized && !resizes_.empty()) {
      size_ = resizes_.front().second;
      resizes_.pop_front();
    }
    return act.event;
  }
  [[nodiscard]] Instant now() const override {
    now_ += looking;
    return now_;
  }

  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(now_ - Instant{}).count();
  }
  [[nodiscard]] const Shot& at(double time) const {
    return *std::prev(std::find_if(shots.begin() + 1, shots.end(),
                                   [time](const Shot& shot) { return shot.at > time; }));
  }

  std::vector<Shot> shots;
  std::chrono::milliseconds looking{0};
  std::chrono::milliseconds drawing{0};

 private:
  std::deque<Act> acts_;
  std::deque<std::pair<double, Size>> resizes_;
  Size size_{80, 24};
  mutable Instant now_;
};

}  // namespace carom
