// What a crossing costs: microseconds of carom::Barrier, std::barrier and pthread_barrier, side by
// side.  One column of times is the median of repeats taken in turns, so that a disturbance of the
// machine meets all three.
//
//   carom_barrier [THREADS...]      default 2 4 16 64 256 1000

#include "carom/barrier.hpp"

#include <fmt/format.h>
#include <pthread.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <barrier>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;
using Microseconds = std::chrono::duration<double, std::micro>;

constexpr int kRepeats = 5;
constexpr double kUneven = 20;  // microseconds that one of the threads, in turn, computes longer

class PthreadBarrier {
 public:
  explicit PthreadBarrier(std::size_t parties) {
    pthread_barrier_init(&barrier_, nullptr, static_cast<unsigned>(parties));
  }
  ~PthreadBarrier() { pthread_barrier_destroy(&barrier_); }
  PthreadBarrier(const PthreadBarrier&) = delete;
  PthreadBarrier& operator=(const PthreadBarrier&) = delete;
  void arrive_and_wait() { pthread_barrier_wait(&barrier_); }

 private:
  pthread_barrier_t barrier_{};
};

class StdBarrier {
 public:
  explicit StdBarrier(std::size_t parties) : barrier_(static_cast<std::ptrdiff_t>(parties)) {}
  void arrive_and_wait() { barrier_.arrive_and_wait(); }

 private:
  std::barrier<> barrier_;
};

void compute_for(double microseconds) {
  const Clock::time_point until =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(Microseconds(microseconds));
  while (Clock::now() < until) continue;
}

template <class AnyBarrier>
double microseconds_per_crossing(std::size_t threads, std::size_t crossings, bool uneven) {
  constexpr std::size_t kWarmUp = 5;
  AnyBarrier barrier(threads);
  Clock::time_point begin;
  Clock::time_point end;
  const auto body = [&](std::size_t me) {
    for (std::size_t i = 0; i < kWarmUp; ++i) (void)barrier.arrive_and_wait();
    if (me == 0) begin = Clock::now();
    for (std::size_t i = 0; i < crossings; ++i) {
      if (uneven && i % threads == me) compute_for(kUneven);
      (void)barrier.arrive_and_wait();
    }
    if (me == 0) end = Clock::now();
  };
  std::vector<std::thread> all;
  for (std::size_t i = 0; i < threads; ++i) all.emplace_back(body, i);
  for (std::thread& thread : all) thread.join();
  return Microseconds(end - begin).count() / static_cast<double>(crossings);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Seconds that all cores of the machine, and this process among them, have computed.
struct Computed {
  double machine = 0;
  double self = 0;
  Clock::time_point at = Clock::now();

  Computed() {
    std::string name;
    std::array<double, 7> ticks{};  // user nice system idle iowait irq softirq, in 1/100 s
    std::ifstream stat("/proc/stat");
    stat >> name;
    for (double& tick : ticks) stat >> tick;
    machine = (ticks[0] + ticks[1] + ticks[2] + ticks[5] + ticks[6]) / 100;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    self = static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec) * 1e-6;
  }
};

void compare(std::size_t threads, bool uneven) {
  const double expected = 1.5 * static_cast<double>(threads) + (uneven ? kUneven : 0);
  const auto crossings = std::max<std::size_t>(30, static_cast<std::size_t>(40000 / expected));
  std::array<std::vector<double>, 3> times;
  for (int i = 0; i < kRepeats; ++i) {
    times[0].push_back(microseconds_per_crossing<carom::Barrier>(threads, crossings, uneven));
    times[1].push_back(microseconds_per_crossing<StdBarrier>(threads, crossings, uneven));
    times[2].push_back(microseconds_per_crossing<PthreadBarrier>(threads, crossings, uneven));
  }
  const double ours = median(times[0]);
  const double standard = median(times[1]);
  const double posix = median(times[2]);
  fmt::print("{:>7}  {:<7} {:>10.2f} {:>10.2f} {:>10.2f} {:>10.2f} {:>12.2f}\n", threads,
             uneven ? "uneven" : "empty", ours, standard, posix, ours / standard,
             ours / std::min(standard, posix));
}

}  // namespace

int main(int count, char** arguments) {
  std::vector<std::size_t> sizes;
  for (int i = 1; i < count; ++i) sizes.push_back(std::strtoul(arguments[i], nullptr, 10));
  if (sizes.empty()) sizes = {2, 4, 16, 64, 256, 1000};
  if (*std::min_element(sizes.begin(), sizes.end()) == 0) {
    fmt::print(stderr, "usage: {} [THREADS...]\n", arguments[0]);
    return 2;
  }
  fmt::print(
      "microseconds per crossing, medians of {}, on {} cores; uneven: one thread in turn "
      "computes {} us longer\n",
      kRepeats, std::thread::hardware_concurrency(), kUneven);
  fmt::print("threads  phases      carom        std    pthread  carom/std  carom/better\n");
  const Computed before;
  for (const bool uneven : {false, true}) {
    for (const std::size_t threads : sizes) compare(threads, uneven);
  }
  const Computed after;
  const double others = (after.machine - before.machine) - (after.self - before.self);
  const double seconds = std::chrono::duration<double>(after.at - before.at).count();
  fmt::print("other programs kept {:.2f} cores busy meanwhile\n", std::max(0.0, others / seconds));
  return 0;
}
