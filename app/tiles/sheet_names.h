// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tiles/tiling.h"

#include <QString>

namespace app {

/// "3 columns × 1 row".
QString gridText(const Tiling& tiling);
/// "Beyond the page: 1 column on the left, 2 rows below." Empty text if no sheets are there.
QString beyondText(const Tiling& tiling);

// The names of the files of sheets, by a pattern such as "plan-{row}-{column}.svg".

/// The name of a sheet's file: {row}, {column} and {n} in the pattern become its numbers.
QString sheetName(const QString& pattern, const Tiling& tiling, const Tile& tile);
/// Whether the pattern gives each sheet a name of its own.
bool namesEverySheet(const QString& pattern, const Tiling& tiling);
/// "plan-overview.svg": the word in place of all numbers. The pattern has some.
QString overviewName(const QString& pattern);
/// "plan.svg": the pattern without its numbers and what separates them.
QString nameWithoutNumbers(const QString& pattern);

} // namespace app
