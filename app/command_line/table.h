// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/given.h"

namespace app {

/// A table as data: a row of names and rows of fields, as many as there are names.
struct Table {
    QStringList names;
    std::vector<QStringList> rows;
};

/// The option --format text|csv.
Option tableOption();

/// The table as --format wants it: for people, numbers to the right, or as CSV.
QString tableText(const Table& table, const Given& given);

} // namespace app
