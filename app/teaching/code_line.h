// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

// A line of pseudo-code, taken apart to be said with numbers in place of its variables.

namespace app {

/// A variable and what it is set to.
struct Assignment {
    QString name, formula;
    bool isParameter = false; ///< of a call: all of them are set at once
};

/// The condition of a line: "x1 < xmin" of "else if x1 < xmin: reject"; empty: it has none.
QString conditionIn(const QString& line);

/// The assignments of a line, in their order. A call `f(E, F)` assigns to the parameters of its
/// definition `f(p, q):` in the code, too.
std::vector<Assignment> assignmentsIn(const QString& line, const QStringList& code);

/// The names of a formula that stand for values: no functions, no words, no constants of bits.
QStringList namesIn(const QString& formula);

/// The formula in even spacing, with the text of each of its names in its place.
QString withTexts(const QString& formula, const std::function<QString(const QString& name)>& text);

} // namespace app
