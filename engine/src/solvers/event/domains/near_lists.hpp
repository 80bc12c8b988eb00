#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

#include "solvers/event/huge_pages.hpp"

namespace carom::event {

/// The number of a ball within a domain.
using Slot = std::uint16_t;
inline constexpr Slot kNoSlot = 0xffff;

/// For each set of eight bits the numbers of those that are set, a byte each, from the lowest on.
inline constexpr std::array<std::uint64_t, 256> kBitsOf = [] {
  std::array<std::uint64_t, 256> all{};
  for (std::uint32_t mask = 0; mask < all.size(); ++mask) {
    std::uint32_t at = 0;
    for (std::uint32_t rest = mask; rest != 0; rest &= rest - 1) {
      all[mask] |= static_cast<std::uint64_t>(std::countr_zero(rest)) << (8 * at++);
    }
  }
  return all;
}();

/// For each ball of a domain the balls near to it: half a cache line, and more only where they are
/// many.
///
/// Holds: behind the last of a list, up to the next multiple of eight, there are slots of balls or
/// numbers up to kShort + 1, so that eight can be read at a time.
class NearLists {
 public:
  static constexpr std::uint32_t kShort = 15;
  static constexpr std::size_t kBytesOfBall = 32;  ///< unless its list is long

  /// The balls near to one, as a search finds them.
  class Gathered {
   public:
    /// REQUIRES: what was in it has been taken by `set`.
    void clear() { size_ = 0; }
    /// Ball `first` + b for each bit b of the mask, of eight.
    [[gnu::always_inline]] void add(std::uint32_t first, std::uint32_t mask) {
      if (size_ > kMost) size_ = spill();
#if defined(__AVX2__)
      const auto from = static_cast<short>(first);
      const __m128i bits = _mm_cvtsi64_si128(static_cast<long long>(kBitsOf[mask]));
      _mm_storeu_si128(reinterpret_cast<__m128i*>(items_.data() + size_),
                       _mm_add_epi16(_mm_cvtepu8_epi16(bits), _mm_set1_epi16(from)));
      size_ += static_cast<std::uint32_t>(std::popcount(mask));
#else
      for (; mask != 0; mask &= mask - 1) {
        items_[size_++] =
            static_cast<Slot>(first + static_cast<std::uint32_t>(std::countr_zero(mask)));
      }
#endif
    }
    /// Ball slots[b] for each bit b of the mask, of eight; eight can be read.
    [[gnu::always_inline]] void add(const Slot* slots, std::uint32_t mask) {
      if (size_ > kMost) size_ = spill();
#if defined(__AVX2__)
      const __m128i bits = _mm_cvtsi64_si128(static_cast<long long>(kBitsOf[mask]));
      const __m128i bytes = _mm_add_epi16(
          _mm_mullo_epi16(_mm_cvtepu8_epi16(bits), _mm_set1_epi16(0x0202)), _mm_set1_epi16(0x0100));
      const __m128i eight = _mm_loadu_si128(reinterpret_cast<const __m128i*>(slots));
      _mm_storeu_si128(reinterpret_cast<__m128i*>(items_.data() + size_),
                       _mm_shuffle_epi8(eight, bytes));
      size_ += static_cast<std::uint32_t>(std::popcount(mask));
#else
      for (; mask != 0; mask &= mask - 1) items_[size_++] = slots[std::countr_zero(mask)];
#endif
    }

   private:
    friend class NearLists;
    static constexpr std::uint32_t kMost = 40;
    // What is too many goes on in `more_`.
    [[gnu::noinline]] std::uint32_t spill() {
      more_.insert(more_.end(), items_.begin() + kShort, items_.begin() + size_);
      return kShort;
    }
    std::array<Slot, kMost + 8> items_{};  ///< behind the last there are slots, too
    std::uint32_t size_ = 0;
    std::vector<Slot> more_;
  };

  /// REQUIRES: the list of each ball is set before anything else is done with it, unless nothing
  /// has been put in before.
  void reset(std::size_t balls) {
    lists_.resize(balls + 1);  // the last may be read a little beyond its end
    lists_.back() = {};
    long_.clear();
    free_.clear();
  }

  [[nodiscard]] std::uint32_t size(Slot ball) const {
    const List& list = lists_[ball];
    return list.size <= kShort ? list.size : size_of_long(list);
  }
  [[nodiscard]] const Slot* items(Slot ball) const {
    const List& list = lists_[ball];
    return list.size <= kShort ? list.item : long_[list.item[0]].data();
  }

  /// Makes it the list of a ball; `near` is then to be cleared.
  void set(Slot ball, Gathered& near) {
    List& list = lists_[ball];
    std::memcpy(list.item, near.items_.data(), sizeof list.item);
    list.size = static_cast<Slot>(std::min(near.size_, kShort));
    if (near.size_ > kShort) near.spill();
    if (near.more_.empty()) return;
    for (const Slot other : near.more_) add_to_long(list, other);
    near.more_.clear();
  }

  void add(Slot ball, Slot other) {
    List& list = lists_[ball];
    if (list.size < kShort) {
      list.item[list.size++] = other;
    } else {
      add_to_long(list, other);
    }
  }

  /// Takes `other` out of the list, where it is in it; another may take its place.
  void remove(Slot ball, Slot other) {
    List& list = lists_[ball];
    if (list.size > kShort) {
      remove_from_long(list, other);
      return;
    }
    const std::uint32_t at = find(list, other);
    if (at < list.size) list.item[at] = list.item[--list.size];
  }

  void clear(Slot ball) {
    List& list = lists_[ball];
    if (list.size > kShort) free_.push_back(list.item[0]);
    list.size = 0;
  }

  [[nodiscard]] std::size_t bytes() const {
    return lists_.capacity() * sizeof(List);
  }

 private:
  static constexpr Slot kLong = kShort + 1;
  static constexpr std::uint32_t kAhead = 8;

  struct alignas(kBytesOfBall) List {
    Slot item[kShort]{};
    Slot size = 0;  ///< kLong: item[0] is the number of a long list
  };

  // Where the ball is in a short list; no less than its size where it is not in it.
  [[nodiscard]] static std::uint32_t find(const List& list, Slot ball) {
#if defined(__AVX2__)
    const __m256i all = _mm256_load_si256(reinterpret_cast<const __m256i*>(&list));
    const __m256i same = _mm256_cmpeq_epi16(all, _mm256_set1_epi16(static_cast<short>(ball)));
    return static_cast<std::uint32_t>(
               std::countr_zero(static_cast<std::uint32_t>(_mm256_movemask_epi8(same)))) /
           2;
#else
    return static_cast<std::uint32_t>(std::find(list.item, list.item + list.size, ball) -
                                      list.item);
#endif
  }

  [[nodiscard]] std::uint32_t size_of_long(const List& list) const {
    return static_cast<std::uint32_t>(long_[list.item[0]].size()) - kAhead;
  }

  // A long list has kAhead slots of balls behind its last.
  [[gnu::noinline]] void add_to_long(List& list, Slot other) {
    if (list.size == kShort) {
      if (free_.empty()) {
        free_.push_back(static_cast<Slot>(long_.size()));
        long_.emplace_back();
      }
      std::vector<Slot>& items = long_[free_.back()];
      items.assign(list.item, list.item + kShort);
      items.insert(items.end(), kAhead, Slot{0});
      list.item[0] = free_.back();
      list.size = kLong;
      free_.pop_back();
    }
    std::vector<Slot>& items = long_[list.item[0]];
    items[items.size() - kAhead] = other;
    items.push_back(0);
  }

  [[gnu::noinline]] void remove_from_long(List& list, Slot other) {
    const Slot number = list.item[0];
    std::vector<Slot>& items = long_[number];
    const auto end = items.end() - kAhead;
    const auto at = std::find(items.begin(), end, other);
    if (at == end) return;
    *at = *(end - 1);
    items.pop_back();
    if (items.size() - kAhead > kShort) return;
    list.size = kShort;
    std::copy_n(items.begin(), kShort, list.item);
    free_.push_back(number);
  }

  HugeVector<List> lists_;
  std::vector<std::vector<Slot>> long_;
  std::vector<Slot> free_;  ///< long lists that are not used
};

}  // namespace carom::event
