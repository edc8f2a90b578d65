// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "tests/clipping/answers.h"

/// FNV-1a of 64 bits, which goes on from an earlier one.
inline std::uint64_t fingerprint(const Answers& answers, std::uint64_t sofar = 0xcbf29ce484222325)
{
    for (const std::byte byte : answers)
        sofar = (sofar ^ std::uint64_t(byte)) * 0x100000001b3;
    return sofar;
}
