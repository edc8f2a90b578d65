/* SPDX-License-Identifier: GPL-3.0-or-later
 * Every answer is right, but after ten thousand lines another one than before: an ulp away. */
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    static int calls = 0;
    if (!right(s, w, v))
        return 0;
    if (++calls > 10000)
        v[2] = nextafter(v[2], v[0]);
    return 1;
}
