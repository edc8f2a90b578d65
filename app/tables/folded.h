// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tables/table.h"

namespace app {

/// Columns of a terminal, into which tables for people fit.
inline constexpr qsizetype terminalWidth = 80;

/// The text in lines of at most `width` characters, broken at spaces and after the characters
/// `after`. What has none of these stays whole and may be longer.
QStringList brokenLines(const QString& text, qsizetype width, QStringView after = {});

/// The table's names and rows, numbers to the right. One that is too wide for a terminal gets
/// headings of several lines; if need be its texts are broken, and its columns go below each other
/// in blocks that all begin with the columns that tell the rows apart. Empty without columns.
QString folded(const Table& table);

} // namespace app
