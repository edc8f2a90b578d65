// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <span>
#include <utility>
#include <vector>

namespace app {

/// A table as data: a row of names and rows of fields, as many fields as names. Outputs omit
/// optional members that are empty.
struct Table {
    QStringList names;
    std::vector<QStringList> rows{};
    QString title{};
    QString key{}; ///< in files: a word
    /// Names (single words) and values that hold for all rows.
    std::vector<std::pair<QString, QString>> facts{};
    QStringList notes{}; ///< sentences
};

/// One row of the catalogue of output formats for tables.
struct TableFormat {
    QString key;    ///< "markdown": for --format
    QString ending; ///< "md": the file name extension
    QString name;   ///< translated
    QString (*text)(std::span<const Table> tables);
};

/// All formats; the first one is for people.
std::vector<TableFormat> tableFormats();

/// The text on one line: line breaks and other control characters become spaces. For formats with
/// one record a line.
QString oneLine(const QString& text);

/// Whether a field is a number. Columns of numbers (some may be empty) are right-aligned.
bool isNumber(const QString& field);
std::vector<bool> numericColumns(const Table& table);

} // namespace app
