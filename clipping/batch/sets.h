// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/batch/kernels.h"

#include <limits>

// Declarations shared by the files of this folder.

namespace clipping {

/// One row for each file of kernels; without functions where the compiler lacks the instructions.
extern const InstructionSet portableSet, avx2Set, avx512Set;

/// Clips the segments at the given indices one by one: those that kernels cannot settle, or that
/// are too few for a vector. Writes the visible pieces to `out` and returns their number.
template <class T>
std::size_t clipOneByOne(const BasicSegment<T>* segments, const std::uint32_t* indices,
                         std::size_t count, const BasicWindow<T>& window,
                         BasicClipped<BasicSegment<T>>* out);

std::size_t clipOneByOne(const Segment* segments, const std::uint32_t* indices, std::size_t count,
                         const PreparedPolygon& polygon, Clipped* out);

/// The window as centre and half size, the latter rounded up, and the numbers of the first test of
/// a whole block of segments (missFactor).
template <class T>
struct Box {
    T centreX, centreY, halfWidth, halfHeight;
    T twiceX, twiceY; ///< twice the centre
    T width, height;  ///< twice the half size and more; infinite for a huge window
};
template <class T>
Box<T> boxOf(const BasicWindow<T>& window);

/// Whether anything can be visible in this window: finite, and min <= max.
template <class T>
bool canShow(const BasicWindow<T>& window);

/// The first test, by separating axes. All is doubled: let d = b - a, m = a + b - c with twice the
/// centre c, and H the box's size. A segment misses the box if |mx| > Hx + |dx|, or the same in y,
/// or if |mx dy - my dx| > Hx |dy| + Hy |dx|. With u, half the epsilon, d is computed within u |d|,
/// and m within 2.2 u |m| + 1.2 u |c|, because |a + b| <= |m| + |c|.
///
/// The first holds if |mx| - (1 + 8u) |dx| > K, for K >= (1 + 16u) Hx + 2u |cx| (`width`): 1.2 u
/// |cx| and less than 4u of each other term are needed. The cross product is off by less than 4.3 u
/// of each product, u of itself, and 1.3 u (|cx dy| + |cy dx|). With |my dx| <= |p| + |cross|, p =
/// mx dy, it decides if |cross| > 16u |p| + Kx |dy| + Ky |dx|: 8.7 u |p|, 5.4 u |cross| and 2u of
/// the right side are needed, and rounding the right side takes 5u of it. The bounds hold with
/// fused operations and without. `missTiny` is more than all products lose by underflow; sums lose
/// nothing.
///
/// Overflow: only a + b can become infinite where m must not, and then both ends are beyond a
/// window whose numbers are below `mostMissed`; K is infinite for others. All other infinities and
/// NaNs of finite segments make the right side infinite or NaN, which leaves the segment to the
/// second pass; only my dx does not. Fused, the cross product is then infinite because it is larger
/// than any right side; otherwise an infinite one decides nothing (`notAbove` in portable.cpp).
template <class T>
constexpr T missFactor = std::numeric_limits<T>::epsilon() * 8;
template <class T>
constexpr T missLength = 1 + std::numeric_limits<T>::epsilon() * 4;
template <class T>
constexpr T missTiny = std::numeric_limits<T>::min() * 4096;
template <class T>
constexpr T mostMissed = std::numeric_limits<T>::max() * std::numeric_limits<T>::epsilon()
                         * std::numeric_limits<T>::epsilon();

/// Number of segments in a block, which is first tested for rejection and then clipped: 16 KiB of
/// doubles, half an L1 cache.
constexpr std::size_t blockSize = 512;

} // namespace clipping
