#pragma once

#include <cstddef>
#include <cstdint>

/// Reads bytes as a scene; aborts where the reader breaks a promise.  libFuzzer calls it with bytes
/// of its own, the test with those of the corpus.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
