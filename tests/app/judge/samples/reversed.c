/* SPDX-License-Identifier: GPL-3.0-or-later
 * Turns the piece round where the line goes to the left. */
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    double r[4];
    if (!right(s, w, r))
        return 0;
    const int turned = s[2] < s[0] ? 2 : 0;
    for (int i = 0; i < 4; ++i)
        v[i] = r[(i + turned) % 4];
    return 1;
}
