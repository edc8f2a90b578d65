// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/teaching.h"

// The values of the names in a line of pseudo-code at a step.

namespace app {

/// The values of names while a line is executed. Keeps a reference to the context.
class CodeValues {
public:
    /// Names in `old` keep their values from before the step.
    CodeValues(const SentenceContext& context, QStringList old)
        : context_(context), old_(std::move(old))
    {
    }

    /// The value of a name in the trace, or else a coordinate of the line or the window; empty for
    /// an unknown name.
    std::optional<Variable> of(const QString& name) const;

private:
    QStringList spellings(const QString& name) const;
    std::optional<Variable> toldOf(const QStringList& names) const;
    Variable asOfThen(Variable variable) const;
    /// Whether the value before the step is needed but unknown: this step sets it first.
    bool isNew(const Variable& variable) const;

    const SentenceContext& context_;
    QStringList old_;
};

enum class Digits : std::uint8_t { Six, All };

QString textOf(const Variable& variable, Digits digits);
/// A formula with values in place of its names, with enough digits to tell them apart.
QString filledIn(const QString& formula, const CodeValues& values);
/// The chosen branch, E or F, of "moved ? E : F" if the condition is known; else the condition.
QString chosen(const QString& condition, const CodeValues& values);

} // namespace app
