/* SPDX-License-Identifier: GPL-3.0-or-later
 * Gives up before anything was asked. */
#include <stdlib.h>

#include "resources/plug_in/example.c"

__attribute__((constructor)) static void begin(void) { abort(); }
