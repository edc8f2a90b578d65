/* SPDX-License-Identifier: GPL-3.0-or-later
 * Right, and writes a line to standard output for every call, as one does to look for a fault. */
#include <stdio.h>
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    printf("clipping %g %g %g %g\n", s[0], s[1], s[2], s[3]);
    return right(s, w, v);
}
