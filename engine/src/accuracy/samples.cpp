#include "accuracy/samples.hpp"

#include <algorithm>
#include <cmath>

namespace carom::accuracy {
namespace {

constexpr double kFew = 256;
constexpr double kRounding = 0x1p-44;  // of a time that is a multiple of a step

}  // namespace

Samples::Samples(double time, std::size_t most) : time_(time), spacing_(kLongestStep) {
  const double wanted = std::clamp(static_cast<double>(most), 1.0, kFew);
  while (time > 0 && time / spacing_ < wanted / 2) spacing_ /= 2;
  while (time / spacing_ > wanted) spacing_ *= 2;
  const double parts = time / spacing_ * (1 + kRounding);
  whole_ = static_cast<std::size_t>(parts);
  end_is_whole_ = whole_ > 0 && parts - std::floor(parts) <= 2 * kRounding * parts;
}

double Samples::time(std::size_t sample) const {
  if (sample >= count()) return time_;
  return static_cast<double>(sample) * spacing_;
}

double Samples::fine_time(std::uint64_t fine) const {
  const double time = static_cast<double>(fine) * (spacing_ / static_cast<double>(kParts));
  return std::min(time, time_);
}

std::uint64_t Samples::stride(std::optional<double> step) const {
  if (!step) return 1;
  const double parts = *step / spacing_ * static_cast<double>(kParts);
  return parts > 1 ? static_cast<std::uint64_t>(std::ceil(parts)) : 1;
}

bool Samples::compares(std::size_t sample, std::optional<double> step) const {
  if (sample == count()) return true;
  return sample <= whole_ && sample * kParts % stride(step) == 0;
}

}  // namespace carom::accuracy
