// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/part.h"

namespace clipping {

/// Cuts a part at one edge, like Liang and Barsky's `clipt`, and records the edge. p is
/// the rate at which the segment moves outwards across the edge (p < 0: it enters), q the signed
/// distance of a from the edge (q < 0: a is outside). Returns false if nothing is visible. Steps
/// are lines 1 to 12 of the pseudo-code; `line` is the line of the call.
template <class T, class Step>
constexpr bool clipt(T p, T q, Part<T>& part, int line, Edge edge, Step& step)
{
    step.set("p", p), step.let(line, "q", q, edge);
    if (step.test(2, p < T(0), edge)) {
        const T r = step.let(3, "r", q / p, edge);
        if (step.test(4, r > part.stop, edge)) {
            step.reject(4);
            return false;
        }
        // Here and below selected, because the branches could not be predicted.
        const bool later = step.test(5, r > part.start, edge);
        part.start = later ? step.let(6, "u0", r, edge) : part.start;
        part.startEdge = later ? edge : part.startEdge;
    } else if (step.test(7, p > T(0), edge)) {
        const T r = step.let(8, "r", q / p, edge);
        if (step.test(9, r < part.start, edge)) {
            step.reject(9);
            return false;
        }
        const bool sooner = step.test(10, r < part.stop, edge);
        part.stop = sooner ? step.let(11, "u1", r, edge) : part.stop;
        part.stopEdge = sooner ? edge : part.stopEdge;
    } else if (step.test(12, q < T(0), edge)) {
        step.reject(12);
        return false;
    }
    return true;
}

} // namespace clipping
