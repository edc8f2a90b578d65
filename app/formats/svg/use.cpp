// SPDX-License-Identifier: GPL-3.0-or-later
// Elements that draw other elements (<use>, <symbol>) or have a viewport of their own (<svg>).
#include "app/formats/svg/page.h"
#include "app/formats/svg/scanner.h"
#include "app/formats/svg/tree_drawer.h"

namespace app::svg {

void TreeDrawer::drawUse(Node node, const Place& around)
{
    Place place = inside(node, around);
    reportEffects(place.properties, true);
    const auto href = hrefOf(tree_, node);
    const Node target = tree_.findReference(href);
    if (target == noNode || containsItself(node, target)) {
        report_.add(losses::otherFile, isElsewhere(href));
        report_.add(losses::selfUse, target != noNode);
        return;
    }
    place.matrix = place.matrix * translation(shiftOf(node, place));
    setContext(place.properties, place.properties);
    place.use = around.repeated ? around.use : node;
    place.repeated = true;
    used_.push_back(target);
    drawUsed(node, target, place);
    used_.pop_back();
}

bool TreeDrawer::containsItself(Node use, Node target) const
{
    const bool ownAncestor = target <= use && use < tree_.end(target);
    return ownAncestor || std::ranges::find(used_, target) != used_.end();
}

Point TreeDrawer::shiftOf(Node use, const Place& place) const
{
    const auto text = [&](std::string_view name) {
        return lengthText(tree_, use, place.properties, name);
    };
    return {place.lengths.x(text("x")).value_or(0), place.lengths.y(text("y")).value_or(0)};
}

void TreeDrawer::drawUsed(Node use, Node target, const Place& place)
{
    const auto name = tree_.name(target);
    if (name != "symbol" && name != "svg") {
        draw(target, place);
        return;
    }
    node_ = target;
    report_.turnTo(line());
    drawViewport(target, inside(target, place), sizeOf(use, place));
}

TreeDrawer::ViewportSize TreeDrawer::sizeOf(Node use, const Place& place) const
{
    return {lengthText(tree_, use, place.properties, "width"),
            lengthText(tree_, use, place.properties, "height")};
}

void TreeDrawer::drawNestedSvg(Node node, const Place& around)
{
    const Place place = inside(node, around);
    reportEffects(place.properties, true);
    drawViewport(node, place, {});
}

void TreeDrawer::drawViewport(Node node, const Place& around, const ViewportSize& given)
{
    if (const auto place = inViewport(node, around, given))
        drawChildren(node, *place);
}

// The context of the children of a <symbol> or <svg>; empty: it has no size. `given` is the size
// that a <use> says, instead of the element that it draws.
std::optional<Place> TreeDrawer::inViewport(Node node, const Place& around,
                                            const ViewportSize& given)
{
    const Lengths& lengths = around.lengths;
    const auto size = [&](std::string_view name, std::string_view text, double whole) {
        if (trimmed(text).empty() || trimmed(text) == "auto")
            text = lengthText(tree_, node, around.properties, name);
        return lengths.parse(text, whole).value_or(whole);
    };
    Box viewport{{},
                 {size("width", given.width, lengths.viewport.x),
                  size("height", given.height, lengths.viewport.y)}};
    if (tree_.name(node) == "svg")
        viewport.min = shiftOf(node, around);
    for (const std::string_view name : {"refX", "refY"})
        if (tree_.hasAttribute(node, name))
            report_.add(losses::attribute, name);
    if (!(viewport.size.x > 0 && viewport.size.y > 0)) {
        report_.add(losses::sizeless);
        return std::nullopt;
    }
    Place place = around;
    if (!place.properties.overflowShown)
        addViewportClip(viewport, place);
    const auto box = readViewBox(tree_, node, report_);
    if (box)
        place.matrix =
            place.matrix
            * viewBoxTransform(*box, viewport, tree_.attribute(node, "preserveAspectRatio"));
    else
        place.matrix = place.matrix * translation(viewport.min);
    place.lengths.viewport = box ? box->size : viewport.size;
    return place;
}

} // namespace app::svg
