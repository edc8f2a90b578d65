// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/pens.h"

#include "app/formats/dxf/aci.h"
#include "app/formats/dxf/losses.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace app::dxf {
namespace {

constexpr int weightOfLayer = -1, weightOfBlock = -2, weightUsual = -3;
constexpr double usualWidth = 0.25, thinnestWidth = 0.05; // millimetres

Colour colourOf(std::uint32_t rgb)
{
    return {std::uint8_t(rgb >> 16 & 0xff), std::uint8_t(rgb >> 8 & 0xff),
            std::uint8_t(rgb & 0xff)};
}

Colour ofIndex(int index)
{
    return colourOf(index > 0 && index < byLayer ? aciColours[std::size_t(index)] : 0);
}

Colour ofLayer(const LayerEntry& layer)
{
    return layer.trueColour ? colourOf(std::uint32_t(*layer.trueColour)) : ofIndex(layer.colour);
}

Colour colourOf(const Record& record, const LayerEntry& layer, const Colour& block)
{
    Colour colour;
    if (record.has(420)) {
        colour = colourOf(std::uint32_t(record.integer(420)));
    } else {
        const int index = std::abs(record.integer(62, byLayer));
        colour = index == byBlock ? block : index >= byLayer ? ofLayer(layer) : ofIndex(index);
    }
    constexpr int ownTransparency = 2;
    if (const int value = record.integer(440); value >> 24 == ownTransparency)
        colour.alpha = std::uint8_t(value & 0xff);
    return colour;
}

/// Dashes and gaps in turn, as SVG has them.
struct Pattern {
    std::vector<double> dashes{};
    double offset = 0;
};

Pattern patternOf(const LineType& type, double scale)
{
    Pattern pattern;
    double begins = 0; // with this gap
    for (const double dash : type.dashes) {
        const double length = std::abs(dash) * scale;
        const bool gap = dash < 0, after = pattern.dashes.size() % 2 == 1;
        if (pattern.dashes.empty() && gap)
            begins += length;
        else if (gap == after)
            pattern.dashes.push_back(length);
        else
            pattern.dashes.back() += length;
    }
    if (pattern.dashes.empty())
        return {};
    if (pattern.dashes.size() % 2 == 1)
        pattern.dashes.push_back(0);
    pattern.dashes.back() += begins;
    const double whole = std::accumulate(pattern.dashes.begin(), pattern.dashes.end(), 0.0);
    pattern.offset = begins > 0 ? whole - begins : 0;
    bool hasGaps = false;
    for (std::size_t i = 1; i < pattern.dashes.size(); i += 2)
        hasGaps |= pattern.dashes[i] > 0;
    return hasGaps ? pattern : Pattern{};
}

} // namespace

Pen Pens::penOf(const Record& record, const LayerEntry& layer, const Pen& block)
{
    Pen pen{colourOf(record, layer, block.colour), record.integer(370, weightOfLayer)};
    pen.weight = pen.weight == weightOfLayer   ? layer.weight
                 : pen.weight == weightOfBlock ? block.weight
                                               : pen.weight;
    const std::string name = inCapitals(record.text(6, "BYLAYER"));
    pen.lineType = name == "BYBLOCK"   ? block.lineType
                   : name == "BYLAYER" ? lineTypeOf(layer.lineType)
                                       : lineTypeOf(name);
    pen.lineTypeScale = record.number(48, 1);
    return pen;
}

const LineType* Pens::lineTypeOf(const std::string& name)
{
    if (name.empty() || name == "CONTINUOUS" || name == "BYLAYER" || name == "BYBLOCK")
        return nullptr;
    const auto found = tables_.lineTypes.find(name);
    if (found == tables_.lineTypes.end()) {
        report_.add(losses::missingLineType, name);
        return nullptr;
    }
    return &found->second;
}

Style Pens::styleOf(const Pen& pen, Paint paint, double width) const
{
    Style style;
    if (paint == Paint::Fill) {
        style.fill = pen.colour;
        style.fillRule = FillRule::EvenOdd;
        return style;
    }
    style.stroke = pen.colour;
    const double onPaper =
        pen.weight < 0 ? usualWidth : std::max(pen.weight / 100.0, thinnestWidth);
    style.width = width > 0 ? width : onPaper / header_.millimetres();
    if (!(width > 0)) { // pens are round; a width of the line itself ends straight
        style.cap = Cap::Round;
        style.join = Join::Round;
    }
    if (!pen.lineType || paint == Paint::Letters)
        return style;
    const double scale = std::abs(header_.lineTypeScale * pen.lineTypeScale);
    auto [dashes, offset] = patternOf(*pen.lineType, scale > 0 ? scale : 1);
    style.dashes = std::move(dashes);
    style.dashOffset = offset;
    return style;
}

} // namespace app::dxf
