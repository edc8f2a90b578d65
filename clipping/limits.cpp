// SPDX-License-Identifier: MIT
#include "clipping/limits.h"

#include "clipping/ieee_numbers.h"

#include <cstdio>
#include <cstdlib>

namespace clipping {

void refuse(std::size_t needed, std::size_t room) noexcept
{
    if (needed >= tooMany && room >= needed)
        std::fprintf(stderr, "Clearcut: a call takes fewer than 2^32 segments, not %zu.\n", needed);
    else
        std::fprintf(stderr,
                     "Clearcut: the output needs room for %zu pieces, but has room for %zu.\n",
                     needed, room);
    std::abort();
}

} // namespace clipping
