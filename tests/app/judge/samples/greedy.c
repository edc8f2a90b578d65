/* SPDX-License-Identifier: GPL-3.0-or-later
 * Takes memory for every line and never gives it back. */
#include <stdlib.h>
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    volatile char* room = malloc(1 << 20);
    for (int i = 0; i < 1 << 20; i += 4096)
        room[i] = 1;
    return right(s, w, v);
}
