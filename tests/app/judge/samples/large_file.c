/* SPDX-License-Identifier: GPL-3.0-or-later
 * Keeps a diary of more than the file that it may write. */
#include <stdio.h>
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    static char page[1 << 16];
    FILE* diary = tmpfile();
    for (int i = 0; diary && i < 100; ++i)
        fwrite(page, sizeof page, 1, diary);
    if (diary)
        fclose(diary);
    return right(s, w, v);
}
