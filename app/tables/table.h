// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <span>
#include <utility>
#include <vector>

namespace app {

/// A table as data: a row of names and rows of fields, as many as there are names. What may be
/// empty is left out where it is.
struct Table {
    QStringList names;
    std::vector<QStringList> rows{};
    QString title{};
    QString key{}; ///< in files: a word
    /// What is true of all rows: names (words) and what they stand for.
    std::vector<std::pair<QString, QString>> facts{};
    QStringList notes{}; ///< sentences
    /// Names of columns that came after others already read these tables: in CSV they stand behind
    /// the facts, so that every other column stays where it was.
    QStringList late{};
};

/// One row of the catalogue of what tables can be printed as.
struct TableFormat {
    QString key;    ///< "markdown": for --format
    QString ending; ///< "md": of a file's name
    QString name;   ///< translated
    QString (*text)(std::span<const Table> tables);
};

/// Every format; the first one is for people.
std::vector<TableFormat> tableFormats();

/// On one line: line breaks and other control characters are spaces. For formats of lines.
QString oneLine(const QString& text);

/// Whether a field is a number; a column of numbers (some may be empty) stands to the right.
bool isNumber(const QString& field);
std::vector<bool> numericColumns(const Table& table);

} // namespace app
