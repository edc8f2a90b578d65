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

/// The window as centre and half size, the latter rounded up, for the first test of a whole block
/// of segments. A segment whose line misses that box misses the window.
template <class T>
struct Box {
    BasicWindow<T> window;
    T centreX, centreY, halfWidth, halfHeight;
};
template <class T>
Box<T> boxOf(const BasicWindow<T>& window);

/// Whether anything can be visible in this window: finite, and min <= max.
template <class T>
bool canShow(const BasicWindow<T>& window);

/// The line through a and b misses the box if |m x d| > hw |dy| + hh |dx|, where d = b - a and m =
/// a - centre. Computed, |m x d| is off by less than 5u(|mx dy| + |my dx|) (u, half the epsilon:
/// three for a product, one for the difference, squares), the right side by less than 4u of itself,
/// by 2^-1073 (2^-147 in float) more where a product underflows. 8u of all three terms allows for
/// the rounding of the bound. Infinities and NaNs never miss.
template <class T>
constexpr T missBound = std::numeric_limits<T>::epsilon() * 4;
template <class T>
constexpr T missTiny = std::numeric_limits<T>::min() * 4096;

/// Number of segments in a block, which is first tested for rejection and then clipped: 16 KiB of
/// doubles, half an L1 cache.
constexpr std::size_t blockSize = 512;

} // namespace clipping
