// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"
#include "app/experiment/experiment.h"
#include "app/experiment/paper_runs.h"
#include "app/experiment/ranking.h"

namespace app {

/// A row without figures: name, marker and form of a variant.
ChartRow rowFor(const Variant& variant);
/// "Cohen-Sutherland, as published".
QString fullName(const Variant& variant);
/// "23.9 ns": with as many decimals as times in milliseconds.
QString nanosecondsText(double nanoseconds);
/// Moves a note that all rows share to a line below the chart's title.
Chart withSharedNote(Chart chart);

/// "Scene “Long”, 1,000,000 lines".
QString sceneText(const ExperimentOptions& options);

/// The groups with at least two members. Row r of the chart shows member order[r] of the ranking.
std::vector<RowGroup> groupsOf(const Ranking& ranking, std::span<const std::size_t> order);

/// Sentences below a chart: the meaning of brackets, or that there were too few runs for a test.
QStringList groupNotes(const Ranking& ranking);

} // namespace app
