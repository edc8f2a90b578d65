// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/walk.h"

namespace app {

/// A place where the line was cut.
struct CutPoint {
    Point at;
    int end = 1;                                ///< which end came there: 1 or 2
    clipping::Edge edge = clipping::Edge::None; ///< None: of no edge, as with wrong cuts
    std::size_t step = 0;                       ///< index of the moment
    bool stands = true;                         ///< false: the same end was cut again later
};

/// What a step shows, in the drawing's coordinates.
struct StepScene {
    enum class State : std::uint8_t { Working, Accepted, Rejected };
    State state = State::Working;
    clipping::Segment left{};                 ///< not if it is rejected
    std::vector<clipping::Segment> discarded; ///< by earlier steps
    std::vector<clipping::Segment> discardedNow;
    std::vector<CutPoint> cuts{}; ///< until now, in their order
    std::optional<Point> candidate{};
    clipping::Edge edge = clipping::Edge::None; ///< what this step is about
    std::size_t step = 0;

    bool isNow(const CutPoint& cut) const { return cut.step == step; }
};

/// Of a walk without moments or a step that it does not have: the line as it was given.
StepScene stepScene(const Specimen& specimen, const Walk& walk, std::size_t step);

} // namespace app
