/* SPDX-License-Identifier: MIT
 * A skeleton for your own algorithm: it compiles, but rejects every line. Fill in clearcut_clip:
 *   cc -std=c99 -O2 -shared -fPIC -o skeleton.so skeleton.c -lm && clearcut judge ./skeleton.so
 *
 * What clearcut_clip must do (clearcut_algorithm.h has the whole contract):
 * - Input. segment: x1, y1, x2, y2. window: xmin, ymin, xmax, ymax. Read them, never write them.
 * - Something is visible: write the part of the segment inside the closed window to visible, as
 *   x1, y1, x2, y2, from the segment's first end to its second, and return 1. The edges belong to
 *   the window: a line that only touches a corner is visible, as a segment of length 0.
 * - Nothing is visible: return 0. What you wrote to visible then does not matter.
 * - An infinite number or a NaN anywhere, xmin > xmax or ymin > ymax: return 0.
 * - xmin == xmax, ymin == ymax, and a segment whose two ends are one point are legal.
 * - An end that is inside is returned unchanged; a cut end may be off by rounding (64 ulps of the
 *   largest coordinate).
 * - Keep nothing between calls: the same input must always give the same result.
 */
#include "clearcut_algorithm.h"

#include <math.h>

CLEARCUT_ALGORITHM("My algorithm") /* its name in the verdict */

int clearcut_clip(const double segment[4], const double window[4], double visible[4])
{
    /* 1. Return 0 for invalid input: complete this check. */
    for (int i = 0; i < 4; ++i)
        if (!isfinite(segment[i]) || !isfinite(window[i]))
            return 0;

    /* 2. Which part of the segment lies inside? Your algorithm goes here. */
    (void)visible;

    /* 3. Write its two ends to visible[0] to visible[3], and return 1. */
    return 0;
}
