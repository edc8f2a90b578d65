// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QString>
#include <QStringList>

#include <vector>

namespace app {

/// A page of the help: one of the manual, or one about an algorithm.
struct HelpPage {
    QString link; ///< "snapping.md"
    QString title;
    QString text;         ///< of the page, without its title
    QStringList commands; ///< that it explains
    QString small{};      ///< the text in lower case, in which is searched
};

/// A part of the contents: its heading and its pages.
struct HelpPart {
    QString title;
    std::vector<HelpPage> pages;
};

/// The contents: the parts of the manual, then the algorithms.
const std::vector<HelpPart>& helpContents();

/// What a command is called and which keys it has, by the command's key.
struct HelpCommand {
    QString name;
    QStringList keys; ///< "Ctrl+E"
};
using HelpCommands = QHash<QString, HelpCommand>;

/// A page that was found.
struct HelpHit {
    const HelpPage* page; ///< of the contents
    QString why;          ///< the command that fits, or the words around the first place; or empty
};

/// The pages that have each typed word that says something, or the program's word for it, in their
/// title, in the name or the keys of a command that they explain, or in their text; in this order,
/// and of the last the one with most places first. If there is none, those that lack the fewest
/// words, at most half.
std::vector<HelpHit> searchHelp(const QString& typed, const HelpCommands& commands);

} // namespace app
