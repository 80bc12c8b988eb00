// What a frame of a crew costs beyond its work: eight steps of two empty phases, that is eighteen
// crossings (do_frame, sixteen, frame_done), in milliseconds, by number of workers.
//
//   carom_crew [WORKERS...]      default 1 2 15 100 1000

#include "carom/crew.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <thread>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

constexpr int kSteps = 8;
constexpr int kFrames = 30;

void measure(std::size_t workers) {
  int left = 0;
  carom::Crew crew(workers,
                   {{"wall_computation", [](carom::Share) {}, [] { return std::size_t{1}; }},
                    {"pair_computation", [](carom::Share) {},
                     [&] { return --left > 0 ? std::size_t{0} : carom::Phase::kFrameDone; }}});
  std::vector<double> times;
  for (int frame = 0; frame < kFrames; ++frame) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));  // as between frames: all asleep
    left = kSteps;
    const Clock::time_point begin = Clock::now();
    crew.do_frame();
    times.push_back(Milliseconds(Clock::now() - begin).count());
  }
  std::sort(times.begin(), times.end());
  const double median = times[times.size() / 2];
  fmt::print("{:>7} {:>10.3f} {:>10.3f} {:>10.3f} {:>14.2f}\n", workers, times.front(), median,
             times.back(), 1000 * median / (2 * kSteps + 2));
}

}  // namespace

int main(int count, char** arguments) {
  std::vector<std::size_t> sizes;
  for (int i = 1; i < count; ++i) sizes.push_back(std::strtoul(arguments[i], nullptr, 10));
  if (sizes.empty()) sizes = {1, 2, 15, 100, 1000};
  fmt::print("milliseconds per frame of {} crossings, {} frames\n", 2 * kSteps + 2, kFrames);
  fmt::print("workers    fastest     median    slowest  us / crossing\n");
  for (const std::size_t workers : sizes) measure(workers);
  return 0;
}
