/* SPDX-License-Identifier: GPL-3.0-or-later
 * Cohen-Sutherland as textbooks have it, with at most four cuts, so that it ends; infinite numbers
 * and NaN are not thought of. */
#include "resources/plug_in/clearcut_algorithm.h"

CLEARCUT_ALGORITHM("Cohen-Sutherland for finite numbers")

enum { LEFT = 1, RIGHT = 2, BELOW = 4, ABOVE = 8 };

static int outcode(const double* p, const double w[4])
{
    return (p[0] < w[0]   ? LEFT
            : p[0] > w[2] ? RIGHT
                          : 0)
           | (p[1] < w[1]   ? BELOW
              : p[1] > w[3] ? ABOVE
                            : 0);
}

int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    if (w[0] > w[2] || w[1] > w[3])
        return 0;
    for (int i = 0; i < 4; ++i)
        v[i] = s[i];
    for (int cuts = 0; cuts < 4; ++cuts) {
        const int code0 = outcode(v, w), code1 = outcode(v + 2, w);
        if ((code0 & code1) != 0)
            return 0;
        if ((code0 | code1) == 0)
            return 1;
        const int code = code0 != 0 ? code0 : code1;
        const double dx = v[2] - v[0], dy = v[3] - v[1];
        double* end = code == code0 ? v : v + 2;
        if (code & (ABOVE | BELOW)) {
            const double y = code & ABOVE ? w[3] : w[1];
            end[0] = v[0] + dx * (y - v[1]) / dy;
            end[1] = y;
        } else {
            const double x = code & RIGHT ? w[2] : w[0];
            end[1] = v[1] + dy * (x - v[0]) / dx;
            end[0] = x;
        }
    }
    return 1;
}
