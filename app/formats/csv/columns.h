// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace app::csv {

/// The columns of a row, in the order of files without a header.
enum Column : std::size_t { X1, Y1, X2, Y2, LayerName, StrokeColour, Width, Source };
constexpr std::array<std::string_view, 8> columnNames{"x1",    "y1",     "x2",    "y2",
                                                      "layer", "colour", "width", "source"};
constexpr std::size_t coordinateColumns = 4; ///< the first columns, which are required

} // namespace app::csv
