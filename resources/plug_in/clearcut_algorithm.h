/* SPDX-License-Identifier: MIT
 *
 * Your own line-clipping algorithm, judged and raced by Clearcut. Plain C99, and C++.
 *
 * Write clearcut_clip, compile it to a shared library, and give that to
 *     clearcut judge ./mine.so          or to the menu Learn > Judge your own algorithm.
 * skeleton.c is a frame to fill in, example.c a finished algorithm.
 *
 * It is held to this:
 * 1. It returns 1 and writes the part of the segment inside the closed window to visible, from the
 *    segment's first end to its second; or it returns 0 if there is none. The edges belong to the
 *    window: one common point is visible, as a segment of length 0.
 * 2. A number that is infinite or not a number, anywhere, or a window with xmin > xmax or
 *    ymin > ymax: it returns 0. Zero-size windows (xmin == xmax) and points are legal.
 * 3. Ends may be off by 64 ulps (units in the last place of a double) of the largest |coordinate|
 *    of segment and window. What is visible may be wrong only so near to an edge, and not at all
 *    where all numbers are small and whole.
 * 4. It ends, it keeps nothing between calls (the same question has the same answer, bit for bit,
 *    also in the race), and it writes nowhere but to visible[0] to [3].
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

/* Optional, once in your file: what it is called, and which version of this header it was made for.
 *   CLEARCUT_ALGORITHM("My Liang-Barsky") */
#define CLEARCUT_ALGORITHM(name)                                                                   \
    CLEARCUT_EXPORT int clearcut_abi_version(void);                                                \
    CLEARCUT_EXPORT const char *clearcut_name(void);                                               \
    int clearcut_abi_version(void) { return CLEARCUT_ABI_VERSION; }                                \
    const char *clearcut_name(void) { return name; }

#endif
