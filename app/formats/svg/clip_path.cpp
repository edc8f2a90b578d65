// SPDX-License-Identifier: GPL-3.0-or-later
// Clip paths, and viewports that hide everything outside them: the content of both is really cut.
#include "app/formats/svg/clip_object.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/scanner.h"
#include "app/formats/svg/tree_drawer.h"

namespace app::svg {

void TreeDrawer::addClipPath(Node node, Place& place)
{
    const auto reference = place.properties.clipPath;
    const Node clip = tree_.findReference(reference);
    const bool local = reference.starts_with("url(");
    if (local && (clip == noNode || tree_.name(clip) != "clipPath"))
        return; // SVG: without the clip path there is no clipping
    const auto region = local ? clipRegion(clip, place) : std::nullopt;
    if (region) {
        place.clips.push_back(std::make_shared<const ConvexRegion>(*region));
        report_.add(losses::cutClipPath);
    } else {
        report_.add(losses::clipPath);
    }
    node_ = node;
}

std::optional<ConvexRegion> TreeDrawer::clipRegion(Node clip, const Place& place)
{
    Place base = place;
    base.properties = styles_.of(clip, {}, place.lengths);
    const auto own = parseTransform(base.properties.transform);
    if (tree_.attribute(clip, "clipPathUnits") == "objectBoundingBox" || !own
        || !base.properties.clipPath.empty())
        return std::nullopt;
    base.matrix = place.matrix * *own;
    std::vector<Subpath> paths;
    for (const Node child : Children(tree_, clip)) {
        const auto drawn = clipOutline(child, base);
        if (!drawn)
            return std::nullopt;
        paths.insert(paths.end(), drawn->begin(), drawn->end());
        if (paths.size() > 1)
            return std::nullopt; // several areas: their union may not be convex
    }
    return ConvexRegion::of(paths.empty() ? Subpath{} : paths.front(), tolerance_);
}

// The outline of a child of a clip path; empty for children without an outline (text).
std::optional<std::vector<Subpath>> TreeDrawer::clipOutline(Node node, const Place& base)
{
    Properties properties = styles_.of(node, base.properties, base.lengths);
    auto matrix = parseTransform(properties.transform);
    if (!matrix || !properties.clipPath.empty())
        return std::nullopt;
    if (tree_.name(node) == "use") {
        const Point shift{base.lengths.x(tree_.attribute(node, "x")).value_or(0),
                          base.lengths.y(tree_.attribute(node, "y")).value_or(0)};
        node = tree_.findReference(hrefOf(tree_, node));
        if (node == noNode)
            return std::vector<Subpath>();
        properties = styles_.of(node, properties, base.lengths);
        const auto inner = parseTransform(properties.transform);
        if (!inner || tree_.name(node) == "use" || !properties.clipPath.empty())
            return std::nullopt;
        matrix = *matrix * translation(shift) * *inner;
    }
    const OutlineKind* kind = findOutlineKind(tree_.name(node));
    if (!kind)
        return tree_.name(node) == "text" || tree_.name(node) == "use" || tree_.name(node) == "g"
                   ? std::nullopt
                   : std::optional(std::vector<Subpath>());
    if (!properties.displayed || !properties.visible)
        return std::vector<Subpath>();
    return placed(kind->outline(tree_, node, base.lengths), base.matrix * *matrix);
}

void TreeDrawer::addViewportClip(const Box& viewport, Place& place)
{
    const Point max = viewport.min + viewport.size;
    Subpath path{viewport.min, {{{max.x, viewport.min.y}}, {max}, {{viewport.min.x, max.y}}}, true};
    transform(path, place.matrix);
    if (const auto region = ConvexRegion::of(path, tolerance_))
        place.clips.push_back(std::make_shared<const ConvexRegion>(*region));
}

// The objects that a clip region leaves of an object; the whole object if it cannot be clipped.
std::vector<Drawn> TreeDrawer::clipped(Drawn drawn, const ConvexRegion& region)
{
    auto left = clipObject(drawn, region, tolerance_);
    if (!left) {
        report_.add(losses::clipPath);
        std::vector<Drawn> all;
        all.push_back(std::move(drawn));
        return all;
    }
    clipWork_ += left->work;
    if (clipWork_ > mostClipWork)
        throw Refused{
            Text::tr("exceeds the limit of work for clip paths; remove some clip paths.")};
    return std::move(left->objects);
}

// Clips an object with all clip regions around it, and adds the result.
void TreeDrawer::addClipped(Drawn drawn, const Place& place)
{
    std::vector<Drawn> objects;
    objects.push_back(std::move(drawn));
    for (auto region = place.clips.rbegin(); region != place.clips.rend(); ++region) {
        std::vector<Drawn> kept;
        for (Drawn& one : objects)
            std::ranges::move(clipped(std::move(one), **region), std::back_inserter(kept));
        objects = std::move(kept);
    }
    for (Drawn& one : objects) {
        countParts(one);
        containers_.add(
            {Path(one.paths), std::move(one.style), std::move(one.particulars), one.hidden});
    }
}

} // namespace app::svg
