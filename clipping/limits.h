// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/abi.h"

#include <cstddef>

namespace CLEARCUT_API clipping {

/// A call takes fewer segments than this, because a source has 32 bits.
inline constexpr std::size_t tooMany = std::size_t(1) << 32;

/// Says in one sentence why the call is impossible, and ends the program.
[[noreturn, gnu::cold]] void refuse(std::size_t needed, std::size_t room) noexcept;

/// Ends the program where a call of the catalogue would write beyond the caller's buffer, or count
/// beyond 2^32, in every build. (clip.h stops before that, and says how far it got.)
inline void requireRoom(std::size_t segments, std::size_t room) noexcept
{
    if (room < segments || segments >= tooMany) [[unlikely]]
        refuse(segments, room);
}

} // namespace clipping
