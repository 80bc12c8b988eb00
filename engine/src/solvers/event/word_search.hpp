#pragma once

#include <cstdint>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace carom::event {

/// Words are looked for in so many at once, without a branch: where one is cannot be foreseen.
inline constexpr std::uint32_t kWords = 8;

/// Which of the eight words are this one, as bits from the lowest on.
[[gnu::always_inline]] inline std::uint32_t equal_words(const std::uint32_t* words,
                                                        std::uint32_t word) {
#if defined(__AVX2__)
  const __m256i eight = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(words));
  const __m256i equal = _mm256_cmpeq_epi32(eight, _mm256_set1_epi32(static_cast<int>(word)));
  return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(equal)));
#else
  std::uint32_t equal = 0;
  for (std::uint32_t n = 0; n < kWords; ++n) equal |= (words[n] == word ? 1U : 0U) << n;
  return equal;
#endif
}

/// Whether the word is among `count` words.
/// REQUIRES: what follows them up to a multiple of kWords
/// is there, and is another word.
[[gnu::always_inline]] inline bool is_among(const std::uint32_t* words, std::uint32_t count,
                                            std::uint32_t word) {
  std::uint32_t equal = 0;
  for (std::uint32_t n = 0; n < count; n += kWords) equal |= equal_words(words + n, word);
  return equal != 0;
}

}  // namespace carom::event
