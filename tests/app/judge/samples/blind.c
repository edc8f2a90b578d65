/* SPDX-License-Identifier: GPL-3.0-or-later
 * Treats what is no number as if it were one: the check is missing. */
#include <math.h>
#undef isfinite
#define isfinite(x) 1
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4]) { return right(s, w, v); }
