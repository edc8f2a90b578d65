// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/path_storage.h"

#include <algorithm>
#include <iterator>

namespace app {

void flatten(const Path& path, double tolerance, std::vector<Chord>& chords)
{
    if (path.isLine())
        chords.push_back({{path.ends_[0], path.ends_[1]}, 0, 0, 1});
    if (!path.data_ || path.isLine())
        return;
    Subpath subpath;
    for (Path::Data::Reader reader(*path.data_, path.placement()); !reader.atEnd();) {
        reader.next(subpath);
        flatten(subpath, tolerance, chords);
    }
}

void appendSegments(const Path& path, double tolerance, std::vector<clipping::Segment>& to)
{
    if (path.isLine())
        to.push_back({path.ends_[0], path.ends_[1]});
    if (!path.data_ || path.isLine())
        return;
    if (!path.straight()) {
        std::vector<Chord> chords;
        flatten(path, tolerance, chords);
        std::ranges::transform(chords, std::back_inserter(to), &Chord::segment);
        return;
    }
    const Placement where = path.placement();
    const Point* point = path.data_->firstPoint();
    for (const std::uint32_t size : path.data_->sizes()) {
        const Point start = where(*point++);
        Point last = start;
        for (std::uint32_t left = size >> 1; left > 0; --left) {
            const Point next = where(*point++);
            to.push_back({last, next});
            last = next;
        }
        if (size >> 1 == 0 || ((size & 1) && last != start)) // as flatten closes a subpath
            to.push_back({last, start});
    }
}

} // namespace app
