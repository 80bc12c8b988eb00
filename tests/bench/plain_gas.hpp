#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <vector>

namespace carom::bench {

/// Equal disks of diameter and mass 1 in a periodic square, event by event, with as little as that
/// takes: cells, one event a ball, a heap.  What the exact method is measured beside: no tests, no
/// order of bits, one kind of scene.
class PlainGas {
 public:
  struct Ball {
    double x, y, vx, vy;
    double since = 0;
  };

  PlainGas(double side, std::vector<Ball> balls)
      : side_(side),
        cells_(std::max(3, static_cast<int>(side / 1.0001))),
        balls_(std::move(balls)) {
    events_.resize(balls_.size());
    members_.resize(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_));
    cell_.resize(balls_.size());
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      cell_[i] = cell_at(balls_[i].x, balls_[i].y);
      members_[cell_[i]].push_back(static_cast<std::uint32_t>(i));
    }
    for (std::size_t i = 0; i < balls_.size(); ++i) predict(i, 0);
  }

  [[nodiscard]] std::uint64_t collisions() const { return collisions_; }

  void advance_to(double until) {
    while (!queue_.empty() && queue_.top().time <= until) {
      const Entry next = queue_.top();
      queue_.pop();
      const std::size_t i = next.ball;
      if (next.version != events_[i].version) continue;
      const Event event = events_[i];
      if (event.partner == kCell) {
        move(i, event.time);
      } else if (events_[event.partner].changes == event.partner_changes) {
        collide(i, event.partner, event.time);
        predict(event.partner, event.time);
      }
      predict(i, event.time);
    }
  }

 private:
  static constexpr std::size_t kCell = std::numeric_limits<std::size_t>::max();
  struct Event {
    double time = 0;
    std::size_t partner = kCell;
    std::uint32_t partner_changes = 0;
    std::uint32_t changes = 0;
    std::uint32_t version = 0;
  };
  struct Entry {
    double time;
    std::size_t ball;
    std::uint32_t version;
    bool operator<(const Entry& other) const { return time > other.time; }
  };

  [[nodiscard]] double image(double d) const { return d - side_ * std::rint(d / side_); }
  [[nodiscard]] std::size_t cell_at(double x, double y) const {
    const auto along = [this](double a) {
      const double part = a / side_ - std::floor(a / side_);
      return static_cast<std::size_t>(std::min(cells_ - 1, static_cast<int>(part * cells_)));
    };
    return along(y) * static_cast<std::size_t>(cells_) + along(x);
  }

  void fly(Ball& ball, double now) const {
    ball.x += ball.vx * (now - ball.since);
    ball.y += ball.vy * (now - ball.since);
    ball.since = now;
  }

  void collide(std::size_t i, std::size_t j, double now) {
    Ball& a = balls_[i];
    Ball& b = balls_[j];
    fly(a, now);
    fly(b, now);
    const double dx = image(b.x - a.x);
    const double dy = image(b.y - a.y);
    const double k = ((b.vx - a.vx) * dx + (b.vy - a.vy) * dy) / (dx * dx + dy * dy);
    a.vx += k * dx;
    a.vy += k * dy;
    b.vx -= k * dx;
    b.vy -= k * dy;
    ++events_[i].changes;
    ++events_[j].changes;
    ++collisions_;
  }

  void move(std::size_t i, double now) {
    Ball& ball = balls_[i];
    const double x = ball.x + ball.vx * (now - ball.since);
    const double y = ball.y + ball.vy * (now - ball.since);
    // A little ahead, so that it is beyond the side it has come to.
    const std::size_t cell = cell_at(x + 1e-9 * ball.vx, y + 1e-9 * ball.vy);
    std::vector<std::uint32_t>& old = members_[cell_[i]];
    *std::find(old.begin(), old.end(), static_cast<std::uint32_t>(i)) = old.back();
    old.pop_back();
    members_[cell].push_back(static_cast<std::uint32_t>(i));
    cell_[i] = cell;
  }

  void predict(std::size_t i, double now) {
    const Ball& a = balls_[i];
    const auto cells = static_cast<std::size_t>(cells_);
    const std::size_t cx = cell_[i] % cells;
    const std::size_t cy = cell_[i] / cells;
    Event& event = events_[i];
    event.partner = kCell;
    event.time = std::min(leaves(a.x + a.vx * (now - a.since), a.vx, cx, now),
                          leaves(a.y + a.vy * (now - a.since), a.vy, cy, now));
    for (std::size_t y = cy + cells - 1; y <= cy + cells + 1; ++y) {
      for (std::size_t x = cx + cells - 1; x <= cx + cells + 1; ++x) {
        for (const std::uint32_t j : members_[(y % cells) * cells + x % cells]) {
          if (j == i) continue;
          const Ball& b = balls_[j];
          const double dx = image(b.x + b.vx * (now - b.since) - a.x - a.vx * (now - a.since));
          const double dy = image(b.y + b.vy * (now - b.since) - a.y - a.vy * (now - a.since));
          const double vx = b.vx - a.vx;
          const double vy = b.vy - a.vy;
          const double along = dx * vx + dy * vy;
          if (!(along < 0)) continue;
          const double square = vx * vx + vy * vy;
          const double gap = dx * dx + dy * dy - 1;
          const double discriminant = along * along - square * gap;
          if (!(discriminant > 0)) continue;
          const double time = now + std::max(0.0, gap / (std::sqrt(discriminant) - along));
          if (time < event.time) {
            event.time = time;
            event.partner = j;
            event.partner_changes = events_[j].changes;
          }
        }
      }
    }
    queue_.push({event.time, i, ++event.version});
  }

  /// When it leaves its cell along an axis.
  [[nodiscard]] double leaves(double x, double v, std::size_t cell, double now) const {
    const double width = side_ / cells_;
    const double off = image(x - (static_cast<double>(cell) + 0.5) * width);
    if (v == 0) return std::numeric_limits<double>::infinity();
    return now + std::max(0.0, (v > 0 ? width / 2 - off : width / 2 + off) / std::abs(v));
  }

  double side_;
  int cells_;
  std::vector<Ball> balls_;
  std::vector<Event> events_;
  std::vector<std::vector<std::uint32_t>> members_;
  std::vector<std::size_t> cell_;
  std::priority_queue<Entry> queue_;
  std::uint64_t collisions_ = 0;
};

}  // namespace carom::bench
