// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/clipped_content.h"

#include "app/base/text.h"
#include "app/cut/stroke_area.h"
#include "app/formats/svg/element_bounds.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/refused.h"

#include <algorithm>

namespace app::svg {
namespace {

KeptClips keptOf(const ClipAreas& areas)
{
    KeptClips clips;
    for (const auto& area : areas)
        clips.emplace_back(area, &area->windows);
    return clips;
}

/// Whether a stroke of this width is inside an area that is a rectangle.
bool isStrokeInside(const Path& path, double width, const ClipArea& area)
{
    const auto box =
        area.windows.list.size() == 1 ? axisAlignedBox(area.windows.list[0].shape) : std::nullopt;
    if (!box)
        return false;
    ElementBounds bounds;
    for (const Subpath& subpath : path.subpaths())
        include(bounds, subpath);
    const Point reach(width / 2), min = bounds.min - reach, max = bounds.max + reach;
    return min.x >= box->min.x && min.y >= box->min.y && max.x <= box->max.x && max.y <= box->max.y;
}

} // namespace

void ClippedContent::open(Container container)
{
    if (scopes_.empty())
        containers_.open(std::move(container));
    else
        scopes_.back().events.emplace_back(std::move(container));
}

void ClippedContent::close()
{
    if (scopes_.empty())
        containers_.close();
    else
        scopes_.back().events.emplace_back(Closing{});
}

void ClippedContent::add(Object object, const ClipAreas& around)
{
    if (keepsClips_)
        object.particulars.clips = keptOf(around);
    else
        moveTo(around);
    parts_.add(object);
    put(std::move(object));
}

// Into these areas, out of all others.
void ClippedContent::moveTo(const ClipAreas& areas)
{
    std::size_t same = 0;
    while (same < std::min(scopes_.size(), areas.size()) && scopes_[same].area == areas[same])
        ++same;
    while (scopes_.size() > same)
        leave();
    for (; same < areas.size(); ++same)
        scopes_.push_back({areas[same]});
}

void ClippedContent::put(Object object)
{
    if (scopes_.empty())
        return containers_.add(std::move(object));
    Scope& scope = scopes_.back();
    scope.events.emplace_back(scope.objects.size());
    scope.objects.append(object);
}

void ClippedContent::leave()
{
    const Scope scope = std::move(scopes_.back());
    scopes_.pop_back();
    const auto line = report_.line();
    report_.turnTo(scope.area->line);
    std::vector<CutObject> left = cut(scope);
    for (const Event& event : scope.events)
        if (const auto* container = std::get_if<Container>(&event))
            open(*container);
        else if (const auto* object = std::get_if<std::size_t>(&event))
            putWhatIsLeft(scope.objects[*object], std::move(left[*object]));
        else
            close();
    report_.turnTo(line);
}

std::vector<CutObject> ClippedContent::cut(const Scope& scope)
{
    if (scope.objects.empty())
        return {};
    ClippedObjects left = clipped(scope.objects, *scope.area, page_);
    addWork(left.work);
    report_.add(losses::crossedClipPath, left.tooMany);
    tellSidesOfStrokes(scope, left.objects);
    return std::move(left.objects);
}

bool ClippedContent::isWideStroke(const ObjectView& object) const
{
    const Style& style = object.style();
    return style.stroke && style.width > leastWideStroke / page_.millimetresPerUnit()
           && object.path().pointCount() <= mostLookedAtStroke;
}

// Lines are cut, not what their strokes cover: of a wide stroke whose line is hidden a side may be
// visible, and of one whose line is not, a side may be hidden.
void ClippedContent::tellSidesOfStrokes(const Scope& scope, std::span<const CutObject> left)
{
    constexpr double besideRounding = 0.95; // a stroke may end exactly where the area does
    std::vector<bool> isHidden;
    Objects strokes;
    for (std::size_t i = 0; i < left.size(); ++i) {
        const ObjectView object = scope.objects[i];
        const bool hidden = !left[i].whole && left[i].left.empty();
        if ((!hidden && !left[i].whole) || !isWideStroke(object))
            continue;
        Style style = object.style();
        if (!hidden) {
            style.width *= besideRounding;
            looked_ += object.path().pointCount();
            if (looked_ > mostLookedAtStrokes
                || isStrokeInside(object.path(), style.width, *scope.area))
                continue;
        }
        const Path area(strokeArea(object.path(), style, usualTolerance(page_)));
        strokes.append(Object{area, {.fill = Colour{}}});
        isHidden.push_back(hidden);
    }
    if (strokes.empty() || scope.area->windows.list.empty())
        return;
    const ClippedObjects visible = clipped(strokes, *scope.area, page_);
    addWork(visible.work);
    for (std::size_t i = 0; i < isHidden.size(); ++i) {
        const CutObject& one = visible.objects[i];
        report_.add(losses::hiddenStroke, isHidden[i] && (one.whole || !one.left.empty()));
        report_.add(losses::wholeStroke, !isHidden[i] && !one.whole);
    }
}

void ClippedContent::putWhatIsLeft(const ObjectView& object, CutObject left)
{
    if (left.whole)
        return put(object.copy());
    parts_.remove(object.copy());
    report_.add(left.left.empty() ? losses::hiddenShape : losses::cutShape);
    report_.add(losses::wideStroke, left.slanted);
    for (std::size_t i = 0; i < left.left.size(); ++i) {
        Object& part = left.left[i];
        part.particulars.recipe = {};
        if (i > 0)
            part.particulars = {};
        parts_.add(part);
        put(std::move(part));
    }
}

void ClippedContent::addWork(std::size_t work)
{
    work_ += work;
    if (work_ > parts_.allowed(mostClipWork))
        throw Refused{
            Text::tr("exceeds the limit of work for clip paths; remove some clip paths.")};
}

Document ClippedContent::take(About about)
{
    moveTo({});
    return containers_.take(page_, std::move(about), report_);
}

} // namespace app::svg
