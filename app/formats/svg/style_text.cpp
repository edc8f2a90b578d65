// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/style_text.h"

#include "app/base/number.h"
#include "app/formats/svg/attribute_text.h"

#include <algorithm>

namespace app::svg {

void appendPaint(std::string& text, std::string_view name, const std::optional<Colour>& colour)
{
    if (!colour) {
        appendAttribute(text, name, "none");
        return;
    }
    constexpr std::string_view digits = "0123456789abcdef";
    std::string hex = "#";
    for (const std::uint8_t part : {colour->red, colour->green, colour->blue}) {
        hex += digits[part >> 4];
        hex += digits[part & 15];
    }
    appendAttribute(text, name, hex);
    if (colour->alpha != 255) {
        std::string alpha;
        appendNumber(alpha, colour->alpha / 255.0, 3, 0, 1); // precise enough to give the same byte
        appendAttribute(text, std::string(name) + "-opacity", alpha);
    }
}

std::string styleText(const Style& style)
{
    const Style usual{.fill = Colour{}};
    std::string text;
    if (style.fill != usual.fill)
        appendPaint(text, "fill", style.fill);
    if (style.stroke)
        appendPaint(text, "stroke", style.stroke);
    if (style.width != usual.width)
        appendAttribute(text, "stroke-width", style.width);
    if (style.cap != usual.cap)
        appendAttribute(text, "stroke-linecap", style.cap == Cap::Round ? "round" : "square");
    if (style.join != usual.join)
        appendAttribute(text, "stroke-linejoin", style.join == Join::Round ? "round" : "bevel");
    if (style.miterLimit != usual.miterLimit)
        appendAttribute(text, "stroke-miterlimit", style.miterLimit);
    if (std::ranges::any_of(style.dashes, [](double dash) { return dash > 0; }))
        appendAttribute(text, "stroke-dasharray", style.dashes);
    if (style.dashOffset != usual.dashOffset)
        appendAttribute(text, "stroke-dashoffset", style.dashOffset);
    if (style.fillRule != usual.fillRule)
        appendAttribute(text, "fill-rule", "evenodd");
    return text;
}

} // namespace app::svg
