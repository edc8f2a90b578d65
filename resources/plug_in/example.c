/* SPDX-License-Identifier: MIT
 * Liang-Barsky, as a first example. Compile it, and let Clearcut judge and race it:
 *   cc -std=c99 -O2 -shared -fPIC -o example.so example.c && clearcut judge ./example.so
 */
#include "clearcut_algorithm.h"

#include <math.h>

CLEARCUT_ALGORITHM("Liang-Barsky, the example")

int clearcut_clip(const double segment[4], const double window[4], double visible[4])
{
    double enter = 0, leave = 1; /* the visible part, from 0 at the first end to 1 at the second */
    for (int i = 0; i < 4; ++i)
        if (!isfinite(segment[i]) || !isfinite(window[i]))
            return 0;
    for (int axis = 0; axis < 2; ++axis) {
        const double from = segment[axis], low = window[axis], high = window[axis + 2];
        const double length = segment[axis + 2] - from;
        if (low > high || (length == 0 && (from < low || from > high)))
            return 0;
        if (length == 0)
            continue; /* parallel to both edges, and between them */
        enter = fmax(enter, ((length > 0 ? low : high) - from) / length);
        leave = fmin(leave, ((length > 0 ? high : low) - from) / length);
    }
    if (enter > leave)
        return 0;
    for (int i = 0; i < 2; ++i) {
        const double from = segment[i], length = segment[i + 2] - from;
        visible[i] = enter > 0 ? from + enter * length : from;
        visible[i + 2] = leave < 1 ? from + leave * length : segment[i + 2];
    }
    return 1;
}
