/* SPDX-License-Identifier: GPL-3.0-or-later
 * Right, and slow: counts to five thousand for every line. */
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    volatile int count = 0;
    while (count < 5000)
        count = count + 1;
    return right(s, w, v);
}
