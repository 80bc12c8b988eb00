#include "carom/barrier.hpp"

#include <utility>

namespace carom {

Barrier::Barrier(std::size_t parties, std::function<void()> completion)
    : completion_(std::move(completion)), parties_(parties) {}

Barrier::~Barrier() = default;

void Barrier::end_phase() {
  if (completion_) completion_();
  arrived_.store(0, std::memory_order_relaxed);
  phase_.fetch_add(1, std::memory_order_release);
  phase_.notify_all();
}

bool Barrier::arrive_and_wait() {
  const std::uint32_t phase = phase_.load(std::memory_order_acquire);
  if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == parties_.load()) {
    end_phase();
  } else {
    while (phase_.load(std::memory_order_acquire) == phase && !cancelled_.load()) {
      phase_.wait(phase, std::memory_order_acquire);
    }
  }
  return !cancelled_.load();
}

void Barrier::join() {
  parties_.fetch_add(1);
}

void Barrier::leave() {
  const std::size_t left = parties_.fetch_sub(1) - 1;
  if (left > 0 && arrived_.load() == left) end_phase();
}

void Barrier::cancel() {
  cancelled_.store(true);
  phase_.fetch_add(1, std::memory_order_release);
  phase_.notify_all();
}

std::size_t Barrier::parties() const {
  return parties_.load();
}
bool Barrier::cancelled() const {
  return cancelled_.load();
}

}  // namespace carom
