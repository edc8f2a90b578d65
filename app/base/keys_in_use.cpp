// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/keys_in_use.h"

#include <QRegularExpression>

namespace app {

namespace {

KeysInUse& keysNow()
{
    static KeysInUse keys = standardKeysInSentences();
    return keys;
}

} // namespace

const KeysInUse& standardKeysInSentences()
{
    // THE CATALOGUE. A command that a sentence names has its row.
    static const KeysInUse all{{"tool-select", "V"},
                               {"tool-nodes", "N"},
                               {"tool-window", "W"},
                               {"window-adds", "+"},
                               {"window-cuts-out", "-"},
                               {"window-intersects", "*"},
                               {"window-replaces", "="},
                               {"keep-outside", "X"},
                               {"move", "G"},
                               {"rotate", "O"},
                               {"scale", "K"},
                               {"rotate-left", "Shift+O"},
                               {"rotate-right", "Alt+Shift+O"},
                               {"flip-horizontal", "Shift+H"},
                               {"flip-vertical", "Shift+V"},
                               {"straighten-segments", "Shift+L"},
                               {"curve-segments", "Shift+U"},
                               {"take-stroke", "I"},
                               {"take-fill", "Shift+I"},
                               {"paste-style", "Ctrl+Shift+V"},
                               {"panes-1", "Ctrl+1"},
                               {"panes-2", "Ctrl+2"},
                               {"panes-4", "Ctrl+4"},
                               {"panes-all", "Ctrl+9"},
                               {"snap", "F5"},
                               {"grid", "Shift+F5"},
                               {"microscope", "F2"},
                               {"next-line", "F8"},
                               {"previous-line", "Shift+F8"},
                               {"next-difference", "F4"},
                               {"previous-difference", "Shift+F4"},
                               {"agree", "F7"},
                               {"presentation", "F11"},
                               {"workspace-draw", "Ctrl+Alt+1"},
                               {"workspace-cut", "Ctrl+Alt+2"},
                               {"workspace-compare", "Ctrl+Alt+3"},
                               {"workspace-learn", "Ctrl+Alt+4"}};
    return all;
}

void tellKeysInUse(const KeysInUse& keys) { keysNow() = keys; }

QString keyInUse(const QString& command) { return keysNow().value(command); }

QString withKeys(QString sentence)
{
    static const QRegularExpression named(
        QStringLiteral(" ?\\(\\{([a-z0-9-]+)\\}\\)|\\{([a-z0-9-]+)\\}"));
    qsizetype from = 0; // keys that were put in are not read again
    for (auto match = named.match(sentence); match.hasMatch();
         match = named.match(sentence, from)) {
        const bool inBrackets = match.hasCaptured(1) && !match.captured(1).isEmpty();
        const QString key = keysNow().value(match.captured(inBrackets ? 1 : 2));
        const QString before = match.captured().startsWith(u' ') ? QStringLiteral(" ") : QString();
        const QString shown = !inBrackets     ? (key.isEmpty() ? QStringLiteral("–") : key)
                              : key.isEmpty() ? QString()
                                              : before + u'(' + key + u')';
        sentence.replace(match.capturedStart(), match.capturedLength(), shown);
        from = match.capturedStart() + shown.size();
    }
    return sentence;
}

} // namespace app
