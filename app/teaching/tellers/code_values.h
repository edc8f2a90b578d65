// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/teller.h"

// The numbers that stand for the names of a line of pseudo-code at a step.

namespace app {

/// What the names of a line stand for while it is run. Refers to the telling.
class CodeValues {
public:
    /// Names in `old` have the value that they had before the step.
    CodeValues(const Telling& telling, QStringList old) : telling_(telling), old_(std::move(old)) {}

    /// What an algorithm tells of a name, or else what the line and the window are; nothing: a name
    /// of which nothing is known.
    std::optional<Variable> of(const QString& name) const;

private:
    QStringList spellings(const QString& name) const;
    std::optional<Variable> toldOf(const QStringList& names) const;
    Variable asOfThen(Variable variable) const;
    /// Whether it is wanted as it was before the step, which has told it first.
    bool isNew(const Variable& variable) const;

    const Telling& telling_;
    QStringList old_;
};

enum class Digits : std::uint8_t { Six, All };

QString textOf(const Variable& variable, Digits digits);
/// A formula with its values in place of its names, in as many digits as tell them apart.
QString filledIn(const QString& formula, const CodeValues& values);
/// Of "moved ? E : F" what is asked, E or F, if that is known; else the condition.
QString chosen(const QString& condition, const CodeValues& values);

} // namespace app
