/* SPDX-License-Identifier: GPL-3.0-or-later
 * Ends the program where a line is vertical. */
#include <stdlib.h>
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    if (s[0] == s[2])
        exit(7);
    return right(s, w, v);
}
