/* SPDX-License-Identifier: GPL-3.0-or-later
 * Gives up before anything was asked. */
#include "resources/plug_in/example.c"

#include <stdlib.h>

__attribute__((constructor)) static void begin(void) { abort(); }
