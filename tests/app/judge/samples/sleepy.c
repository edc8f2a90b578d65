/* SPDX-License-Identifier: GPL-3.0-or-later
 * Right, and sleeps for ten milliseconds on every line: it takes no processor time. */
#define _DEFAULT_SOURCE
#include <unistd.h>
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    usleep(10000);
    return right(s, w, v);
}
