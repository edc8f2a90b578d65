// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"
#include "clipping/pseudo_code.h"

#include <array>

// Labels of pseudo-code for the plane (pseudo_code.h), chosen by an edge or an axis. In three
// dimensions, Near, Far and the third axis have no line there and so an empty label.

namespace clipping {

/// The labels for Left, Right, Bottom and Top.
using LabelsOfEdges = std::array<std::string_view, 4>;

constexpr std::string_view labelOf(Edge edge, const LabelsOfEdges& labels)
{
    return Edge::Left <= edge && edge <= Edge::Top ? labels[static_cast<std::size_t>(edge) - 1]
                                                   : std::string_view();
}

/// `x` or `y` by the axis.
constexpr std::string_view labelOn(glm::length_t axis, std::string_view x, std::string_view y)
{
    return axis == 0 ? x : axis == 1 ? y : std::string_view();
}

/// `x` or `y` by the axis on which an edge has its coordinate; `x` without an edge.
constexpr std::string_view labelAt(Edge edge, std::string_view x, std::string_view y)
{
    return edge == Edge::NoEdge ? x : labelOn(axisOf(edge), x, y);
}

/// Whether no label stands at two lines, nor twice at one.
constexpr bool labelsAreUnique(std::string_view code)
{
    // With a sanitizer, the address of a text that other files may replace (a member of a class) is
    // no constant, so the text is copied.
    const std::vector<char> copy(code.begin(), code.end());
    std::vector<std::string_view> all;
    for (const CodeLine& line : linesOf({copy.data(), copy.size()}))
        for (std::string_view rest = line.labels; !rest.empty();) {
            const std::string_view label = rest.substr(0, rest.find(' '));
            if (std::find(all.begin(), all.end(), label) != all.end())
                return false;
            all.push_back(label);
            rest.remove_prefix(std::min(label.size() + 1, rest.size()));
        }
    return true;
}

} // namespace clipping
