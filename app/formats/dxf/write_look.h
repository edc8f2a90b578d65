// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/formats/dxf/write_plane.h"
#include "app/formats/dxf/write_tags.h"

#include <map>
#include <optional>
#include <span>

namespace app::dxf::writing {

/// The number in the AutoCAD Color Index that is nearest to a colour. Black is the one that is
/// black on paper and white on a dark screen.
int nearestAci(const Colour& colour);

constexpr double widestLine = 2.11; ///< millimetres
/// The nearest line weight that DXF has, in hundredths of a millimetre.
int lineWeightOf(double millimetres);

/// A pattern of dashes and gaps in the unit of the file.
struct LineType {
    std::string name;
    std::vector<double> pattern;
};

/// The line types of a drawing.
class LineTypes {
public:
    /// `scale`: the size of a user unit in the unit of the file.
    LineTypes(const Document& document, double scale);

    std::span<const LineType> all() const { return all_; } ///< but for continuous lines
    /// Empty: a continuous line.
    std::string_view nameOf(const Style& style) const;

private:
    std::vector<double> patternOf(const Style& style) const;
    std::string freeName(const std::vector<double>& pattern) const;

    double scale_;
    std::vector<LineType> all_;
    std::map<std::vector<double>, std::size_t> found_;
};

/// The look of a line, for layers and entities.
struct LineLook {
    Colour colour{};
    int weight = 25; ///< lineWeightOf
    friend bool operator==(const LineLook&, const LineLook&) = default;
};
/// The look of an object's lines; empty if it is invisible.
std::optional<LineLook> lookOf(const ObjectView& object, double millimetresPerUnit);

/// Whether a version has true colours, line weights and hidden entities.
enum class Looks : std::uint8_t { Full, IndexOnly };
/// Of a layer that is off, the number of the colour is negative.
void writeLook(TagWriter& tags, const LineLook& look, Looks looks, bool on = true);

} // namespace app::dxf::writing
