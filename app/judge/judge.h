// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/verdict.h"

namespace app::plug_in {

/// What is to be judged, and how.
struct Case {
    QString library;   ///< a path
    QString program{}; ///< what runs as the child (child.h); empty: this program
    std::uint64_t seed = 1;
    Contract contract{};
    std::size_t randomLines = Scope{}.randomLines;
    enum class Race : std::uint8_t { Yes, No } race = Race::Yes;
    /// Of the processor's time that the library takes, after which no further line is tested; on
    /// the wall it is wallFactor times as much. Every category gets its share.
    double seconds = 30;
    /// Seconds by the clock that the library may sleep in the race before that is given up.
    double raceSleep = 20;
};

/// Asks the library about every category and compares with `exact`, asks some lines again, then
/// times it beside every row; what it finds in the race counts like any other answer. If it sleeps
/// in the race, the race's lines are not tested, so that it does not pass.
/// The library is loaded only into a process of its own, which may neither hang (a second of the
/// processor's time for one line), nor take more than memoryLimit, nor leave a process behind;
/// after a crash it is started again, a few times. Takes some seconds. Nothing if it was stopped.
std::optional<Verdict> judge(const Case& which, const Follower& follower = {});

} // namespace app::plug_in
