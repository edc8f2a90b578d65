// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/flattened.h"

#include <algorithm>

namespace app {
namespace {

Path flattened(const Path& path, double tolerance)
{
    std::vector<Subpath> subpaths = path.subpaths();
    std::vector<Chord> chords;
    for (Subpath& subpath : subpaths) {
        if (std::ranges::none_of(subpath.segments, &PathSegment::curved))
            continue;
        chords.clear();
        flatten(subpath, tolerance, chords);
        const std::size_t segments = subpath.segments.size();
        subpath.segments.clear();
        for (const Chord& chord : chords)
            if (chord.pathSegment < segments) // the closing line stays implicit
                subpath.segments.push_back({chord.segment.b});
    }
    return Path(subpaths);
}

} // namespace

Document flattened(Document document, double tolerance)
{
    const Objects& all = document.objects();
    Edit edit;
    edit.objects = all.slice(0, 0);
    all.forEach(0, all.size(), [&](std::size_t i, const ObjectView& object) {
        if (object.singleLine() || object.path().straight())
            return;
        ObjectRow row = object.row();
        row.path = flattened(row.path, tolerance);
        edit.splices.push_back({std::uint32_t(i), 1, 1});
        edit.objects.append(row);
    });
    document.apply(edit);
    return document;
}

} // namespace app
