/* SPDX-License-Identifier: MIT
 *
 * Your own line-clipping algorithm, judged and raced by Clearcut. Plain C99, and C++.
 *
 * Write clearcut_clip, compile it to a shared library, and give that to
 *     clearcut judge ./mine.so          or to the menu Compare > Judge your own algorithm.
 * skeleton.c is a file to fill in, example.c a finished algorithm.
 *
 * The contract:
 * 1. It returns 1 and writes the part of the segment inside the closed window to visible, from the
 *    segment's first end to its second; or it returns 0 if there is none. The edges belong to the
 *    window: one common point is visible, as a segment of length 0.
 * 2. If any number is infinite or a NaN, or if xmin > xmax or ymin > ymax, it returns 0.
 *    Windows without width or height (xmin == xmax, ymin == ymax) and points are legal.
 * 3. Ends may be off by 64 ulps (units in the last place of a double) of the largest |coordinate|
 *    of segment and window. Visibility may be wrong only within that distance of an edge, and
 *    never if all numbers are small integers.
 * 4. It ends, it keeps nothing between calls (the same input gives the same result, bit for bit,
 *    also in the race), and it writes only to visible[0] to [3].
 */
#ifndef CLEARCUT_ALGORITHM_H
#define CLEARCUT_ALGORITHM_H

#define CLEARCUT_ABI_VERSION 1

#ifdef __cplusplus
#define CLEARCUT_EXPORT extern "C" __attribute__((visibility("default")))
#else
#define CLEARCUT_EXPORT __attribute__((visibility("default")))
#endif

/* The one function that you write.
 *   segment: x1, y1, x2, y2      window: xmin, ymin, xmax, ymax      visible: x1, y1, x2, y2 */
CLEARCUT_EXPORT int clearcut_clip(const double segment[4], const double window[4],
                                  double visible[4]);

/* Optional, once in your file: the algorithm's name, and the version of this header that it uses.
 *   CLEARCUT_ALGORITHM("My Liang-Barsky") */
#define CLEARCUT_ALGORITHM(name)                                                                   \
    CLEARCUT_EXPORT int clearcut_abi_version(void);                                                \
    CLEARCUT_EXPORT const char* clearcut_name(void);                                               \
    int clearcut_abi_version(void) { return CLEARCUT_ABI_VERSION; }                                \
    const char* clearcut_name(void) { return name; }

#endif
