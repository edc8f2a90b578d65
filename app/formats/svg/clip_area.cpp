// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/clip_area.h"

#include "app/cut/cut_each.h"
#include "app/document/window_shape.h"
#include "app/formats/svg/clip_meetings.h"
#include "app/formats/svg/limits.h"
#include "clipping/algorithm.h"

#include <algorithm>

namespace app::svg {
namespace {

std::size_t chordsOf(const ClipWindows& windows, double tolerance)
{
    std::size_t chords = 0;
    for (const ClipWindow& window : windows.list)
        for (const Subpath& path : pathOf(window.shape).path.subpaths())
            chords += chordCount(path, tolerance);
    return chords;
}

std::size_t pointsOf(const ClipWindows& windows)
{
    std::size_t points = 0;
    for (const ClipWindow& window : windows.list)
        points += pathOf(window.shape).path.pointCount();
    return points;
}

std::size_t curvedPointsOf(const Objects& objects)
{
    std::size_t points = 0;
    objects.forEach(0, objects.size(), [&](std::size_t, const ObjectView& object) {
        if (!object.singleLine() && !object.path().straight())
            points += object.path().pointCount();
    });
    return points;
}

// True curves count, unless there are very many, or they are very large: then polygons do, whose
// chords are those of the objects.
CutOptions optionsAt(const ClipArea& area, const Objects& objects, const Page& page)
{
    CutOptions options{.clipAll = clipping::exactAlgorithm().corrected.clipAll,
                       .wideStroke = leastWideStroke / page.millimetresPerUnit()};
    double near = CurvedBorder::millimetres / page.millimetresPerUnit();
    const bool isFine = pointsOf(area.windows) <= mostTrueClipPoints
                        && curvedPointsOf(objects) <= mostTrueClippedPoints
                        && chordsOf(area.windows, near / 2) <= mostTrueClipChords;
    if (isFine) {
        options.coincident = near;
        options.windows = area.windows;
    }
    double tolerance = usualTolerance(page);
    constexpr int coarsest = 20; // times coarser by half
    for (int i = 0; i < coarsest && chordsOf(area.windows, tolerance) > mostClipChords; ++i)
        tolerance *= 4;
    options.region = regionOf(area.windows, tolerance);
    return options;
}

ClippedObjects whole(std::size_t objects)
{
    ClippedObjects all{std::vector<CutObject>(objects), 0, true};
    for (CutObject& one : all.objects)
        one.whole = true;
    return all;
}

} // namespace

ClipWindows unitedWindows(std::vector<PathShape> shapes)
{
    std::vector<clipping::Window> boxes;
    for (const PathShape& shape : shapes)
        boxes.push_back(boxOf(WindowShape(shape)));
    const BoxIndex index(boxes);
    ClipWindows windows;
    std::vector<Subpath> apart[2];
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        std::size_t near = 0;
        index.meeting(boxes[i], 0, [&](std::uint32_t) { ++near; });
        if (near == 1)
            std::ranges::move(shapes[i].path.subpaths(),
                              std::back_inserter(apart[std::size_t(shapes[i].rule)]));
        else
            windows.list.push_back({.shape = std::move(shapes[i])});
    }
    for (const FillRule rule : {FillRule::NonZero, FillRule::EvenOdd})
        if (const auto& paths = apart[std::size_t(rule)]; !paths.empty())
            windows.list.push_back({.shape = PathShape{Path(paths), rule}});
    return windows;
}

ClippedObjects clipped(const Objects& objects, const ClipArea& area, const Page& page)
{
    if (area.windows.list.empty())
        return {std::vector<CutObject>(objects.size()), objects.size(), false};
    const CutOptions options = optionsAt(area, objects, page);
    const ClipMeetings meetings(objects, options.region, usualTolerance(page));
    if (meetings.areTooMany())
        return whole(objects.size());
    return {cutEach(objects, page, options), meetings.chords() + meetings.edges(), false};
}

std::optional<PathShape> clipped(PathShape shape, const ClipAreas& areas, const Page& page,
                                 std::size_t& work)
{
    for (const auto& area : areas) {
        Objects objects;
        objects.append({shape.path, {.fill = Colour{}, .fillRule = shape.rule}});
        ClippedObjects left = clipped(objects, *area, page);
        work += left.work;
        if (left.tooMany)
            return std::nullopt;
        CutObject& one = left.objects.front();
        if (!one.whole)
            shape = {one.left.empty() ? Path() : one.left.front().path, FillRule::NonZero};
    }
    return shape;
}

} // namespace app::svg
