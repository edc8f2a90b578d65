/* SPDX-License-Identifier: GPL-3.0-or-later
 * Leaves processes behind as a daemon does: each in a session of its own, started by a process that
 * ends at once; the last one is a chain in which each starts the next and ends. They say their
 * numbers. Then it crashes. */
#define _DEFAULT_SOURCE
#include <signal.h>
#include <stdio.h>
#include <unistd.h>
#define clearcut_clip right
#include "resources/plug_in/example.c"
#undef clearcut_clip

enum { DAEMONS = 3, LINKS = 3000 }; /* the chain ends in any case, after some seconds */

static void become_daemon(int polyline)
{
    if (fork() != 0)
        _exit(0);
    setsid();
    printf("%d\n", (int)getpid());
    fflush(stdout);
    for (int link = 0; polyline && link < LINKS; ++link) {
        usleep(1000);
        if (fork() != 0)
            _exit(0);
        setsid();
    }
    sleep(600);
    _exit(0);
}

CLEARCUT_EXPORT int clearcut_clip(const double s[4], const double w[4], double v[4]);
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    static int calls = 0;
    if (++calls != 100)
        return right(s, w, v);
    for (int i = 0; i < DAEMONS; ++i)
        if (fork() == 0)
            become_daemon(i == DAEMONS - 1);
    usleep(50000); /* until they have said their numbers */
    raise(SIGSEGV);
    return 0;
}
