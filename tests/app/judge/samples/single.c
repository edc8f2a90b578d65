/* SPDX-License-Identifier: GPL-3.0-or-later
 * Calculates with floats: seven digits instead of sixteen. */
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    double rounded[4];
    for (int i = 0; i < 4; ++i)
        rounded[i] = (float)s[i];
    return right(rounded, w, v);
}
