// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/gradient_reader.h"

#include "app/formats/svg/colour.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>

namespace app::svg {
namespace {

constexpr int mostLinks = 50; // a gradient may refer to another one, and that one to a third

/// The gradient and those that it refers to.
std::vector<Node> chainOf(const Tree& tree, Node node)
{
    std::vector<Node> chain;
    while (node != noNode && isGradient(tree, node) && std::ranges::count(chain, node) == 0
           && chain.size() < mostLinks) {
        chain.push_back(node);
        node = tree.findReference(hrefOf(tree, node));
    }
    return chain;
}

/// The properties of a gradient, with what it inherits from the elements around it.
Properties propertiesOf(const Tree& tree, Node node, Styles& styles, Report& report)
{
    const Report::Silence silence(report);
    std::vector<Node> around;
    for (Node each = node; each != noNode; each = tree.parent(each))
        around.push_back(each);
    Properties properties;
    for (auto each = around.rbegin(); each != around.rend(); ++each)
        properties = styles.of(*each, properties, {});
    return properties;
}

Rgba stopColour(const Properties& p)
{
    const Colour colour = faded(
        p.stopColour.kind == Paint::Kind::Current ? p.colour : p.stopColour.colour, p.stopOpacity);
    return {colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0, colour.alpha / 255.0};
}

/// The attributes of a gradient; what it does not say, others in its chain do.
class GradientAttributes {
public:
    GradientAttributes(const Tree& tree, Node node, const Lengths& lengths)
        : tree_(tree), chain_(chainOf(tree, node)), lengths_(lengths)
    {
        if (text("gradientUnits") != "userSpaceOnUse")
            lengths_.viewport = {1, 1};
    }
    std::string_view text(std::string_view name) const
    {
        for (const Node node : chain_)
            if (tree_.hasAttribute(node, name))
                return trimmed(tree_.attribute(node, name));
        return {};
    }
    const Lengths& lengths() const { return lengths_; }
    double x(std::string_view name, double usual) const
    {
        return lengths_.x(text(name)).value_or(usual * lengths_.viewport.x);
    }
    double y(std::string_view name, double usual) const
    {
        return lengths_.y(text(name)).value_or(usual * lengths_.viewport.y);
    }
    double radius(std::string_view name, double usual) const
    {
        const double whole = lengths_.diagonal();
        return std::max(lengths_.parse(text(name), whole).value_or(usual * whole), 0.0);
    }

private:
    const Tree& tree_;
    std::vector<Node> chain_;
    Lengths lengths_;
};

} // namespace

bool isGradient(const Tree& tree, Node node)
{
    const auto name = tree.name(node);
    return name == "linearGradient" || name == "radialGradient";
}

GradientStops gradientStops(const Tree& tree, Node node, Styles& styles, Report& report)
{
    GradientStops stops;
    for (const Node each : chainOf(tree, node)) {
        std::optional<Properties> around;
        for (const Node child : Children(tree, each)) {
            if (tree.name(child) != "stop")
                continue;
            if (!around)
                around = propertiesOf(tree, each, styles, report);
            const double given = parseOpacity(tree.attribute(child, "offset")).value_or(0);
            const double at = stops.empty() ? given : std::max(given, stops.back().at);
            stops.push_back({at, stopColour(styles.of(child, *around, {}))});
        }
        if (!stops.empty())
            break;
    }
    return stops;
}

GradientShape gradientShape(const Tree& tree, Node node, const Lengths& lengths)
{
    using Spread = GradientShape::Spread;
    const GradientAttributes a(tree, node, lengths);
    GradientShape shape;
    shape.radial = tree.name(node) == "radialGradient";
    shape.inBox = a.text("gradientUnits") != "userSpaceOnUse";
    shape.transform = parseTransform(a.text("gradientTransform"), {a.lengths()}).value_or(Matrix{});
    const auto spread = a.text("spreadMethod");
    shape.spread = spread == "reflect"  ? Spread::Reflect
                   : spread == "repeat" ? Spread::Repeat
                                        : Spread::Pad;
    if (!shape.radial) {
        shape.from = {a.x("x1", 0), a.y("y1", 0)};
        shape.to = {a.x("x2", 1), a.y("y2", 0)};
        return shape;
    }
    shape.to = {a.x("cx", 0.5), a.y("cy", 0.5)};
    shape.from = {a.text("fx").empty() ? shape.to.x : a.x("fx", 0.5),
                  a.text("fy").empty() ? shape.to.y : a.y("fy", 0.5)};
    shape.radius = a.radius("r", 0.5);
    shape.focusRadius = a.radius("fr", 0);
    return shape;
}

} // namespace app::svg
