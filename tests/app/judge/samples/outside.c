/* SPDX-License-Identifier: GPL-3.0-or-later
 * Forgets the upper edge for the second end. */
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    if (!right(s, w, v))
        return 0;
    v[2] = s[2];
    v[3] = s[3];
    return 1;
}
