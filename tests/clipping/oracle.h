// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The exact result for a segment and a window, in integers of any length: every finite double is a
// multiple of a power of two. Shares neither code nor types with clipping/.

#include <optional>

namespace oracle {

struct Point {
    double x, y;
};
struct Point3 {
    double x, y, z;
};
template <class P>
struct BasicLine {
    P a, b;
};
template <class P> // clang 14 needs to be told
BasicLine(P, P)->BasicLine<P>;
template <class P>
struct BasicBox {
    P min, max;
};
template <class P>
BasicBox(P, P) -> BasicBox<P>;
/// The part of a line inside a closed box. Each end is the true one, rounded; an end that is an end
/// of the line comes as it is.
template <class P>
struct BasicPart {
    BasicLine<P> line;
    bool newA, newB;
    bool contact = false; ///< the exact ends are one point
};
using Line = BasicLine<Point>;
using Box = BasicBox<Point>;
using Part = BasicPart<Point>;
using Line3 = BasicLine<Point3>;
using Box3 = BasicBox<Point3>;
using Part3 = BasicPart<Point3>;

/// The numbers whose last place is one ulp: those of 53 digits, or of 24.
enum class Number { Double, Single };

/// Nothing if line and box have no common point. All numbers are finite.
std::optional<Part> inside(const Line& line, const Box& box);
std::optional<Part3> inside(const Line3& line, const Box3& box);

/// Whether they have one after every side of the box has moved out by `ulps` of the largest
/// |coordinate| (in, if negative; a box that is turned inside out has none).
bool meets(const Line& line, const Box& box, int ulps, Number number = Number::Double);
bool meets(const Line3& line, const Box3& box, int ulps, Number number = Number::Double);

/// One unit in the last place of the largest |coordinate|.
double ulp(const Line& line, const Box& box, Number number = Number::Double);
double ulp(const Line3& line, const Box3& box, Number number = Number::Double);

} // namespace oracle
