// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/category.h"

namespace app::plug_in {

/// The library to be judged, and how.
struct Case {
    QString library;   ///< a path
    QString program{}; ///< runs as the child (child.h); empty: this program
    std::uint64_t seed = 1;
    Contract contract{};
    std::size_t randomLines = Scope{}.randomLines;
    enum class Race : std::uint8_t { Yes, No } race = Race::Yes;
    /// Limit of the library's processor time, after which no further line is tested; the limit of
    /// wall-clock time is wallFactor times as much. Every category gets a share.
    double seconds = 30;
    /// Wall-clock seconds that the library may sleep in the race before the race is stopped.
    double raceSleep = 20;
};

} // namespace app::plug_in
