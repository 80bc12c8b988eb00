#pragma once

#include "view/canvas.hpp"
#include "view/glyphs.hpp"
#include "view/instruments.hpp"

namespace carom {

/// Rows of the panel in full, beside each other and on top of each other.
inline constexpr int kRowsOfInstrumentsBeside = 11;
inline constexpr int kRowsOfInstrumentsStacked = 28;

/// Speeds, averages and energies, beside each other where there is room for all three, else on top
/// of each other as far as there is.
Canvas instruments_panel(const InstrumentReadings& readings, int columns, int rows, Glyphs glyphs);

}  // namespace carom
