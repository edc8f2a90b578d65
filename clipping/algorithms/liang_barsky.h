// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/part.h"

namespace clipping {

/// Cuts a part at one edge, like Liang and Barsky's `clipt`, and records the edge. p is
/// the rate at which the segment moves outwards across the edge (p < 0: it enters), q the signed
/// distance of a from the edge (q < 0: a is outside). Returns false if nothing is visible. `call`
/// is the label of the call.
template <class T, class Step>
constexpr bool clipt(T p, T q, Part<T>& part, std::string_view call, Edge edge, Step& step)
{
    step.set("p", p), step.let(call, "q", q, edge);
    if (step.test("entering", p < T(0), edge)) {
        const T r = step.let("entry", "r", q / p, edge);
        if (step.test("tooLate", r > part.stop, edge)) {
            step.reject("tooLate");
            return false;
        }
        // Here and below selected, because the branches could not be predicted.
        const bool later = step.test("later", r > part.start, edge);
        part.start = later ? step.let("start", "u0", r, edge) : part.start;
        part.startEdge = later ? edge : part.startEdge;
    } else if (step.test("leaving", p > T(0), edge)) {
        const T r = step.let("exit", "r", q / p, edge);
        if (step.test("tooEarly", r < part.start, edge)) {
            step.reject("tooEarly");
            return false;
        }
        const bool sooner = step.test("sooner", r < part.stop, edge);
        part.stop = sooner ? step.let("stop", "u1", r, edge) : part.stop;
        part.stopEdge = sooner ? edge : part.stopEdge;
    } else if (step.test("beside", q < T(0), edge)) {
        step.reject("beside");
        return false;
    }
    return true;
}

} // namespace clipping
