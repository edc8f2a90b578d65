/* SPDX-License-Identifier: GPL-3.0-or-later
 * Made for a later version of the header. */
#include "resources/plug_in/clearcut_algorithm.h"

CLEARCUT_EXPORT int clearcut_abi_version(void);
int clearcut_abi_version(void) { return CLEARCUT_ABI_VERSION + 1; }
int clearcut_clip(const double s[4], const double w[4], double v[4])
{
    v[0] = s[0] + w[0];
    return 0;
}
