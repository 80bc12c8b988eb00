#include "carom/barrier.hpp"

#include <sched.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "crew/sleep.hpp"
#include "crew/thread.hpp"

namespace carom {
namespace {

// How long to wait awake.  A pause is some 40 ns, so the spin takes some 40 microseconds: what it
// takes to fall asleep and be woken on a virtual core, and what equal shares of a millisecond
// differ by.  Where another program has the core of the other party no more is lost. With more
// parties than cores a spin only keeps the core from those who are still to arrive.  A yield lets
// each of them on this core run once, and a few more bridge what the other cores are behind, which
// is cheaper than to sleep and be woken.  But each also gives every other program of the machine
// its turn, so that many threads have but few.
constexpr int kSpins = 1000;
constexpr int kYields = 4;
constexpr std::size_t kFewParties = 64;
constexpr int kYieldsOfFew = 8;
constexpr int kYieldsOfMany = 3;
// Where a yield brings the other party at once, the two share a core, and it was kept from it by
// the spin: then they spin less, down to this.
constexpr int kFewSpins = 16;
// A few parties must not give their turns to other programs, which keep a core for milliseconds: to
// sleep, and be put before them when woken, is better then.  Whether it still is, is tried again
// after so many waits.  Many parties have most of the turns anyway.
constexpr std::chrono::microseconds kLongYield{1000};
constexpr int kUnyielding = 4000;
// A thread that wakes up wakes the next few: the last to arrive does not pay for all, and a
// sleeper's data are fetched once, by the core on which it is about to run.
constexpr int kWakes = 4;

constexpr std::uint32_t kCancelled = 1;
constexpr std::uint32_t kNextOfGate = 4;  // two phases on, in the upper 31 bits

constexpr unsigned kCountBits = 20;
constexpr std::uint64_t kCount = Barrier::kMostParties;
constexpr std::uint64_t kOneArrived = 1;
constexpr std::uint64_t kOneParty = std::uint64_t{1} << kCountBits;
constexpr std::uint64_t kOnePhase = std::uint64_t{1} << (2 * kCountBits);
constexpr std::uint32_t kPhase = (1U << (64 - 2 * kCountBits)) - 1;

std::uint64_t arrived_of(std::uint64_t state) {
  return state & kCount;
}
std::uint64_t parties_of(std::uint64_t state) {
  return (state >> kCountBits) & kCount;
}
std::uint32_t phase_of(std::uint64_t state) {
  return static_cast<std::uint32_t>(state >> (2 * kCountBits));
}
/// The state in which the next phase begins.
std::uint64_t next_phase(std::uint64_t state) {
  return (state & ~kCount) + kOnePhase;
}

/// Has this gate let out the parties of `phase`?  No party can fall two phases behind, so that the
/// numbers may wrap around.
bool is_over(std::uint32_t word, std::uint32_t phase) {
  return ((word >> 1) & kPhase) == ((phase + 1) & kPhase);
}

std::size_t cores() {
  static const std::size_t kCores = std::max<std::size_t>(usable_cores().size(), 1);
  return kCores;
}

void pause() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("isb" ::: "memory");
#endif
}

}  // namespace

Barrier::Barrier(std::size_t parties, std::function<void()> completion)
    : completion_(std::move(completion)), state_(parties * kOneParty), spins_(kSpins) {
  if (parties > kMostParties) throw std::length_error("too many parties for a barrier");
  gates_[0].word.store(static_cast<std::uint32_t>(-2));
  gates_[1].word.store(0);
}

Barrier::~Barrier() = default;

bool Barrier::arrive_and_wait() {
  std::uint64_t state = state_.load(std::memory_order_relaxed);
  for (;;) {
    Gate& gate = gates_[phase_of(state) & 1U];
    if ((gate.word.load(std::memory_order_acquire) & kCancelled) != 0) return false;
    const bool last = arrived_of(state) + 1 == parties_of(state);
    const std::uint64_t next = last ? next_phase(state) : state + kOneArrived;
    if (!state_.compare_exchange_weak(state, next, std::memory_order_acq_rel,
                                      std::memory_order_relaxed)) {
      continue;
    }
    if (!last) return wait(gate, state);
    return end_phase(phase_of(state));
  }
}

int Barrier::yields_of(std::size_t parties) {
  if (parties > kFewParties) return kYieldsOfMany;
  const int unyielding = unyielding_.load(std::memory_order_relaxed);
  if (unyielding == 0) return parties <= cores() ? kYields : kYieldsOfFew;
  // Several may count down at once, and it be counted once.
  unyielding_.store(unyielding - 1, std::memory_order_relaxed);
  return 0;
}

bool Barrier::yield_was_long() {
  const auto before = std::chrono::steady_clock::now();
  sched_yield();
  if (std::chrono::steady_clock::now() - before <= kLongYield) return false;
  unyielding_.store(kUnyielding, std::memory_order_relaxed);
  return true;
}

void Barrier::learn_to_spin(int spins, bool in_vain) {
  const int better = in_vain ? std::max(spins / 2, kFewSpins) : std::min(2 * spins, kSpins);
  if (better != spins) spins_.store(better, std::memory_order_relaxed);
}

// `arrival`: the state before it arrived.
bool Barrier::wait(Gate& gate, std::uint64_t arrival) {
  const std::uint32_t phase = phase_of(arrival);
  const std::size_t parties = parties_of(arrival);
  const bool spins = parties <= cores();
  const int most_spins = spins ? spins_.load(std::memory_order_relaxed) : 0;
  int spins_left = most_spins;
  const int most_yields = yields_of(parties);
  int yields_left = most_yields;
  for (;;) {
    const std::uint32_t word = gate.word.load(std::memory_order_acquire);
    if (is_over(word, phase)) {
      if (spins) learn_to_spin(most_spins, yields_left < most_yields);
      return true;
    }
    if ((word & kCancelled) != 0) return false;
    if (spins_left > 0) {
      --spins_left;
      pause();
    } else if (yields_left > 0) {
      --yields_left;
      if (parties > kFewParties) {
        sched_yield();
      } else if (yield_was_long()) {
        yields_left = 0;
      }
    } else {
      break;
    }
  }
  if (spins) learn_to_spin(most_spins, false);
  // Counted first, then looked at again (by the kernel, as it falls asleep), while end_phase()
  // moves the word first and looks at the count after: in the single order of these four, one sees
  // the other, and no wake-up is lost.
  gate.sleepers.fetch_add(1, std::memory_order_seq_cst);
  std::uint32_t word = gate.word.load(std::memory_order_seq_cst);
  while ((word & kCancelled) == 0 && !is_over(word, phase)) {
    sleep_while_equal(gate.word, word);
    word = gate.word.load(std::memory_order_seq_cst);
  }
  // Whoever still sleeps is in the count, so each that leaves wakes at least one of them, and the
  // chain does not break.  Sleepers of a later phase cannot be here before this thread has arrived.
  if (gate.sleepers.fetch_sub(1, std::memory_order_seq_cst) > 1) wake(gate.word, kWakes);
  return is_over(word, phase);
}

bool Barrier::end_phase(std::uint32_t phase) {
  // Only where the phase before was ended by a party that left, and that was the only one, can it
  // still be at its completion.
  const Gate& before = gates_[(phase - 1) & 1U];
  for (;;) {
    const std::uint32_t word = before.word.load(std::memory_order_acquire);
    if ((word & kCancelled) != 0) return false;
    if (is_over(word, phase - 1)) break;
    sched_yield();
  }
  if (completion_) {
    try {
      completion_();
    } catch (...) {
      cancel();
      throw;
    }
  }
  Gate& gate = gates_[phase & 1U];
  gate.word.fetch_add(kNextOfGate, std::memory_order_seq_cst);
  if (gate.sleepers.load(std::memory_order_seq_cst) > 0) wake(gate.word, 2 * kWakes);
  return true;
}

void Barrier::join() {
  std::uint64_t state = state_.load(std::memory_order_relaxed);
  do {
    if (parties_of(state) == kMostParties) {
      throw std::length_error("too many parties for a barrier");
    }
  } while (!state_.compare_exchange_weak(state, state + kOneParty, std::memory_order_acq_rel,
                                         std::memory_order_relaxed));
}

void Barrier::leave() {
  std::uint64_t state = state_.load(std::memory_order_relaxed);
  for (;;) {
    assert(parties_of(state) > arrived_of(state));
    const bool last = arrived_of(state) + 1 == parties_of(state);
    const std::uint64_t without = state - kOneParty;
    if (!state_.compare_exchange_weak(state, last ? next_phase(without) : without,
                                      std::memory_order_acq_rel, std::memory_order_relaxed)) {
      continue;
    }
    if (last) (void)end_phase(phase_of(state));
    return;
  }
}

void Barrier::cancel() {
  for (Gate& gate : gates_) {
    gate.word.fetch_or(kCancelled, std::memory_order_seq_cst);
    wake_all(gate.word);
  }
}

std::size_t Barrier::parties() const {
  return parties_of(state_.load(std::memory_order_relaxed));
}

bool Barrier::cancelled() const {
  return (gates_[0].word.load(std::memory_order_acquire) & kCancelled) != 0;
}

}  // namespace carom
