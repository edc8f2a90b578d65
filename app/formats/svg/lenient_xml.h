// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIODevice>

#include <string>
#include <string_view>

// Common errors of well-formedness that most programs pass over.

namespace app::svg {

/// How much of the beginning of a file was skipped, for the places of later messages.
struct Beginning {
    qint64 bytes = 0, lines = 0;
};
/// Skips blanks and byte order marks before the XML declaration, which must be the first of a file.
Beginning skipBlankBeginning(QIODevice& in);

/// The namespace that is meant by a prefix without a declaration.
std::string usualNamespace(std::string_view prefix);

} // namespace app::svg
