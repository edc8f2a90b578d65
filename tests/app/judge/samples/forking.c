/* SPDX-License-Identifier: GPL-3.0-or-later
 * Right for a hundred lines; then it leaves a process behind that sleeps, says which, and crashes.
 */
#define _DEFAULT_SOURCE
#include <signal.h>
#include <stdio.h>
#include <unistd.h>
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    static int calls = 0;
    if (++calls == 100) {
        const int left = (int)fork();
        if (left == 0) {
            sleep(600);
            _exit(0);
        }
        printf("%d\n", left);
        fflush(stdout);
        raise(SIGSEGV);
    }
    return right(s, w, v);
}
