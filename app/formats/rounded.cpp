// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/rounded.h"

#include "app/formats/coordinates.h"

#include <algorithm>

namespace app {
namespace {

bool isPointPath(const Subpath& path)
{
    return std::ranges::all_of(path.segments, [&](const PathSegment& segment) {
        const bool straight =
            !segment.curved || (segment.control1 == path.start && segment.control2 == path.start);
        return segment.to == path.start && straight;
    });
}

} // namespace

std::optional<Subpath> rounded(const Subpath& path, const WriteOptions& options)
{
    if (options.precision < 0)
        return path;
    Subpath result{roundedPoint(path.start, options), {}, path.closed};
    Point at = result.start;
    for (const PathSegment& segment : path.segments) {
        PathSegment next{roundedPoint(segment.to, options), {}, {}, segment.curved};
        if (segment.curved) {
            next.control1 = roundedControl(segment.control1, options);
            next.control2 = roundedControl(segment.control2, options);
        }
        const bool moves =
            next.to != at || (next.curved && (next.control1 != at || next.control2 != at));
        if (moves)
            result.segments.push_back(next);
        at = next.to;
    }
    const bool returns = result.closed && result.segments.size() > 1
                         && !result.segments.back().curved && at == result.start;
    if (returns) // the closing line goes there
        result.segments.pop_back();
    if (result.segments.empty() && !isPointPath(path))
        return std::nullopt;
    return result;
}

Rounded rounded(Document document, const WriteOptions& options)
{
    if (options.precision < 0)
        return {std::move(document)};
    const Objects& all = document.objects();
    std::size_t points = 0;
    Edit edit;
    edit.objects = all.slice(0, 0);
    all.forEach(0, all.size(), [&](std::size_t i, const ObjectView& object) {
        std::vector<Subpath> paths;
        for (const Subpath& path : object.path().subpaths())
            if (auto kept = rounded(path, options))
                paths.push_back(std::move(*kept));
            else
                ++points;
        edit.splices.push_back({std::uint32_t(i), 1, std::uint32_t(!paths.empty())});
        if (paths.empty())
            return;
        ObjectRow row = object.row();
        row.path = Path(paths);
        edit.objects.append(row);
    });
    edit.containers = document.containers().spliced(edit.splices);
    document.apply(edit);
    return {std::move(document), points};
}

} // namespace app
