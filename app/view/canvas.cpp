#include "view/canvas.hpp"

namespace carom {

void Canvas::write(int column, int row, std::string_view text, Ink ink) {
  for (const char character : text) {
    // A letter beyond ASCII is several bytes in UTF-8: one '?' for the first, nothing for the rest.
    const auto byte = static_cast<unsigned char>(character);
    if ((byte & 0xC0U) == 0x80U) continue;
    put(column++, row, byte >= 0x20 && byte < 0x7F ? byte : U'?', ink);
  }
}

void Canvas::put(int column, int row, char32_t character, Ink ink, float heat) {
  if (holds(column, row)) at(column, row) = {character, ink, heat, Ink::none, 0};
}

}  // namespace carom
