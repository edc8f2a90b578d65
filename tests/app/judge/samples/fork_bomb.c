/* SPDX-License-Identifier: GPL-3.0-or-later
 * Starts processes until it may not any more, or has two thousand; says how many, and ends. */
#define _DEFAULT_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    int count = 0;
    while (count < 2000) {
        const int child = (int)fork();
        if (child == 0) {
            setsid();
            sleep(600);
            _exit(0);
        }
        if (child < 0)
            break;
        ++count;
    }
    printf("%d\n", count);
    fflush(stdout);
    (void)s, (void)w, (void)v;
    exit(7);
}
