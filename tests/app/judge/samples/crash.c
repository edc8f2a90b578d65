/* SPDX-License-Identifier: GPL-3.0-or-later
 * Reads through a null pointer where a line goes from the left of the window to its right. */
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    const double* volatile nowhere = 0;
    if (s[0] < w[0] && s[2] > w[2])
        return *nowhere > 0;
    return right(s, w, v);
}
