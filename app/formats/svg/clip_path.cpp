// SPDX-License-Identifier: GPL-3.0-or-later
// Clip paths, and viewports that hide everything outside them: the content of both is really cut.
#include "app/base/text.h"
#include "app/document/flatten.h"
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
    const auto line = report_.line();
    if (!equalsIgnoringCase(reference.substr(0, 4), "url("))
        report_.add(losses::value, "clip-path: " + std::string(reference));
    else if (isElsewhere(reference))
        report_.add(losses::otherFile);
    else if (clip != noNode && tree_.name(clip) == "clipPath")
        if (const auto region = clipRegion(clip, place)) {
            place.clips.push_back(std::make_shared<const ConvexRegion>(*region));
            report_.add(losses::cutClipPath);
        }
    report_.turnTo(line);
    node_ = node;
}

// Tells why a clip path is not applied.
std::nullopt_t TreeDrawer::refuseClip(const LossKind& why)
{
    report_.add(why);
    return std::nullopt;
}

std::optional<ConvexRegion> TreeDrawer::clipRegion(Node clip, const Place& place)
{
    if (tree_.attribute(clip, "clipPathUnits") == "objectBoundingBox")
        return refuseClip(losses::clipPathUnits);
    Place base = place;
    base.properties = {};
    base = styled(clip, base);
    if (!base.properties.clipPath.empty())
        return refuseClip(losses::nestedClipPath);
    const auto paths = clipOutlines(clip, base);
    if (!paths)
        return std::nullopt;
    if (paths->size() > 1) // their union may not be convex
        return refuseClip(losses::clipPathOfSeveral);
    const Subpath path = paths->empty() ? Subpath{} : paths->front();
    if (auto region = ConvexRegion::of(path, tolerance_))
        return region;
    return refuseClip(chordCount(path, tolerance_) > mostClipSides ? losses::longClipPath
                                                                   : losses::clipPath);
}

// The outlines of a clip path's children.
std::optional<std::vector<Subpath>> TreeDrawer::clipOutlines(Node clip, const Place& base)
{
    std::vector<Subpath> all;
    for (const Node child : Children(tree_, clip)) {
        if (!isDrawn(tree_.name(child)))
            continue;
        auto paths = clipOutline(child, base);
        if (!paths)
            return std::nullopt;
        std::ranges::move(*paths, std::back_inserter(all));
    }
    return all;
}

std::optional<std::vector<Subpath>> TreeDrawer::clipOutline(Node node, const Place& base)
{
    Place place = styled(node, base);
    if (tree_.name(node) == "use") {
        const Point shift = shiftOf(node, place);
        const Node target = tree_.findReference(hrefOf(tree_, node));
        if (target == noNode)
            return std::vector<Subpath>();
        place.matrix = place.matrix * translation(shift);
        if (place.properties.clipPath.empty() && place.properties.displayed)
            place = styled(node = target, place);
    }
    if (!place.properties.clipPath.empty())
        return refuseClip(losses::nestedClipPath);
    if (!place.properties.displayed || !place.properties.visible)
        return std::vector<Subpath>();
    const OutlineKind* kind = findOutlineKind(tree_.name(node));
    if (!kind) { // text, or a <use> of a <use>
        report_.add(losses::clipPathContent, tree_.name(node));
        return std::nullopt;
    }
    return placed(outlineOf(*kind, node, place), place.matrix);
}

void TreeDrawer::addViewportClip(const Box& viewport, Place& place)
{
    const Point max = viewport.min + viewport.size;
    Subpath path{viewport.min, {{{max.x, viewport.min.y}}, {max}, {{viewport.min.x, max.y}}}, true};
    svg::transform(path, place.matrix);
    if (const auto region = ConvexRegion::of(path, tolerance_))
        place.clips.push_back(std::make_shared<const ConvexRegion>(*region));
}

// The objects that a clip region leaves of an object; the whole object if it cannot be clipped.
std::vector<Drawn> TreeDrawer::clipped(Drawn drawn, const ConvexRegion& region)
{
    auto left = clipObject(drawn, region, tolerance_);
    if (!left) {
        report_.add(losses::longClipped);
        std::vector<Drawn> all;
        all.push_back(std::move(drawn));
        return all;
    }
    clipWork_ += left->work;
    report_.add(losses::wideStroke, left->strokeDiffers);
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
