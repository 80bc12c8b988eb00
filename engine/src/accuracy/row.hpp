#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "accuracy/runner.hpp"
#include "carom/accuracy.hpp"

namespace carom::accuracy {

/// The row of a way on a crew, of which nothing has been measured.
AccuracyRow new_row(const Way& way, const AccuracyCrew& crew, std::size_t balls);

/// Does what a row is made by; where that fails, the row says why.
/// Errors: StopAsked.
void fill_row(AccuracyRow& row, const std::function<void()>& fill);

/// Why runs with a shorter step than this one are not tried: it failed, or took longer than the
/// time limit; empty: they are.
std::string why_last(const AccuracyRow& row, const std::string& name, double limit);

}  // namespace carom::accuracy
