// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/undrawn.h"

#include <algorithm>
#include <array>

namespace app::svg {
namespace {

constexpr auto undrawn = std::to_array<std::string_view>({
    // used by others
    "defs",
    "symbol",
    "marker",
    "clipPath",
    "mask",
    "pattern",
    "linearGradient",
    "radialGradient",
    "stop",
    "filter",
    "solidColor",
    "solidcolor",
    "hatch",
    "mesh*",
    // read apart
    "style",
    "title",
    "desc",
    "metadata",
    "html:*",
    // fonts, which are told where texts use them
    "font",
    "font-face*",
    "glyph",
    "missing-glyph",
    "hkern",
    "vkern",
    "color-profile",
    // parts of others, which draw nothing outside them
    "tspan",
    "textPath",
    "tref",
    "altGlyph*",
    "fe*",
    "flow*",
    // for programs that show or edit drawings
    "view",
    "cursor",
    "mpath",
    "discard",
    "handler",
    "listener",
    "other",
    "inkscape:*",
    "sodipodi:*",
    "clearcut:*",
    "xlink:*",
    "#text",
});

} // namespace

std::span<const std::string_view> undrawnElements() { return undrawn; }

bool isUndrawn(std::string_view element)
{
    return std::ranges::any_of(undrawn, [&](std::string_view each) {
        return each.ends_with('*') ? element.starts_with(each.substr(0, each.size() - 1))
                                   : element == each;
    });
}

} // namespace app::svg
