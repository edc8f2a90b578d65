// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/columns.h"

#include "app/base/csv_text.h"
#include "app/base/number.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace app::csv {
namespace {

using Names = std::array<std::string_view, coordinateColumns>;

// The first that a header holds whole is meant.
constexpr std::array coordinateNames{
    Names{"x1", "y1", "x2", "y2"},
    Names{"x0", "y0", "x1", "y1"},
    Names{"xa", "ya", "xb", "yb"},
    Names{"ax", "ay", "bx", "by"},
    Names{"startx", "starty", "endx", "endy"},
    Names{"xstart", "ystart", "xend", "yend"},
    Names{"fromx", "fromy", "tox", "toy"},
    Names{"xfrom", "yfrom", "xto", "yto"},
    Names{"p1x", "p1y", "p2x", "p2y"},
    Names{"x", "y", "x2", "y2"},
};

struct OtherName {
    std::string_view name;
    Column column;
};
constexpr std::array otherNames{
    OtherName{"layer", LayerName},    OtherName{"colour", StrokeColour},
    OtherName{"color", StrokeColour}, OtherName{"width", Width},
    OtherName{"strokewidth", Width},  OtherName{"linewidth", Width},
    OtherName{"source", Source},
};

// In small letters, without what separates words: "startx" for "Start_X".
std::string plain(std::string_view field)
{
    std::string name;
    for (const char c : field)
        if (std::string_view(" \t_-.").find(c) == std::string_view::npos)
            name += c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    return name;
}

// The names of the coordinates that a header holds; null: it does not name all.
const Names* coordinatesOf(Fields header)
{
    std::vector<std::string> all;
    std::ranges::transform(header, std::back_inserter(all), plain);
    const auto holds = [&](std::string_view name) { return std::ranges::count(all, name) > 0; };
    const auto found = std::ranges::find_if(
        coordinateNames, [&](const Names& names) { return std::ranges::all_of(names, holds); });
    return found == coordinateNames.end() ? nullptr : &*found;
}

} // namespace

bool namesCoordinates(Fields header) { return coordinatesOf(header) != nullptr; }

bool namesGeometry(std::string_view field)
{
    constexpr std::array<std::string_view, 5> names{"wkt", "geometry", "geom", "wktgeom",
                                                    "thegeom"};
    return std::ranges::find(names, plain(field)) != names.end();
}

Header::Header(Fields fields) : coordinates_(coordinatesOf(fields)) {}

std::optional<Column> Header::columnOf(std::string_view field) const
{
    const std::string name = plain(field);
    if (coordinates_)
        if (const auto found = std::ranges::find(*coordinates_, name); found != coordinates_->end())
            return Column(found - coordinates_->begin());
    const auto other = std::ranges::find(otherNames, name, &OtherName::name);
    return other == otherNames.end() ? std::nullopt : std::optional(other->column);
}

} // namespace app::csv

namespace app::csv {
namespace {

std::string colourText(const Colour& colour)
{
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text = "#";
    const auto append = [&](std::uint8_t part) {
        text += digits[part >> 4];
        text += digits[part & 15];
    };
    append(colour.red);
    append(colour.green);
    append(colour.blue);
    if (colour.alpha != 255)
        append(colour.alpha);
    return text;
}

} // namespace

std::string headerText(bool withSource)
{
    std::string text;
    for (std::size_t i = 0; i < columnNames.size() - (withSource ? 0 : 1); ++i)
        (text += i > 0 ? "," : "") += columnNames[i];
    return text + '\n';
}

std::string lookColumns(const QString& layer, const Colour& strokeColour, double width)
{
    std::string text = ",";
    appendField(text, layer.toStdString());
    (text += ',') += colourText(strokeColour);
    text += ',';
    appendNumber(text, width);
    return text;
}

QString usualLayer() { return QStringLiteral("Drawing"); }

} // namespace app::csv
