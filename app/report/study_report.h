// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/study.h"
#include "app/report/report.h"

namespace app {

/// All results of a study, for people who have not read the paper: the outcome, the reasons, charts
/// and tables of each trial beside the paper's own, how it was measured, and how to repeat the
/// measurement.
Report reportOf(const Study& study);

} // namespace app
