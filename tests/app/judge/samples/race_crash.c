/* SPDX-License-Identifier: GPL-3.0-or-later
 * Right when asked; crashes in the race, which it tells by lines that lie one behind the other. */
#include <stdlib.h>
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    static const double* last = 0;
    if (last != 0 && s == last + 4)
        abort();
    last = s;
    return right(s, w, v);
}
