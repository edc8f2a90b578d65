// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/library.h"

#include <QStringList>

namespace app::plug_in {

/// In the child: times the library on the paper's scene beside every row of the catalogue, each
/// called line by line through a pointer, as the library must be. `arguments`: LINES RUNS SEED
/// CONTRACT, the last one a word of strictnessWord. Writes lines to `out`: the share that is done
/// now and then, at last what the library got wrong (RaceFindings, race_check.h) and the times
/// (Times, times.h), as JSON.
void race(int out, const Library& library, const QStringList& arguments);

} // namespace app::plug_in
