// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/box_index.h"
#include "app/document/flatten.h"
#include "clipping/region/region.h"

#include <optional>
#include <stop_token>

namespace app {

/// Areas that lie on one another, and what each leaves visible below it.
///
/// Where a line enters and leaves an area is decided exactly, and the ends are rounded once
/// (clipping/region/region.h). As rounding never changes their order along the line, the union of
/// what several areas cover is exact, too, except for gaps that round to a point.
class Covering {
public:
    /// Bottom to top. When a stop is requested, nothing is covered from then on.
    explicit Covering(std::vector<clipping::Area> areas, const std::stop_token& stop = {});

    /// The pieces of the chords that are in none of the areas from number `first` on, which include
    /// their borders. `source` is the chord's index. Valid until the next call.
    std::span<const clipping::Clipped> visible(std::span<const Chord> chords, std::size_t first);

private:
    /// The covered part of a chord.
    struct Covered {
        std::uint32_t chord;
        Point from, to;
    };

    void coverBy(std::uint32_t area, std::span<const Chord> chords);
    void take(const clipping::RegionPiece& piece, std::span<const Chord> chords);
    void addVisible(std::uint32_t chord, const clipping::Segment& line,
                    std::span<const Covered> covered);
    const clipping::PreparedRegion& prepared(std::uint32_t area);

    std::vector<clipping::Area> areas_;
    std::stop_token stop_;
    std::vector<clipping::Window> boxes_;
    std::vector<std::optional<clipping::PreparedRegion>> prepared_; ///< those asked for
    BoxIndex index_;

    std::vector<std::uint32_t> above_; ///< areas that may cover something
    std::vector<std::uint32_t> open_;  ///< chords that are not wholly covered
    std::vector<clipping::Window> chordBoxes_;
    std::vector<bool> gone_;           ///< for each chord, whether it is wholly covered
    std::vector<std::uint32_t> asked_; ///< the chords near the current area
    std::vector<clipping::Segment> lines_;
    std::vector<clipping::RegionPiece> pieces_;
    std::vector<Covered> covered_;
    std::vector<clipping::Clipped> visible_;
};

} // namespace app
