// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"

#include <vector>

namespace app {

/// The colours that are on offer in every drawing, in rows of `coloursInRow`: greys from black to
/// white, then twelve hues in four lightnesses. Pure red, green, blue, cyan, magenta and yellow, by
/// which laser cutters tell operations apart, are among them.
std::vector<Colour> colourChart();
constexpr int coloursInRow = 12;

} // namespace app
