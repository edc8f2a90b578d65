// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/along.h"

namespace clipping {

/// What a box leaves of a segment: from `start` to `stop` (0 at a, 1 at b), and the sides that cut
/// it there.
template <class T>
struct Part {
    T start, stop;
    Edge startSide = Edge::None, stopSide = Edge::None;
};

/// The ends of a part of `s`; d is b - a. A single common point is the same at both ends.
template <class T>
constexpr BasicSegment<T, 3> endsOf(const Part<T>& part, const BasicSegment<T, 3>& s,
                                    const glm::vec<3, T>& d, const BasicWindow<T, 3>& w)
{
    const auto end = [&](const glm::vec<3, T>& given, T t, Edge side) {
        return side == Edge::None ? clamped(given, w) : along<Form::Corrected>(s, d, t, side, w);
    };
    const auto b = end(s.b, part.stop, part.stopSide);
    const bool touch =
        part.startSide != Edge::None && part.stopSide != Edge::None && part.start == part.stop;
    return {touch ? b : end(s.a, part.start, part.startSide), b};
}

} // namespace clipping
