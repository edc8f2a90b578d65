// SPDX-License-Identifier: GPL-3.0-or-later
// Elements that draw other elements (<use>, <symbol>) or have a viewport of their own (<svg>).
#include "app/formats/svg/refused.h"
#include "app/formats/svg/scanner.h"
#include "app/formats/svg/tree_drawer.h"

namespace app::svg {

void TreeDrawer::drawUse(Node node, const Place& around)
{
    Place place = inside(node, around);
    reportEffects(place.properties, true);
    const auto href = hrefOf(tree_, node);
    const Node target = tree_.findReference(href);
    if (target == noNode) {
        if (!trimmed(href).starts_with('#'))
            report_.add(losses::otherFile);
        return;
    }
    const bool ownAncestor = target <= node && node < tree_.end(target);
    if (ownAncestor || std::ranges::find(used_, target) != used_.end())
        throw Refused{Text::tr("has a <use> that contains itself.")};
    const Point shift{place.lengths.x(tree_.attribute(node, "x")).value_or(0),
                      place.lengths.y(tree_.attribute(node, "y")).value_or(0)};
    place.matrix = place.matrix * translation(shift);
    place.use = around.repeated ? around.use : node;
    place.repeated = true;
    used_.push_back(target);
    drawUsed(node, target, place);
    used_.pop_back();
}

void TreeDrawer::drawUsed(Node use, Node target, const Place& place)
{
    const auto name = tree_.name(target);
    if (name != "symbol" && name != "svg") {
        draw(target, place);
        return;
    }
    node_ = target;
    drawViewport(target, use, inside(target, place));
}

void TreeDrawer::drawNestedSvg(Node node, const Place& around)
{
    const Place place = inside(node, around);
    reportEffects(place.properties, true);
    drawViewport(node, node, place);
}

// `sizes` is the element that defines the size of the viewport: a <use> overrides the element it
// draws.
void TreeDrawer::drawViewport(Node node, Node sizes, const Place& around)
{
    const Lengths& lengths = around.lengths;
    const auto size = [&](std::string_view name, double whole) {
        auto text = trimmed(tree_.attribute(sizes, name));
        if (text.empty() || text == "auto")
            text = trimmed(tree_.attribute(node, name));
        return lengths.parse(text, whole).value_or(whole);
    };
    Box viewport{{}, {size("width", lengths.viewport.x), size("height", lengths.viewport.y)}};
    if (tree_.name(node) == "svg")
        viewport.min = {lengths.x(tree_.attribute(node, "x")).value_or(0),
                        lengths.y(tree_.attribute(node, "y")).value_or(0)};
    if (!(viewport.size.x > 0 && viewport.size.y > 0))
        return;
    Place place = around;
    if (!place.properties.overflowShown)
        addViewportClip(viewport, place);
    const auto box = parseViewBox(tree_.attribute(node, "viewBox"));
    if (box)
        place.matrix =
            place.matrix
            * viewBoxTransform(*box, viewport, tree_.attribute(node, "preserveAspectRatio"));
    else
        place.matrix = place.matrix * translation(viewport.min);
    place.lengths.viewport = box ? box->size : viewport.size;
    drawChildren(node, place);
}

} // namespace app::svg
