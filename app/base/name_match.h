// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

#include <optional>

namespace app {

/// How a name fits what was typed to find it.
struct NameMatch {
    int score = 0;              ///< larger: fits better
    QList<qsizetype> letters{}; ///< the places of the typed letters in the name, ascending
};

/// In upper or lower case, from the best to the worst: it is the text; it begins with it; a word of
/// it does; each typed word begins a word; it contains the text, or each typed word; it has the
/// letters in this order, each at the beginning of a word or behind the one before ("sela" for
/// "Select all"). American spellings find British ones, and words that people use the program's own
/// (synonyms.h). Empty: it does not fit. Nothing typed fits
/// every name.
std::optional<NameMatch> matchName(const QString& typed, const QString& name);

} // namespace app
