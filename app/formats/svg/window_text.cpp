// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/window_text.h"

#include "app/base/finite.h"
#include "app/base/number.h"
#include "app/document/window_operations.h"
#include "app/formats/svg/attribute_text.h"
#include "app/formats/svg/colour.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/outline_text.h"
#include "app/formats/svg/path_data.h"
#include "app/formats/svg/recipe_text.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/style_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app::svg {
namespace {

constexpr std::string_view angleUnit = "rad", evenOdd = "evenodd";

void appendShape(std::string& text, const RectangleShape& rectangle)
{
    const clipping::Window& box = rectangle.box;
    appendAttribute(text, "xmin", box.min.x);
    appendAttribute(text, "ymin", box.min.y);
    appendAttribute(text, "xmax", box.max.x);
    appendAttribute(text, "ymax", box.max.y);
    if (rectangle.angle != 0) {
        appendAttribute(text, "angle", rectangle.angle);
        text.insert(text.size() - 1, angleUnit);
    }
}

void appendShape(std::string& text, const PathShape& shape)
{
    const WriteOptions exact;
    const OutlineText outline(exact);
    std::string data;
    for (const Subpath& path : shape.path.subpaths())
        outline.appendPathData(data, path);
    appendAttribute(text, "d", data);
    if (shape.rule == FillRule::EvenOdd)
        appendAttribute(text, "rule", evenOdd);
    if (const std::string recipe = textOf(shape.recipe, shape.path); !recipe.empty())
        appendAttribute(text, "recipe", recipe);
}

bool isFinite(const WindowShape& shape)
{
    if (const auto* own = std::get_if<PathShape>(&shape)) {
        bool all = true;
        own->path.forEachPoint([&](const Point& p) { all = all && app::isFinite(p); });
        return all;
    }
    const auto& [box, angle] = std::get<RectangleShape>(shape);
    return app::isFinite(box) && std::isfinite(angle);
}

void appendWindow(std::string& text, const ClipWindow& window, Keep keep)
{
    text += "<clearcut:window";
    if (const std::string name = escaped(window.name); !name.empty())
        appendAttribute(text, "name", name);
    if (window.operation != WindowOperation::Add)
        appendAttribute(text, "operation", infoOf(window.operation).word);
    if (!window.visible)
        appendAttribute(text, "visible", "no");
    if (window.colour)
        appendPaint(text, "colour", window.colour);
    if (keep == Keep::Outside)
        appendAttribute(text, "keep", "outside");
    std::visit([&](const auto& shape) { appendShape(text, shape); }, window.shape);
    text += "/>";
}

std::optional<double> numberOf(std::string_view text)
{
    const auto number = parseNumber(text);
    return number && std::abs(*number) <= largestCoordinate ? number : std::nullopt;
}

std::optional<WindowShape> pathOf(const Tree& tree, Node node)
try {
    const auto outline = parsePathData(tree.attribute(node, "d"));
    if (outline.damaged)
        return std::nullopt;
    PathShape shape{Path(outline.paths)};
    if (tree.attribute(node, "rule") == evenOdd)
        shape.rule = FillRule::EvenOdd;
    shape.recipe = readRecipe(tree.attribute(node, "recipe"), outline.paths);
    return shape;
} catch (const Refused&) { // a coordinate is not finite
    return std::nullopt;
}

std::optional<double> windowAngle(std::string_view text)
{
    if (text.empty())
        return 0;
    if (!text.ends_with(angleUnit))
        return std::nullopt;
    text.remove_suffix(angleUnit.size());
    return numberOf(text);
}

std::optional<WindowShape> shapeOf(const Tree& tree, Node node)
{
    if (tree.hasAttribute(node, "d"))
        return pathOf(tree, node);
    const auto number = [&](std::string_view name) { return numberOf(tree.attribute(node, name)); };
    const std::array v{number("xmin"), number("ymin"), number("xmax"), number("ymax")};
    const auto angle = windowAngle(tree.attribute(node, "angle"));
    if (!angle || !std::ranges::all_of(v, [](const auto& one) { return one.has_value(); }))
        return std::nullopt;
    return RectangleShape{{{*v[0], *v[1]}, {*v[2], *v[3]}}, *angle};
}

bool isInverted(const WindowShape& shape)
{
    const auto* const rectangle = std::get_if<RectangleShape>(&shape);
    if (!rectangle)
        return false;
    const auto& [min, max] = rectangle->box;
    return min.x > max.x || min.y > max.y;
}

std::optional<WindowOperation> operationOf(std::string_view text)
{
    return text.empty() ? WindowOperation::Add : windowOperation(text);
}

// Whether an attribute has the second of two values; the first is the default.
bool saysSecond(const Tree& tree, Node node, std::string_view attribute,
                std::array<std::string_view, 2> words, const LossKind& unknown, Report& report)
{
    const std::string_view text = tree.attribute(node, attribute);
    if (!text.empty() && text != words[0] && text != words[1])
        report.add(unknown, text);
    return text == words[1];
}

// Empty: the usual one.
std::optional<Colour> windowColour(std::string_view text, Report& report)
{
    const auto colour = text.empty() ? std::nullopt : parseColour(text);
    if (!text.empty() && !colour)
        report.add(losses::unknownColour, text);
    return colour;
}

std::optional<ClipWindow> windowOf(const Tree& tree, Node node, Report& report)
{
    auto shape = shapeOf(tree, node);
    const std::string_view operationText = tree.attribute(node, "operation");
    const auto operation = operationOf(operationText);
    if (!shape)
        report.add(losses::unreadableWindow);
    else if (isInverted(*shape))
        report.add(losses::invertedWindow);
    else if (!operation)
        report.add(losses::unknownOperation, operationText);
    else
        return ClipWindow{
            QString::fromUtf8(tree.attribute(node, "name")), std::move(*shape), *operation,
            !saysSecond(tree, node, "visible", {"yes", "no"}, losses::unknownVisible, report),
            windowColour(tree.attribute(node, "colour"), report)};
    return std::nullopt;
}

// Whether the element describes a window; without a shape it only holds values for all windows.
bool hasShape(const Tree& tree, Node node)
{
    constexpr std::array<std::string_view, 5> parts{"xmin", "ymin", "xmax", "ymax", "d"};
    return std::ranges::any_of(
        parts, [&](std::string_view part) { return tree.hasAttribute(node, part); });
}

void readWindow(const Tree& tree, Node node, ClipWindows& windows, Report& report)
{
    report.turnTo(tree.line(node));
    if (saysSecond(tree, node, "keep", {"inside", "outside"}, losses::unknownKeep, report))
        windows.keep = Keep::Outside;
    if (!hasShape(tree, node))
        return;
    auto window = windowOf(tree, node, report);
    if (!window)
        return;
    if (windows.list.size() == ClipWindows::most)
        report.add(losses::windows);
    else
        windows.list.push_back(std::move(*window));
}

} // namespace

std::string textOf(const ClipWindows& windows)
{
    std::string text;
    Keep keep = windows.keep;
    for (const ClipWindow& window : windows.list) {
        if (!isFinite(window.shape)) // it contains nothing, and SVG cannot represent it
            continue;
        appendWindow(text, window, keep);
        keep = Keep::Inside; // written only once
    }
    if (keep == Keep::Outside)
        text = "<clearcut:window keep=\"outside\"/>";
    return text;
}

ClipWindows readWindows(const Tree& tree, Report& report)
{
    ClipWindows windows;
    for (const Node metadata : Children(tree, 0)) {
        if (tree.name(metadata) != "metadata")
            continue;
        for (const Node node : Children(tree, metadata))
            if (tree.name(node) == "clearcut:window")
                readWindow(tree, node, windows, report);
    }
    return windows;
}

} // namespace app::svg
