// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/traced_line.h"
#include "app/teaching/narration.h"

namespace app {

/// A place where the line was cut.
struct CutPoint {
    Point at;
    int end = 1;                                  ///< the end that was moved there: 1 or 2
    clipping::Edge edge = clipping::Edge::NoEdge; ///< None: not on an edge, as for wrong cuts
    std::size_t polygonEdge = 0;                  ///< of a polygonal window, from 1; 0: none
    std::size_t step = 0;                         ///< index of the step
    bool stands = true;                           ///< false: the same end was cut again later
};

/// The picture of a step, in the drawing's coordinates.
struct StepScene {
    enum class State : std::uint8_t { Working, Accepted, Rejected };
    State state = State::Working;
    clipping::Segment left{};                 ///< what remains; invalid if rejected
    std::vector<clipping::Segment> discarded; ///< by earlier steps
    std::vector<clipping::Segment> discardedNow;
    std::vector<CutPoint> cuts{}; ///< so far, in order
    std::optional<Point> candidate{};
    clipping::Edge edge = clipping::Edge::NoEdge; ///< the edge of this step
    std::size_t polygonEdge = 0; ///< the same of a polygonal window, from 1; 0: none
    std::size_t step = 0;

    bool isNow(const CutPoint& cut) const { return cut.step == step; }
};

/// For a step that the trace does not have: the original line.
StepScene stepScene(const TracedLine& tracedLine, const Narration& narration, std::size_t step);

/// A step of a traced line's trace; the references must outlive the call.
struct TraceStep {
    const TracedLine& tracedLine;
    const Narration& narration;
    std::size_t step;
};

/// The edges of the window of a traced line, rectangle or polygon, one after the other.
std::vector<clipping::Segment> edgesOf(const TracedLine& tracedLine);

} // namespace app
