/* SPDX-License-Identifier: MIT
 * Cohen-Sutherland as textbooks print it. It looks right but is wrong: find out where.
 *   cc -std=c99 -O2 -shared -fPIC -o cohen_sutherland.so cohen_sutherland.c
 *   clearcut judge ./cohen_sutherland.so
 * (If rounding puts a new end outside another edge again and again, the loop never ends.)
 */
#include "clearcut_algorithm.h"

#include <math.h>

CLEARCUT_ALGORITHM("Cohen-Sutherland, from a textbook")

enum { LEFT = 1, RIGHT = 2, BELOW = 4, ABOVE = 8 };

static int outcode(double x, double y, const double w[4])
{
    return (x < w[0] ? LEFT : x > w[2] ? RIGHT : 0) | (y < w[1] ? BELOW : y > w[3] ? ABOVE : 0);
}

int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    double x0 = s[0], y0 = s[1], x1 = s[2], y1 = s[3];
    for (int i = 0; i < 4; ++i)
        if (!isfinite(s[i]) || !isfinite(w[i]) || w[i % 2] > w[i % 2 + 2])
            return 0;
    for (;;) {
        const int code0 = outcode(x0, y0, w), code1 = outcode(x1, y1, w);
        if ((code0 & code1) != 0)
            return 0;
        if ((code0 | code1) == 0)
            break;
        const int code = code0 != 0 ? code0 : code1;
        double x, y;
        if (code & (ABOVE | BELOW)) {
            y = code & ABOVE ? w[3] : w[1];
            x = x0 + (x1 - x0) * (y - y0) / (y1 - y0);
        } else {
            x = code & RIGHT ? w[2] : w[0];
            y = y0 + (y1 - y0) * (x - x0) / (x1 - x0);
        }
        if (code == code0) {
            x0 = x;
            y0 = y;
        } else {
            x1 = x;
            y1 = y;
        }
    }
    v[0] = x0;
    v[1] = y0;
    v[2] = x1;
    v[3] = y1;
    return 1;
}
