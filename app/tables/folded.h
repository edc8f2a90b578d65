// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tables/table.h"

namespace app {

/// The terminal width, in columns, that tables for people are fitted to.
inline constexpr qsizetype terminalWidth = 80;

/// Breaks the text into lines of at most `width` characters, at spaces and after the characters
/// `after`. A part without either stays whole and may be longer.
QStringList brokenLines(const QString& text, qsizetype width, QStringView after = {});

/// Formats the table's names and rows as text, numbers right-aligned. If the table is too wide for
/// a terminal, its headings are broken into several lines, then its texts; at last its columns are
/// stacked in blocks, each of which starts with the columns that identify the rows. Empty if the
/// table has no columns.
QString folded(const Table& table);

} // namespace app
