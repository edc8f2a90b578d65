// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/clamped.h"

namespace clipping {

/// An end that moves along its segment from one side of a box to another. Each move starts from the
/// given end, so that rounding errors do not accumulate. Whether the end is beyond a side is
/// decided by the distance moved, which is accurate, not by the rounded position.
template <class T>
class MovingEnd {
public:
    /// `d` is b - a of the segment, for both its ends.
    constexpr MovingEnd(const glm::vec<3, T>& given, const glm::vec<3, T>& d,
                        const BasicWindow<T, 3>& w)
        : given_(given), at_(given), d_(d), w_(w)
    {
    }

    /// The side it moved to last; Edge::NoEdge if it has not moved.
    constexpr Edge side() const { return side_; }
    constexpr bool isBelow(glm::length_t axis) const
    {
        return way_[axis] < w_.min[axis] - given_[axis];
    }
    constexpr bool isAbove(glm::length_t axis) const
    {
        return way_[axis] > w_.max[axis] - given_[axis];
    }
    constexpr bool isOn(Edge side) const
    {
        return way_[axisOf(side)] == levelOf(side, w_) - given_[axisOf(side)];
    }

    /// Moves the end to a side; the segment must not be parallel to it.
    constexpr void moveTo(Edge side)
    {
        const glm::length_t axis = axisOf(side);
        const T across = levelOf(side, w_) - given_[axis];
        for (glm::length_t k = 0; k < 3; ++k) {
            way_[k] = k == axis ? across : d_[k] * across / d_[axis];
            at_[k] = k == axis ? levelOf(side, w_) : given_[k] + way_[k];
        }
        side_ = side;
    }

    /// The current position, rounded.
    constexpr const glm::vec<3, T>& at() const { return at_; }
    /// The current position, clamped to the box.
    constexpr glm::vec<3, T> held() const { return clampedAlong(side_, at_, w_); }

private:
    glm::vec<3, T> given_, at_, way_{T(0), T(0), T(0)};
    const glm::vec<3, T>& d_;
    const BasicWindow<T, 3>& w_;
    Edge side_ = Edge::NoEdge;
};

/// The segment between two ends. A contact with the box has the same point at both ends.
template <class T>
constexpr BasicSegment<T, 3> between(const MovingEnd<T>& a, const MovingEnd<T>& b)
{
    const bool touch = a.side() != Edge::NoEdge && b.side() != Edge::NoEdge && a.isOn(b.side());
    const glm::vec<3, T> end = b.held();
    return {touch ? end : a.held(), end};
}

} // namespace clipping
