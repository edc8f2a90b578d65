// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The truth about a segment and a window, in whole numbers of any length: every finite double is a
// whole number of some power of two. Shares no code with clipping/, nor its types.

#include <optional>

namespace oracle {

struct Point {
    double x, y;
};
struct Line {
    Point a, b;
};
struct Box {
    Point min, max;
};

/// The part of a line inside a closed box. Each end is the true one, rounded; an end that is an end
/// of the line comes as it is.
struct Part {
    Line line;
    bool newA, newB;
};

/// Nothing if line and box have no common point. All numbers are finite.
std::optional<Part> inside(const Line& line, const Box& box);

/// Whether they have one after every side of the box has moved out by `ulps` of the largest
/// |coordinate| (in, if negative; a box that is turned inside out has none).
bool meets(const Line& line, const Box& box, int ulps);

/// One unit in the last place of the largest |coordinate|.
double ulp(const Line& line, const Box& box);

} // namespace oracle
