/* SPDX-License-Identifier: GPL-3.0-or-later
 * Keeps the end itself of what passes a corner at a distance. */
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    if (right(s, w, v))
        return 1;
    for (int i = 0; i < 4; ++i) {
        if (!isfinite(s[i]) || !isfinite(w[i]) || w[0] > w[2] || w[1] > w[3])
            return 0;
        v[i] = w[i % 2];
    }
    return (s[0] < w[0]) != (s[2] < w[0]);
}
