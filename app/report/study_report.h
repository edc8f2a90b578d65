// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/study.h"
#include "app/report/report.h"

namespace app {

/// Everything that a study says, for people who never read the paper: what came out, why it
/// is so, charts and tables of each trial beside the paper's own, how it was measured, and how to
/// measure it again.
Report reportOf(const Study& study);

/// The command line that makes the same study again, and its report: "clearcut bench --paper ...".
/// A drawing is named without its folder.
QString commandToRepeat(const Study& study);

} // namespace app
