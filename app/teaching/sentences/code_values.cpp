// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/sentences/code_values.h"

#include "app/base/numbers.h"
#include "app/teaching/code_line.h"
#include "app/teaching/sentences/words.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

/// The number of digits that distinguishes any two different values.
Digits digitsFor(const QStringList& names, const CodeValues& values)
{
    for (const QString& one : names)
        for (const QString& other : names) {
            const auto p = values.of(one), q = values.of(other);
            if (p && q && p->value != q->value && shortText(p->value) == shortText(q->value))
                return Digits::All;
        }
    return Digits::Six;
}

} // namespace

std::optional<Variable> CodeValues::of(const QString& name) const
{
    // Values of the trace come first: an algorithm that rotates the plane reports new values for
    // window and line.
    const QStringList all = spellings(name);
    auto told = toldOf(all);
    if (told && !isNew(*told))
        return asOfThen(*told);
    const auto& [min, max] = context_.tracedLine.window;
    const auto& [a, b] = context_.tracedLine.line;
    for (const auto& [known, value] :
         {std::pair("x1", a.x), std::pair("y1", a.y), std::pair("x2", b.x), std::pair("y2", b.y),
          std::pair("xmin", min.x), std::pair("ymin", min.y), std::pair("xmax", max.x),
          std::pair("ymax", max.y)})
        if (all.contains(QLatin1StringView(known)))
            return Variable{name, value};
    return told;
}

std::optional<Variable> CodeValues::toldOf(const QStringList& names) const
{
    for (const QString& name : names)
        if (const auto found = std::ranges::find(context_.variables, name, &Variable::name);
            found != context_.variables.end())
            return *found;
    return std::nullopt;
}

/// The spellings of a name: "x[k]" is "x[2]" while k is 2, and "xi" is "x1" while i is 1.
QStringList CodeValues::spellings(const QString& name) const
{
    static const QRegularExpression indexed(QStringLiteral("^(\\w+\\[)([A-Za-z_]\\w*)\\]$"));
    QStringList all{name};
    const auto add = [&](const QString& before, const QString& index, const QString& behind) {
        const auto known = std::ranges::find(context_.variables, index, &Variable::name);
        if (known != context_.variables.end())
            all << before + QString::number(int(known->value)) + behind;
    };
    if (const auto match = indexed.match(name); match.hasMatch())
        add(match.captured(1), match.captured(2), QStringLiteral("]"));
    else if (name.size() == 2 && name.endsWith(u'i'))
        add(name.chopped(1), QStringLiteral("i"), {});
    return all;
}

Variable CodeValues::asOfThen(Variable variable) const
{
    if (old_.contains(variable.name) && variable.before)
        variable.value = *variable.before;
    return variable;
}

bool CodeValues::isNew(const Variable& variable) const
{
    return old_.contains(variable.name) && !variable.before;
}

QString textOf(const Variable& variable, Digits digits)
{
    switch (variable.kind) {
    case clipping::ValueKind::Bits:
        return outcodeText(unsigned(variable.value));
    case clipping::ValueKind::Truth:
        return variable.value != 0 ? QStringLiteral("true") : QStringLiteral("false");
    default:
        return digits == Digits::All && std::isfinite(variable.value)
                   ? exactText(variable.value)
                   : words::number(variable.value);
    }
}

QString filledIn(const QString& formula, const CodeValues& values)
{
    const Digits digits = digitsFor(namesIn(formula), values);
    return withTexts(formula, [&](const QString& name) {
        const auto variable = values.of(name);
        return variable ? textOf(*variable, digits) : name;
    });
}

QString chosen(const QString& condition, const CodeValues& values)
{
    static const QRegularExpression choice(QStringLiteral("^\\(?(\\w+) \\? (.+) : (.+?)\\)?$"));
    const auto match = choice.match(condition);
    const auto which = match.hasMatch() ? values.of(match.captured(1)) : std::nullopt;
    return which ? match.captured(which->value != 0 ? 2 : 3) : condition;
}

} // namespace app
