// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"

#include <QString>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace app::csv {

/// The columns of a row, in the order of files without a header.
enum Column : std::size_t { X1, Y1, X2, Y2, LayerName, StrokeColour, Width, Source };
constexpr std::array<std::string_view, 8> columnNames{"x1",    "y1",     "x2",    "y2",
                                                      "layer", "colour", "width", "source"};
constexpr std::size_t coordinateColumns = 4; ///< the first columns, which are required

using Fields = std::span<const std::string_view>;

/// Whether a header names four columns that are coordinates of lines, by usual names.
bool namesCoordinates(Fields header);

/// Whether a name is that of a column of geometries, as WKT.
bool namesGeometry(std::string_view field);

/// The columns that the names in the first record of a table stand for.
class Header {
public:
    explicit Header(Fields fields);
    /// Empty: no column that is read.
    std::optional<Column> columnOf(std::string_view field) const;

private:
    const std::array<std::string_view, coordinateColumns>* coordinates_;
};

} // namespace app::csv

namespace app::csv {

/// The first line of a table, with its line break; with the column `source`, or without it.
std::string headerText(bool withSource);

/// The columns of a row between its coordinates and its source: ",layer,colour,width".
std::string lookColumns(const QString& layer, const Colour& strokeColour, double width);

/// The name of the layer of rows without one.
QString usualLayer();

} // namespace app::csv
