// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/verdict.h"

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

/// Tests the library with every category against `exact`, repeats some lines, and then times it
/// beside every algorithm; errors in the race count like any other. If the library sleeps in the
/// race, the race's lines count as untested, so that it does not pass. The library is loaded only
/// into a process of its own, which must not hang (a second of processor time for one line), nor
/// exceed memoryLimit, nor leave a process behind; after a crash it is restarted, a few times.
/// Takes some seconds. Empty if it was stopped.
std::optional<Verdict> judge(const Case& which, const Follower& follower = {});

} // namespace app::plug_in
