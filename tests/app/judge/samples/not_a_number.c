/* SPDX-License-Identifier: GPL-3.0-or-later
 * Divides 0 by 0 where a line is vertical. */
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    if (!right(s, w, v))
        return 0;
    if (s[0] == s[2])
        v[1] += (s[2] - s[0]) / (s[2] - s[0]);
    return 1;
}
