/* SPDX-License-Identifier: GPL-3.0-or-later
 * Right, and writes a fifth number where there is room for four. */
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    double* volatile beyond = v + 4;
    *beyond = 1;
    return right(s, w, v);
}
