/* SPDX-License-Identifier: GPL-3.0-or-later
 * Never ends where both ends are to the left of the window: nothing is cut, again and again. */
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    volatile double x = s[0];
    while (x < w[0] && s[2] < w[0])
        x = s[0];
    return right(s, w, v);
}
