#pragma once

#include <sched.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <climits>
#include <stdexcept>
#include <utility>

#include "carom/barrier.hpp"
#include "crew/barrier_state.hpp"
#include "crew/thread.hpp"

// What the members of BasicBarrier do.  barrier.cpp compiles them for the system's threads; a test,
// for threads that it can hold.
namespace carom {

namespace barrier {

// How long to wait awake.  A pause is some 40 ns, so the spin takes some 40 microseconds: what it
// takes to fall asleep and be woken on a virtual core, and what equal shares of a millisecond
// differ by.  Where another program has the core of the other party no more is lost. With more
// parties than cores a spin only keeps the core from those who are still to arrive.  A yield lets
// each of them on this core run once, and a few more bridge what the other cores are behind, which
// is cheaper than to sleep and be woken.  But each also gives every other program of the machine
// its turn, so that many threads have but few.
inline constexpr int kSpins = 1000;
inline constexpr int kYields = 4;
inline constexpr std::size_t kFewParties = 64;
inline constexpr int kYieldsOfFew = 8;
inline constexpr int kYieldsOfMany = 3;
// Where a yield brings the other party at once, the two share a core, and it was kept from it by
// the spin: then they spin less, down to this.
inline constexpr int kFewSpins = 16;
// A few parties must not give their turns to other programs, which keep a core for milliseconds: to
// sleep, and be put before them when woken, is better then.  Whether it still is, is tried again
// after so many waits.  Many parties have most of the turns anyway.
inline constexpr std::chrono::microseconds kLongYield{1000};
inline constexpr int kUnyielding = 4000;
// A thread that wakes up wakes the next few: the last to arrive does not pay for all, and a
// sleeper's data are fetched once, by the core on which it is about to run.
inline constexpr int kWakes = 4;

inline std::size_t cores() {
  static const std::size_t kCores = std::max<std::size_t>(usable_cores().size(), 1);
  return kCores;
}

inline void pause() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("isb" ::: "memory");
#endif
}

}  // namespace barrier

template <class System>
BasicBarrier<System>::BasicBarrier(std::size_t parties, std::function<void()> completion)
    : completion_(std::move(completion)),
      state_(parties * barrier::kOneParty),
      spins_(barrier::kSpins) {
  if (parties > kMostParties) throw std::length_error("too many parties for a barrier");
  gates_[0].word.store(static_cast<std::uint32_t>(-2));
  gates_[1].word.store(0);
}

template <class System>
BasicBarrier<System>::~BasicBarrier() = default;

template <class System>
bool BasicBarrier<System>::arrive_and_wait() {
  return arrive(true);
}

template <class System>
bool BasicBarrier<System>::arrive() {
  return arrive(false);
}

template <class System>
bool BasicBarrier<System>::arrive(bool await) {
  std::uint64_t state = state_.load(std::memory_order_relaxed);
  for (;;) {
    Gate& gate = gates_[barrier::phase_of(state) & 1U];
    if ((gate.word.load(std::memory_order_acquire) & barrier::kCancelled) != 0) return false;
    const bool last = barrier::arrived_of(state) + 1 == barrier::parties_of(state);
    const std::uint64_t next = last ? barrier::next_phase(state) : state + barrier::kOneArrived;
    if (!state_.compare_exchange_weak(state, next, std::memory_order_acq_rel,
                                      std::memory_order_relaxed)) {
      continue;
    }
    if (last) return end_phase(barrier::phase_of(state));
    return !await || wait(gate, state);
  }
}

template <class System>
int BasicBarrier<System>::yields_of(std::size_t parties) {
  if (parties > barrier::kFewParties) return barrier::kYieldsOfMany;
  const int unyielding = unyielding_.load(std::memory_order_relaxed);
  if (unyielding == 0) {
    return parties <= barrier::cores() ? barrier::kYields : barrier::kYieldsOfFew;
  }
  // Several may count down at once, and it be counted once.
  unyielding_.store(unyielding - 1, std::memory_order_relaxed);
  return 0;
}

template <class System>
bool BasicBarrier<System>::yield_was_long() {
  const auto before = std::chrono::steady_clock::now();
  sched_yield();
  if (std::chrono::steady_clock::now() - before <= barrier::kLongYield) return false;
  unyielding_.store(barrier::kUnyielding, std::memory_order_relaxed);
  return true;
}

template <class System>
void BasicBarrier<System>::learn_to_spin(int spins, bool in_vain) {
  const int better =
      in_vain ? std::max(spins / 2, barrier::kFewSpins) : std::min(2 * spins, barrier::kSpins);
  if (better != spins) spins_.store(better, std::memory_order_relaxed);
}

// `arrival`: the state before it arrived.
template <class System>
bool BasicBarrier<System>::wait(Gate& gate, std::uint64_t arrival) {
  const std::uint32_t phase = barrier::phase_of(arrival);
  const std::size_t parties = barrier::parties_of(arrival);
  const bool spins = parties <= barrier::cores();
  const int most_spins = spins ? spins_.load(std::memory_order_relaxed) : 0;
  int spins_left = most_spins;
  const int most_yields = yields_of(parties);
  int yields_left = most_yields;
  for (;;) {
    const std::uint32_t word = gate.word.load(std::memory_order_acquire);
    if (barrier::is_over(word, phase)) {
      if (spins) learn_to_spin(most_spins, yields_left < most_yields);
      return true;
    }
    if ((word & barrier::kCancelled) != 0) return false;
    if (spins_left > 0) {
      --spins_left;
      barrier::pause();
    } else if (yields_left > 0) {
      --yields_left;
      if (parties > barrier::kFewParties) {
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
  System::before_counting_a_sleeper();
  gate.sleepers.fetch_add(1, std::memory_order_seq_cst);
  std::uint32_t word = gate.word.load(std::memory_order_seq_cst);
  while ((word & barrier::kCancelled) == 0 && !barrier::is_over(word, phase)) {
    System::sleep_while_equal(gate.word, word);
    word = gate.word.load(std::memory_order_seq_cst);
  }
  // Threads that still sleep are counted, so each thread that leaves wakes at least one, and the
  // chain does not break.  Sleepers of a later phase cannot be here before this thread has arrived.
  if (gate.sleepers.fetch_sub(1, std::memory_order_seq_cst) > 1) {
    System::wake(gate.word, barrier::kWakes);
  }
  return barrier::is_over(word, phase);
}

template <class System>
bool BasicBarrier<System>::end_phase(std::uint32_t phase) {
  // Only where the phase before was ended by a party that left, and that was the only one, can it
  // still be at its completion.
  const Gate& before = gates_[(phase - 1) & 1U];
  for (;;) {
    const std::uint32_t word = before.word.load(std::memory_order_acquire);
    if ((word & barrier::kCancelled) != 0) return false;
    if (barrier::is_over(word, phase - 1)) break;
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
  gate.word.fetch_add(barrier::kNextOfGate, std::memory_order_seq_cst);
  System::between_word_and_sleepers();
  if (gate.sleepers.load(std::memory_order_seq_cst) > 0) {
    System::wake(gate.word, 2 * barrier::kWakes);
  }
  return true;
}

template <class System>
void BasicBarrier<System>::join() {
  std::uint64_t state = state_.load(std::memory_order_relaxed);
  do {
    if (barrier::parties_of(state) == kMostParties) {
      throw std::length_error("too many parties for a barrier");
    }
  } while (!state_.compare_exchange_weak(state, state + barrier::kOneParty,
                                         std::memory_order_acq_rel, std::memory_order_relaxed));
}

template <class System>
void BasicBarrier<System>::leave() {
  std::uint64_t state = state_.load(std::memory_order_relaxed);
  for (;;) {
    assert(barrier::parties_of(state) > barrier::arrived_of(state));
    const bool last = barrier::arrived_of(state) + 1 == barrier::parties_of(state);
    const std::uint64_t without = state - barrier::kOneParty;
    if (!state_.compare_exchange_weak(state, last ? barrier::next_phase(without) : without,
                                      std::memory_order_acq_rel, std::memory_order_relaxed)) {
      continue;
    }
    if (last) (void)end_phase(barrier::phase_of(state));
    return;
  }
}

template <class System>
void BasicBarrier<System>::cancel() {
  for (Gate& gate : gates_) {
    gate.word.fetch_or(barrier::kCancelled, std::memory_order_seq_cst);
    System::wake(gate.word, INT_MAX);
  }
}

template <class System>
std::size_t BasicBarrier<System>::parties() const {
  return barrier::parties_of(state_.load(std::memory_order_relaxed));
}

template <class System>
bool BasicBarrier<System>::cancelled() const {
  return (gates_[0].word.load(std::memory_order_acquire) & barrier::kCancelled) != 0;
}

}  // namespace carom
