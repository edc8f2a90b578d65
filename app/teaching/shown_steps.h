// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/document/document.h"

#include <QKeySequence>
#include <QString>
#include <QStringList>

#include <vector>

namespace app {

/// One step of a page of the manual, as the program performs it.
struct ShownStep {
    enum class Kind : std::uint8_t { Command, Move, Click, DoubleClick, Drag, Type, Press };
    /// A key that is pressed, and what it types.
    struct Key {
        QKeyCombination key;
        QString text; ///< empty: nothing
    };

    Kind kind = Kind::Command;
    QString command{};            ///< its key
    std::vector<Point> points{};  ///< millimetres on paper from the page's upper left corner
    Qt::KeyboardModifiers with{}; ///< held while the pointer acts
    std::vector<Key> keys{};      ///< typed one after the other
    QString typed{};              ///< the same as the page writes it: "40 Tab 8 Enter"
    QString button{};             ///< that is pressed: its text, its name or its tooltip
    QString sentence{};           ///< what the step shows; empty: its command, or what is typed
};

/// What the drawing must have when the steps have been performed.
struct ShownEnd {
    QString what; ///< "objects"
    double number;
    bool isMore; ///< than before
};

/// What a page shows: the drawing in which it does, its steps, and how they end.
struct ShownSteps {
    bool inCopy = false; ///< of the person's drawing, where it is large enough
    QString sample{};    ///< or in a new drawing like this one; empty: in an empty one
    std::vector<ShownStep> steps{};
    std::vector<ShownEnd> ends{};

    /// Whether all points of the steps are on a page of this size in millimetres.
    bool fitOn(const Point& page) const;
    /// Whether they are shown in a copy of this drawing: it is not empty, its page has room, and it
    /// is not so large that laying it out again would hold the window.
    bool areIn(const Document& own) const;
};

/// Reads the comment of a page (resources/README.md describes it): a line for each step. A failure
/// names the line that is wrong.
Result<ShownSteps> shownSteps(const QString& text);

/// Where they are shown, in a few words: "in a copy of the drawing". Empty: they are damaged.
QString placeOfSteps(const QString& text, const Document& own);

} // namespace app
