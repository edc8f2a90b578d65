// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <span>
#include <string_view>

namespace app {

/// A word by which people look for something, and the program's word for it.
struct Synonym {
    std::string_view typed, word;
};

/// THE CATALOGUE, in the order of the typed words.
std::span<const Synonym> synonyms();

/// The text with the program's word for each word of it that has one: "turn left" becomes "rotate
/// left". Upper and lower case are the same.
QString inProgramWords(const QString& text);

} // namespace app
