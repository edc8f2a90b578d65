// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

// A line of pseudo-code, parsed so that its variables can be replaced by numbers.

namespace app {

/// A variable and the formula assigned to it.
struct Assignment {
    QString name, formula;
    bool isParameter = false; ///< of a call: all parameters are assigned at once
};

/// The condition of a line: "x1 < xmin" in "else if x1 < xmin: reject"; empty if it has none.
QString conditionIn(const QString& line);

/// The assignments of a line, in order. A call `f(E, F)` also assigns to the parameters of its
/// definition `f(p, q):` in the code.
std::vector<Assignment> assignmentsIn(const QString& line, const QStringList& code);

/// The variables of a formula: no functions, no words, no bit constants.
QStringList namesIn(const QString& formula);

/// The formula with even spacing, each variable replaced by its text.
QString withTexts(const QString& formula, const std::function<QString(const QString& name)>& text);

} // namespace app
