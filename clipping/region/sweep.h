// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/meeting.h"
#include "clipping/region/prepared.h"

namespace clipping {

/// Finds the kept pieces of segments that may meet edges.
///
/// It walks along the segment on both sides of its line, infinitely near, and keeps each area's
/// winding number on either side. So vertices on the line and edges along it need no special cases:
/// an interval is in an area if either side is filled. Keeps its memory from one segment to the
/// next.
class LineSweep {
public:
    explicit LineSweep(const PreparedRegion::Data& region);

    /// The kept pieces of a finite segment whose bounding box meets that of the region. Valid until
    /// the next call.
    std::span<const RegionPiece> piecesOf(const Segment& segment, std::uint32_t source);

private:
    /// An end of a piece.
    struct Cut {
        glm::dvec2 at;
        std::uint32_t edge;
    };

    bool findMeetings(const SweptLine& swept);
    void sortMeetings(const SweptLine& swept);
    void enterAt(const SweptLine& swept);
    void leave();
    void walk(const SweptLine& swept, std::uint32_t source);
    std::uint32_t pass(std::span<const Meeting> meetings);
    bool keepsPoint(std::span<const Meeting> meetings) const;
    bool keeps() const { return region_.fold.keeps(state_); }
    void turn(std::uint32_t step, int left, int right);
    void update(std::uint32_t step);
    void append(const Cut& from, const Cut& to, std::uint32_t source)
    {
        pieces_.push_back({{from.at, to.at}, source, from.edge, to.edge});
    }

    /// Where the sweep is, relative to one area.
    struct Beside {
        int left = 0, right = 0; ///< winding numbers on both sides of the line
        bool isIn = false, isTouched = false;
    };
    const PreparedRegion::Data& region_;
    std::vector<Beside> beside_;         ///< of each step
    std::vector<std::uint32_t> touched_; ///< the steps for which this is not the default
    RegionFold::Words state_;
    std::vector<Meeting> atStart_, between_, atEnd_;
    std::vector<RegionPiece> pieces_;
};

} // namespace clipping
