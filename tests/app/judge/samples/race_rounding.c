/* SPDX-License-Identifier: GPL-3.0-or-later
 * Right everywhere; but in the race, which it tells by lines that lie one behind the other, ends
 * are off by 16 to 32 ulps of the largest coordinate. */
#include <math.h>
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    static const double* last = 0;
    const int race = last != 0 && s == last + 4;
    double most = 0;
    last = s;
    if (!right(s, w, v))
        return 0;
    for (int i = 0; i < 4; ++i)
        most = fmax(most, fmax(fabs(s[i]), fabs(w[i])));
    if (race)
        v[0] += most * 0x1p-48;
    return 1;
}
