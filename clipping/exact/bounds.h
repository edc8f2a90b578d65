// SPDX-License-Identifier: MIT
#pragma once

// Error bounds of the floating-point shortcuts of `exact`, with their proofs. Scalar and vector
// code compares with these bounds and falls back to integer arithmetic where the comparison does
// not decide. e is 2^-53, the largest relative error of one operation in double. Sums and
// differences never underflow; a product loses at most 2^-1075 by underflow. Every comparison is
// written so that infinities and NaNs leave the decision open.

namespace clipping {

/// The order in which a line passes x and y is the sign of p* - q*, with p* = (x - ax)(by - ay) and
/// q* = (y - ay)(bx - ax). Computed, each factor is off by (1 + e) and the product by another,
/// together less than (3e + 4e^2)|p*|, which is at most (3e + 14e^2)|p|; the difference of p and q
/// adds e times itself. So if |p - q| > 3.5 e (|p| + |q|), p - q has the exact sign; 4e allows for
/// the rounding of the bound itself, and `tiny` for underflow (2^-1074 in all).
constexpr double orderBound = 0x1p-51;
constexpr double tiny = 0x1p-1000;

/// The same order, from the part of the segment before each crossing: (x - ax) / (bx - ax) and (y -
/// ay) / (by - ay), each computed as a difference times a reciprocal, with a relative error below
/// 4.1e, or 8.1e if the reciprocal is denormal. Where the order matters, one of the two is at most
/// 1; the other may be larger, but then by far. So a difference of more than 17e decides; 32e
/// allows for its own rounding. Needs denominators that are 0 or normal.
constexpr double parameterBound = 0x1p-48;

/// The y at x is ay + M U / D, with M = by - ay, U = x - ax and D = bx - ax known exactly as pairs
/// (low parts at most e times the high ones). With p = Mh Uh, computed exactly as ph + pe:
///   low  = pe + Mh Ul + Ml Uh              off by  8.1 e^2 |ph|  (7 by rounding, Ml Ul left out)
///   q    = ph / Dh or ph times 1 / Dh      off by  at most 3e |q|
///   rest = (ph - q Dh) + low - q Dl        off by 17 e^2 |ph| more (3, 6, 1 and 7 by rounding)
///   rest / Dh, |rest| at most 7e |ph|      off by 28 e^2 |q|     (Dh for D, quotient)
/// together less than 54 e^2 |q|. The sum s + t of ay + q exactly and rest / Dh adds
/// e^2 |s| + 8 e^2 |q| where t is rounded, and the same again where the error is added to t. All
/// that is below 71 e^2 |q| + 2.1 e^2 |s|: the bound is quotientBound |q| + sumBound |s|, 128 e^2
/// of each. Rounding is monotone: if s + (t - bound) and s + (t + bound) round to the same number,
/// the exact value rounds to it too.
constexpr double quotientBound = 0x1p-99;
template <class T>
inline constexpr double sumBound = 0x1p-99;

/// Where two lines meet (meeting.h): x is ax + dx N / D, with d = b - a, N = (c - a) x f and D = d x
/// f, for the line from c with the extent f. All extents are exact pairs. For a determinant of two
/// extents, p = uxh vyh and q = uyh vxh are computed exactly as pairs; let P = |p| + |q|:
///   lowP = pe + uxh vyl + uxl vyh         off by  8.1 e^2 |p| (7 by rounding, uxl vyl left out)
///   h + l = (p - q) + (lowP - lowQ)       off by  7.4 e^2 P more (3.1 and 4.2 by rounding)
/// together less than 16 e^2 P, with |l| at most e |h| + 3.1 e P. D is then normalised, so that
/// |Dl| is at most e |Dh|; that and 1 / Dh need |Dh| > meetingBound P. The quotient t = th + tl:
///   th   = Nh times 1 / Dh                off by  at most 2.1 e |th|
///   rest = (Nh - th Dh) + (Nl - th Dl)    off by 16 e^2 P of N (2.1, 1, 5.3 and 7.5 by rounding)
///   tl   = rest / Dh, |rest| < 7.5 e P    off by 23.3 e^2 P / |D| (15.8; 7.5 for Dh instead of D)
/// With the errors of N and D, t is off by less than e^2 (56 PN + 17 |t| PD) / |D|. Then, with Q =
/// |dx| PN / |D|:
///   p    = dxh th, exactly as ph + pe
///   low  = pe + dxh tl + dxl th           off by 35 e^2 Q (27 by rounding, dxl tl left out)
/// The sum s + t' of ax + p exactly and low adds e^2 |s| + 9.8 e^2 Q where t' is rounded, and the
/// same again where the error is added to it. All that is below 111 e^2 Q + 17.1 e^2 |p| PD / |D| +
/// 2.1 e^2 |s|: the bound is quotientBound (Q + |p| PD / |D| + |s|), 128 e^2 of each.
///
/// With PN and PD in this range, and a bound of at least smallestMeetingBound, that exceeds any
/// loss by underflow 2^80 times; overflow ends as NaN.
constexpr double meetingBound = 0x1p-50;
constexpr double smallestMeeting = 0x1p-400, largestMeeting = 0x1p400;
constexpr double smallestMeetingBound = 0x1p-990;

/// The same point in vectors (batch/polygon_lanes.h), where 0 < t < 1 is known, at less cost. th is
/// Nh / Dh in double, with |Dh| > steepest PD. The point a + th d is s + l on each axis, with an
/// error of 5 e^2 |p| + e^2 |s| for p = th dx. It misses the edge by R = (c - point) x f. Let Z = PN
/// + PD + reach, with reach >= |sx fy| + |sy fx|: every product below is at most Z.
///   |R| < 6.4 e Z          N off by 4e PN, D by 4e PD, the quotient by 2.1e
///   R computed             off by 71 e^2 Z: 11.3 p - q, 2 rests, 16 + 3 low (sums; left out), 13.3
///                          and 17.3 the last two sums, 8 from s + l and c - s
///   more = R / Dh          off by (26 PD / |D| + 20) e^2 Z / |D| for Dh and the quotient
/// Adding more dx to l, and the error, rounds by 40 e^2 |dx| Z / |D| + 5 e^2 |s|. The bound is
/// (nearBound + steepBound PD / |D|) |dx| Z / |D| + nearSumBound |s|: 256, 64 and 8 e^2. `reach` is
/// taken from the polygon's corners, between which s lies unless th is so far off that the bound
/// leaves two numbers anyway.
constexpr double steepest = 0x1p-40;
constexpr double nearBound = 0x1p-98, steepBound = 0x1p-100, nearSumBound = 0x1p-103;

/// For float that sum is rounded to double and then to float. The bound is larger by two roundings
/// to double, so that the exact value stays between the two sums after the first rounding: 2e of
/// the sum, which is |s| and at most 8e (|q| + |s|) more; that is below 2.1 e |s| + 16 e^2 |q|.
template <>
inline constexpr double sumBound<float> = 0x1p-51;

/// Floats leave so many spare digits in double that pairs are rarely needed: Mh Uh / Dh is off by
/// less than 7e of itself (three differences, product, quotient, squares), ay + q by e more, and
/// the bound is added with another e. Rounding to float afterwards is monotone.
constexpr double singleBound = 0x1p-49;

/// For products and quotients this far from the ends of the range, the bounds above exceed any loss
/// by underflow 2^300 times. (A product that is 0 because M is 0 is exact.)
constexpr double smallestProduct = 0x1p-600, largestProduct = 0x1p600;
constexpr double smallestQuotient = 0x1p-900, largestQuotient = 0x1p900;

} // namespace clipping
