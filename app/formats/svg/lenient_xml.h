// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIODevice>
#include <QString>

#include <map>

// Common errors of well-formedness that most programs pass over.

namespace app::svg {

/// How much of the beginning of a file was skipped, for the places of later messages.
struct Beginning {
    qint64 bytes = 0, lines = 0;
};
/// Skips blanks and byte order marks before the XML declaration, which must be the first of a file.
Beginning skipBlankBeginning(QIODevice& in);

/// The usual namespace of a prefix, and the line of its first use.
struct UsedPrefix {
    QString uri;
    qint64 line;
};
using UsedPrefixes = std::map<QString, UsedPrefix>;
/// The prefixes that a file uses without declaring them, as far as the file can be read.
UsedPrefixes undeclaredPrefixes(QIODevice& in);

} // namespace app::svg
