/* SPDX-License-Identifier: MIT
 * A frame for your own algorithm: it compiles, and keeps no line yet. Fill in clearcut_clip, then
 *   cc -std=c99 -O2 -shared -fPIC -o skeleton.so skeleton.c -lm && clearcut judge ./skeleton.so
 *
 * What clearcut_clip is held to (clearcut_algorithm.h says all of it):
 * - Input. segment: x1, y1, x2, y2. window: xmin, ymin, xmax, ymax. Read them, never write them.
 * - Something is visible: write the part of the segment inside the closed window to visible, as
 *   x1, y1, x2, y2, from the segment's first end to its second, and return 1. The edges belong to
 *   the window: a line that only touches a corner is visible, as a segment of length 0.
 * - Nothing is visible: return 0. What you wrote to visible then does not matter.
 * - An infinite number or a NaN anywhere, xmin > xmax or ymin > ymax: return 0.
 * - xmin == xmax, ymin == ymax, and a segment whose two ends are one point are legal.
 * - An end that is inside comes back as it is; a cut end may be off by rounding (64 ulps of the
 *   largest coordinate).
 * - Keep nothing between calls: the same question is asked again, and the answer must be the same.
 */
#include "clearcut_algorithm.h"

#include <math.h>

CLEARCUT_ALGORITHM("My algorithm") /* what the verdict calls it */

int clearcut_clip(const double segment[4], const double window[4], double visible[4])
{
    /* 1. Refuse what makes no sense: complete this check. */
    for (int i = 0; i < 4; ++i)
        if (!isfinite(segment[i]) || !isfinite(window[i]))
            return 0;

    /* 2. Which part of the segment lies inside? Your algorithm goes here. */
    (void)visible;

    /* 3. Write its two ends to visible[0] to visible[3], and return 1. */
    return 0;
}
