// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"
#include "app/experiment/experiment.h"
#include "app/experiment/paper_runs.h"
#include "app/experiment/ranking.h"

#include <QCoreApplication>

namespace app {

/// The context of what charts say.
struct Charts {
    Q_DECLARE_TR_FUNCTIONS(Charts)
};

/// A row without figures: name, marker and form of a variant.
ChartRow rowFor(const Variant& variant);
/// "Cohen-Sutherland, as published".
QString fullName(const Variant& variant);
/// "23.9 ns": as many decimals as times in milliseconds have.
QString nanosecondsText(double nanoseconds);
/// The chart with the note that all of its rows share, if there is one, said once: below its title.
Chart withSharedNote(Chart chart);

/// "Scene “Long”, 1,000,000 lines".
QString sceneText(const ExperimentOptions& options);

/// The groups of two things or more, where row r shows thing order[r].
std::vector<RowGroup> groupsOf(const Ranking& ranking, std::span<const std::size_t> order);

/// Sentences below a chart: what brackets mean, or that there were too few runs to tell.
QStringList groupNotes(const Ranking& ranking);

} // namespace app
