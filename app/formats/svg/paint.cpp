// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/paint.h"

#include "app/formats/svg/colour.h"
#include "app/formats/svg/refused.h"

namespace app::svg {
namespace {

constexpr int mostGradientLinks = 50; // a gradient may take its colours from another gradient

bool isGradient(const Tree& tree, Node node)
{
    const auto name = tree.name(node);
    return name == "linearGradient" || name == "radialGradient";
}

} // namespace

Style Paints::style(const Properties& p, double opacity, double scale)
{
    Style style{.stroke = colour(p.stroke, opacity * p.strokeOpacity, p),
                .fill = colour(p.fill, opacity * p.fillOpacity, p),
                .width = p.width * scale,
                .miterLimit = p.miterLimit,
                .dashOffset = p.dashOffset * scale,
                .dashes = p.dashes,
                .cap = p.cap,
                .join = p.join,
                .fillRule = p.fillRule};
    for (double& dash : style.dashes)
        dash *= scale;
    return style;
}

std::optional<Colour> Paints::colour(const Paint& paint, double opacity, const Properties& p)
{
    std::optional<Colour> colour;
    if (paint.kind == Paint::Kind::Solid)
        colour = paint.colour;
    else if (paint.kind == Paint::Kind::Current)
        colour = p.colour;
    else if (paint.kind == Paint::Kind::Reference)
        colour = referenced(paint, p);
    return colour ? std::optional(faded(*colour, opacity)) : std::nullopt;
}

std::optional<Colour> Paints::referenced(const Paint& paint, const Properties& p)
{
    const Node node = tree_.findReference(paint.reference);
    if (node != noNode && isGradient(tree_, node)) {
        const Gradient& found = gradient(node);
        if (!found.plain)
            report_.add(losses::gradient);
        return found.first;
    }
    if (node != noNode && tree_.name(node) == "pattern")
        report_.add(losses::pattern);
    else if (node != noNode)
        report_.add(losses::paintServer, tree_.name(node));
    else if (isElsewhere(paint.reference))
        report_.add(losses::otherFile);
    return paint.fallback == Paint::Kind::Solid     ? std::optional(paint.colour)
           : paint.fallback == Paint::Kind::Current ? std::optional(p.colour)
                                                    : std::nullopt;
}

const Paints::Gradient& Paints::gradient(Node node)
{
    const auto [at, isNew] = gradients_.try_emplace(node);
    Gradient& result = at->second;
    if (!isNew)
        return result;
    int stops = 0;
    for (int link = 0; link < mostGradientLinks && node != noNode && stops == 0; ++link) {
        for (const Node child : Children(tree_, node)) {
            if (tree_.name(child) != "stop" || stops++ > 0)
                continue;
            const Properties p = styles_.of(child, styles_.of(node, {}, {}), {});
            const Colour colour =
                p.stopColour.kind == Paint::Kind::Current ? p.colour : p.stopColour.colour;
            result.first = faded(colour, p.stopOpacity);
        }
        node = tree_.findReference(hrefOf(tree_, node));
    }
    result.plain = stops <= 1;
    return result;
}

} // namespace app::svg
