/* SPDX-License-Identifier: GPL-3.0-or-later
 * Right but for one thing: a line that only touches a corner is dropped. */
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    if (!right(s, w, v))
        return 0;
    const int point = v[0] == v[2] && v[1] == v[3];
    const int corner = (v[0] == w[0] || v[0] == w[2]) && (v[1] == w[1] || v[1] == w[3]);
    return !(point && corner && !(s[0] == s[2] && s[1] == s[3]));
}
