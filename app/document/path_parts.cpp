// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/path_storage.h"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace app {

std::optional<Path::Parts> Path::parts() const
{
    if (!data_ || isLine())
        return std::nullopt;
    return Parts{placement(), data_->points(), data_->sizes(), data_->kinds()};
}

std::optional<Path> Path::of(const Parts& parts)
{
    const auto& [placement, points, sizes, kinds] = parts;
    std::uint64_t segments = 0, curves = 0;
    for (const std::uint32_t size : sizes)
        segments += size >> 1;
    for (const std::uint8_t kind : kinds)
        curves += kind;
    const bool fit = !sizes.empty() && points.size() < (std::size_t(1) << 31)
                     && points.size() == sizes.size() + segments + 2 * curves
                     && (kinds.empty() ? curves == 0 : kinds.size() == segments && curves > 0)
                     && std::ranges::all_of(kinds, [](std::uint8_t kind) { return kind <= 1; });
    if (!fit)
        return std::nullopt;
    Path path;
    path.data_ = Data::of(points.size(), sizes.size(), kinds.size());
    path.ends_ = {placement.scale, placement.offset};
    std::ranges::copy(points, path.data_->firstPoint());
    std::ranges::copy(sizes, path.data_->firstSize());
    std::ranges::copy(kinds, path.data_->firstKind());
    return path;
}

Path Path::withPlacement(const Placement& placement) const
{
    assert(data_ && !isLine());
    Path path = *this;
    path.ends_ = {placement.scale, placement.offset};
    return path;
}

// Appends the chords of each path segment in turn; calls `added` after each segment.
static void appendChords(auto reader, double tolerance, std::vector<Chord>& chords,
                         const auto& added)
{
    while (!reader.atEnd()) {
        const auto [start, segments, closed] = reader.start();
        Point last = start;
        for (std::uint32_t i = 0; i < segments; ++i) {
            const PathSegment segment = reader.segment();
            flatten(last, segment, i, tolerance, chords);
            added();
            last = segment.to;
        }
        if (segments == 0 || (closed && last != start)) { // as flatten closes a subpath
            chords.push_back({{last, start}, segments, 0, 1});
            added();
        }
    }
}

void flatten(const Path& path, double tolerance, std::vector<Chord>& chords)
{
    if (path.isLine())
        chords.push_back({{path.ends_[0], path.ends_[1]}, 0, 0, 1});
    else if (path.data_)
        appendChords(Path::Data::Reader(*path.data_, path.placement()), tolerance, chords, [] {});
}

void appendSegments(const Path& path, double tolerance, std::vector<clipping::Segment>& to)
{
    if (path.isLine())
        to.push_back({path.ends_[0], path.ends_[1]});
    if (!path.data_ || path.isLine())
        return;
    if (!path.straight()) {
        std::vector<Chord> chords; // of one path segment
        appendChords(Path::Data::Reader(*path.data_, path.placement()), tolerance, chords, [&] {
            std::ranges::transform(chords, std::back_inserter(to), &Chord::segment);
            chords.clear();
        });
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
