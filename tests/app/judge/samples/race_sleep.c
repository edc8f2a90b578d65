/* SPDX-License-Identifier: GPL-3.0-or-later
 * Right when asked; sleeps in the race, which it tells by lines that lie one behind the other, and
 * would drop every line there. */
#define _DEFAULT_SOURCE
#include <unistd.h>
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    static const double* last = 0;
    const int race = last != 0 && s == last + 4;
    last = s;
    if (race)
        sleep(3600);
    return race ? 0 : right(s, w, v);
}
