/* SPDX-License-Identifier: GPL-3.0-or-later
 * Loses lines that begin to the left, crashes on points, and cannot be loaded a second time: the
 * first time it leaves a mark, the file that LOADS_ONCE names. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

__attribute__((constructor)) static void begin(void)
{
    FILE* mark = fopen(getenv("LOADS_ONCE"), "r");
    if (mark)
        abort();
    mark = fopen(getenv("LOADS_ONCE"), "w");
    fclose(mark);
}

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    if (s[0] == s[2] && s[1] == s[3])
        raise(SIGSEGV);
    return s[0] < w[0] ? 0 : right(s, w, v);
}
