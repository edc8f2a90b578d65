// SPDX-License-Identifier: GPL-3.0-or-later
// Plain masks: of opaque shapes in one colour, which show, and in black, which hide. They are cuts,
// like clip paths; a colour darker than white is an opacity, too. All others are told.
#include "app/cut/stroke_area.h"
#include "app/document/flatten.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/tree_drawer.h"

#include <algorithm>
#include <cmath>

namespace app::svg {
namespace {

bool isSeen(const std::optional<Colour>& colour) { return colour && colour->alpha > 0; }

// How much of what is behind it a colour lets through.
double strengthOf(const Colour& c, bool byAlpha)
{
    if (byAlpha)
        return c.alpha / 255.0;
    const double luminance = 0.2125 * c.red + 0.7154 * c.green + 0.0721 * c.blue;
    return std::round(luminance) / 255 * (c.alpha / 255.0);
}

bool hasEffect(const Properties& properties)
{
    return !(properties.mask.empty() && properties.filter.empty() && properties.blending.empty());
}

bool isPlainPaint(const Properties& p)
{
    const bool marked = !(p.markerStart.empty() && p.markerMid.empty() && p.markerEnd.empty());
    return p.fill.kind != Paint::Kind::Reference && p.stroke.kind != Paint::Kind::Reference
           && !marked && p.paintOrder == Properties().paintOrder;
}

} // namespace

// Whether a colour can be part of the mask.
bool TreeDrawer::MaskShapes::takes(const std::optional<Colour>& colour)
{
    if (!isSeen(colour))
        return true;
    const bool isOpaque = colour->alpha == 255;
    const double one = strengthOf(*colour, byAlpha);
    if (one == 0)
        return isOpaque;
    const bool fits = strength.value_or(one) == one;
    strength = one;
    isFaint = isFaint || !isOpaque;
    return fits && (++paints == 1 || !isFaint); // several that are not opaque may overlap
}

void TreeDrawer::addMask(const Boxed& boxed, Place& place)
{
    const auto line = report_.line();
    const Node node = node_, mask = tree_.findReference(place.properties.mask);
    const bool isMask = mask != noNode && tree_.name(mask) == "mask";
    Place masked = place;
    if (isMask && std::ranges::count(clipping_, mask) == 0 && addMaskArea(mask, boxed, masked)) {
        place.clips = std::move(masked.clips);
        place.opacity = masked.opacity;
        place.properties.opacity = masked.properties.opacity;
        place.properties.mask = {};
        report_.turnTo(line);
        report_.add(content_.keepsClips() ? losses::keptMask : losses::cutMask);
    }
    report_.turnTo(line);
    node_ = node;
}

// False: it is not plain, or the box that it refers to is not known.
bool TreeDrawer::addMaskArea(Node mask, const Boxed& boxed, Place& place)
{
    refuseTooDeep(place);
    Place base = place;
    base.clips.clear();
    base.properties = inheritedBy(mask);
    base = styled(mask, base);
    base.opacity = 1; // neither opacity nor transform of the mask itself has an effect
    base.matrix = place.matrix;
    if (hasEffect(base.properties) || base.properties.linearColours
        || !addMaskRegion(mask, boxed, base, place))
        return false;
    if (const auto own = base.properties.clipPath; !own.empty())
        addClipPath(own, boxed, place);
    MaskShapes shapes{{}, base.properties.maskByAlpha};
    clipping_.push_back(mask);
    const bool isPlain = turnToBox(tree_.attribute(mask, "maskContentUnits"), boxed, base)
                         && addMaskContent(mask, base, shapes);
    clipping_.pop_back();
    if (!isPlain || shapes.windows.list.size() > ClipWindows::most)
        return false;
    const double strength = shapes.strength.value_or(1);
    place.opacity *= strength;
    place.properties.opacity *= strength;
    return addWindows(std::move(shapes.windows), place);
}

// The rectangle outside which a mask hides everything; usually, nothing is there.
bool TreeDrawer::addMaskRegion(Node mask, const Boxed& boxed, const Place& base, Place& place)
{
    const bool ofUser = tree_.attribute(mask, "maskUnits") == "userSpaceOnUse";
    const auto is = [&](std::string_view name) { return tree_.hasAttribute(mask, name); };
    const auto bounds = ofUser ? std::nullopt : boundsOf(boxed.node, boxed.place);
    if (bounds && bounds->size.x * bounds->size.y == 0)
        return addWindows({}, place); // a rectangle in this box is empty
    if (!ofUser && !is("x") && !is("y") && !is("width") && !is("height"))
        return true;
    Place units = base;
    if (!ofUser && !turnToBox("objectBoundingBox", boxed, units))
        return false;
    const auto length = [&](std::string_view name, std::string_view usual, double whole) {
        const auto text = tree_.attribute(mask, name);
        const auto given = units.lengths.parse(text.empty() ? usual : text, whole);
        return given.value_or(0);
    };
    const Point viewport = units.lengths.viewport;
    const Box box{{length("x", "-10%", viewport.x), length("y", "-10%", viewport.y)},
                  {length("width", "120%", viewport.x), length("height", "120%", viewport.y)}};
    ClipWindows windows;
    if (box.size.x > 0 && box.size.y > 0)
        windows.list.push_back({.shape = rectangleShape(box, units.matrix)});
    return addWindows(std::move(windows), place);
}

bool TreeDrawer::addMaskContent(Node node, const Place& place, MaskShapes& shapes)
{
    for (const Node child : Children(tree_, node))
        if (isDrawn(tree_.name(child)) && isWanted(child) && !addMaskElement(child, place, shapes))
            return false;
    return true;
}

bool TreeDrawer::addMaskElement(Node node, const Place& around, MaskShapes& shapes)
{
    content_.addWork(workOfClipElement);
    refuseTooDeep(around);
    Place place = styled(node, around);
    if (!place.properties.displayed)
        return true;
    if (hasEffect(place.properties))
        return false;
    if (const auto clip = place.properties.clipPath; !clip.empty())
        addClipPath(clip, {node, place}, place);
    const auto name = tree_.name(node);
    if (name == "g" || name == "a")
        return addMaskContent(node, place, shapes);
    if (name != "use")
        return addMaskShape(node, place, shapes);
    const Node target = tree_.findReference(hrefOf(tree_, node));
    if (target == noNode || containsItself(node, target))
        return true;
    place.matrix = place.matrix * translation(shiftOf(node, place));
    used_.push_back(target);
    const bool isPlain = addMaskElement(target, place, shapes);
    used_.pop_back();
    return isPlain;
}

bool TreeDrawer::addMaskShape(Node node, const Place& place, MaskShapes& shapes)
{
    const OutlineKind* kind = findOutlineKind(tree_.name(node));
    if (!kind || !isPlainPaint(place.properties))
        return false;
    if (!place.properties.visible)
        return true;
    const Style style = paints_.style(place.properties, place.opacity,
                                      {place.matrix.scale(), place.matrix.scale()});
    if (!shapes.takes(style.fill) || !shapes.takes(style.stroke))
        return false;
    const Path path(placed(outlineOf(*kind, node, place), place.matrix));
    const auto add = [&](const Path& area, FillRule rule, const Colour& colour) {
        const bool hides = strengthOf(colour, shapes.byAlpha) == 0;
        std::vector<PathShape> left;
        if (!addCut({area, rule}, place.clips, left))
            return false;
        for (PathShape& one : left)
            if (!hides || !shapes.windows.list.empty())
                shapes.windows.list.push_back(
                    {.shape = std::move(one),
                     .operation = hides ? WindowOperation::CutOut : WindowOperation::Add});
        return true;
    };
    if (isSeen(style.fill) && !add(path, style.fillRule, *style.fill))
        return false;
    if (!isSeen(style.stroke) || !(style.width > 0))
        return true;
    if (place.properties.fixedWidth || !place.matrix.keepsShapes()
        || path.pointCount() > mostMaskStroke)
        return false;
    const Path stroke(strokeArea(path, style, usualTolerance(page_) / 5));
    return add(stroke, FillRule::NonZero, *style.stroke);
}

} // namespace app::svg
