// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/examination.h"
#include "app/judge/verdict.h"

namespace app::plug_in {

/// Tests the library with every category against `exact`, repeats some lines, and then times it
/// beside every algorithm; errors in the race count like any other. If the library sleeps in the
/// race, the race's lines count as untested, so that it does not pass. The library is loaded only
/// into a process of its own, which must not hang (a second of processor time for one line), nor
/// exceed memoryLimit, nor leave a process behind; after a crash it is restarted, a few times.
/// Takes some seconds. Empty if it was stopped.
std::optional<Verdict> judge(const Case& which, const Follower& follower = {});

} // namespace app::plug_in
