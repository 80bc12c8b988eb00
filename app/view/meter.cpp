#include "view/meter.hpp"

namespace carom {
namespace {

constexpr std::chrono::duration<double> kMemory{1.0};
constexpr double kEnough = 0.4;  // seconds of frames from which a pace can be told

}  // namespace

void Meter::record(Instant now, double time, std::chrono::duration<double> computing) {
  frames_.push_back({now, time, computing});
  while (frames_.size() > 2 && now - frames_.front().at > kMemory) frames_.pop_front();
}

double Meter::span() const {
  if (frames_.size() < 2) return 0;
  return std::chrono::duration<double>(frames_.back().at - frames_.front().at).count();
}

double Meter::frames_per_second() const {
  return span() > 0 ? static_cast<double>(frames_.size() - 1) / span() : 0;
}

double Meter::computing_milliseconds() const {
  if (frames_.empty()) return 0;
  double sum = 0;
  for (const Shown& frame : frames_) sum += frame.computing.count();
  return 1000 * sum / static_cast<double>(frames_.size());
}

std::optional<double> Meter::pace() const {
  if (span() < kEnough) return std::nullopt;
  return (frames_.back().time - frames_.front().time) / span();
}

}  // namespace carom
