// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/guide_text.h"

#include "app/base/number.h"
#include "app/formats/svg/attribute_text.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/scanner.h"

#include <array>
#include <cmath>

namespace app::svg {
namespace {

constexpr std::array<std::string_view, 2> names{"x", "y"}; // by axis

std::optional<Guide> guideOf(const Tree& tree, Node node)
{
    const int axis = tree.hasAttribute(node, names[0]) ? 0 : 1;
    const auto at = parseNumber(tree.attribute(node, names[std::size_t(axis)]));
    return at && std::abs(*at) <= largestCoordinate ? std::optional(Guide{axis, *at})
                                                    : std::nullopt;
}

void readGuide(const Tree& tree, Node node, Guides& guides, Report& report)
{
    report.turnTo(tree.line(node));
    const auto guide = guideOf(tree, node);
    if (!guide)
        report.add(losses::unreadableGuide);
    else if (guides.list.size() == Guides::most)
        report.add(losses::guides);
    else
        guides.list.push_back(*guide);
}

} // namespace

std::string textOf(const Guides& guides)
{
    std::string text;
    for (const Guide& guide : guides.list) {
        if (!std::isfinite(guide.at)) // it is nowhere, and SVG cannot represent it
            continue;
        text += "<clearcut:guide";
        appendAttribute(text, names[std::size_t(guide.axis)], guide.at);
        text += "/>";
    }
    return text;
}

Guides readGuides(const Tree& tree, Report& report)
{
    Guides guides;
    for (const Node metadata : Children(tree, 0)) {
        if (tree.name(metadata) != "metadata")
            continue;
        for (const Node node : Children(tree, metadata))
            if (tree.name(node) == "clearcut:guide")
                readGuide(tree, node, guides, report);
    }
    return guides;
}

} // namespace app::svg
