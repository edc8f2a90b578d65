/* SPDX-License-Identifier: GPL-3.0-or-later
 * A shared library, but without the function. */
int something_else(void);
int something_else(void) { return 1; }
