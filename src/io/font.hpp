/// \file
/// The one font: 5 by 7 pixels, and two more below for what hangs down.
#pragma once

#include <array>
#include <cstdint>

namespace scrubjay {

inline constexpr int kGlyphWidth = 5;
inline constexpr int kGlyphHeight = 9;

/// Whether the font's pixel in this column and row (from the top) is ink. What the font lacks has none.
bool glyph_ink(char character, int column, int row);

}  // namespace scrubjay
