// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/library.h"

#include <QStringList>

namespace app::plug_in {

/// In the child: times the library on the paper's scene beside every algorithm of the catalogue,
/// each called line by line through a pointer, as the library must be. `arguments`: LINES RUNS SEED
/// CONTRACT, the last one a word of wordOf(Strictness). Writes lines to `out`: progress from time
/// to time, and finally the library's errors (RaceFindings, race_check.h) and the times (Times,
/// times.h) as JSON.
void race(int out, const Library& library, const QStringList& arguments);

} // namespace app::plug_in
