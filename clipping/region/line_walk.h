// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/meeting.h"
#include "clipping/region/prepared.h"

namespace clipping {

/// The meetings of a segment with edges.
struct Meetings {
    std::vector<Meeting> atStart, between, atEnd;

    void clear() { atStart.clear(), between.clear(), atEnd.clear(); }
    void add(const Meeting& meeting)
    {
        (meeting.place == Meeting::Place::Start ? atStart
         : meeting.place == Meeting::Place::End ? atEnd
                                                : between)
            .push_back(meeting);
    }
    /// Orders them along the segment, those at one point by edge, and removes repeated ones.
    void sort(const SweptLine& swept);
};

/// Walks along a segment on both sides of its line, infinitely near, and keeps each area's winding
/// number on either side. So vertices on the line and edges along it need no special cases: an
/// interval is in an area if either side is filled. Keeps its memory from one segment to the next.
class LineWalk {
public:
    explicit LineWalk(const PreparedRegion::Data& region);

    /// Before the walk, for each area whose winding numbers just after the start are not 0, or in
    /// parts: adds to them.
    void turn(std::uint32_t step, int left, int right);
    /// The kept pieces, from sorted meetings. Valid until the next walk. Forgets the numbers.
    std::span<const RegionPiece> piecesOf(const SweptLine& swept, const Meetings& meetings,
                                          std::uint32_t source);

private:
    /// An end of a piece.
    struct Cut {
        glm::dvec2 at;
        std::uint32_t edge;
    };

    void begin();
    void walk(const SweptLine& swept, const Meetings& meetings, std::uint32_t source);
    void leave();
    std::uint32_t pass(std::span<const Meeting> meetings);
    bool keepsPoint(std::span<const Meeting> meetings) const;
    bool keeps() const { return region_.fold.keeps(state_); }
    void update(std::uint32_t step);
    void append(const Cut& from, const Cut& to, std::uint32_t source)
    {
        pieces_.push_back({{from.at, to.at}, source, from.edge, to.edge});
    }

    /// Where the walk is, relative to one area.
    struct Beside {
        int left = 0, right = 0; ///< winding numbers on both sides of the line
        bool isIn = false, isTouched = false;
    };
    const PreparedRegion::Data& region_;
    std::vector<Beside> beside_;         ///< of each step
    std::vector<std::uint32_t> touched_; ///< the steps for which this is not the default
    RegionFold::Words state_;
    std::vector<RegionPiece> pieces_;
};

} // namespace clipping
