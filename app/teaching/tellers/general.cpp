// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/latin.h"
#include "app/teaching/code_line.h"
#include "app/teaching/page.h"
#include "app/teaching/tellers/ends.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

// What is said of an algorithm that has no sentences of its own: its pseudo-code, with numbers.

namespace app {

using clipping::Edge;
using clipping::What;

namespace {

QString tr(const char* text) { return QCoreApplication::translate("tellers", text); }

/// What the names of a line stand for while it is run.
class Values {
public:
    /// Names in `old` have the value that they had before the step.
    Values(const Telling& telling, QStringList old) : telling_(telling), old_(std::move(old)) {}

    std::optional<Variable> of(const QString& name) const
    {
        const auto& [min, max] = telling_.specimen.window;
        const auto& [a, b] = telling_.specimen.line;
        for (const auto& [known, value] : {std::pair("xmin", min.x), std::pair("ymin", min.y),
                                           std::pair("xmax", max.x), std::pair("ymax", max.y)})
            if (name == QLatin1StringView(known))
                return Variable{name, value};
        for (const QString& spelling : spellings(name))
            if (const auto found = std::ranges::find(telling_.variables, spelling, &Variable::name);
                found != telling_.variables.end())
                return asOfThen(*found);
        for (const auto& [known, value] : {std::pair("x1", a.x), std::pair("y1", a.y),
                                           std::pair("x2", b.x), std::pair("y2", b.y)})
            if (spellings(name).contains(QLatin1StringView(known)))
                return Variable{name, value};
        return std::nullopt;
    }

private:
    /// "x[i]" is "x[1]" while i is 1, and "xi" is "x1".
    QStringList spellings(const QString& name) const
    {
        QStringList all{name};
        if (const auto i = telling_.known("i")) {
            const QString number = QString::number(int(*i));
            if (name.endsWith(QStringLiteral("[i]")))
                all << name.chopped(2) + number + u']';
            else if (name.size() == 2 && name.endsWith(u'i'))
                all << name.chopped(1) + number;
        }
        return all;
    }
    Variable asOfThen(Variable variable) const
    {
        if (old_.contains(variable.name) && variable.before)
            variable.value = *variable.before;
        return variable;
    }

    const Telling& telling_;
    QStringList old_;
};

enum class Digits : std::uint8_t { Six, All };

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

/// As many digits as tell any two different values apart.
Digits digitsFor(const QStringList& names, const Values& values)
{
    for (const QString& one : names)
        for (const QString& other : names) {
            const auto p = values.of(one), q = values.of(other);
            if (p && q && p->value != q->value && shortText(p->value) == shortText(q->value))
                return Digits::All;
        }
    return Digits::Six;
}

QString evenly(const QString& formula)
{
    return withTexts(formula, [](const QString& name) { return name; });
}

QString filledIn(const QString& formula, const Values& values)
{
    const Digits digits = digitsFor(namesIn(formula), values);
    return withTexts(formula, [&](const QString& name) {
        const auto variable = values.of(name);
        return variable ? textOf(*variable, digits) : name;
    });
}

/// Of "moved ? E : F" what is asked, E or F, if that is known.
QString chosen(const QString& condition, const Values& values)
{
    static const QRegularExpression choice(QStringLiteral("^\\(?(\\w+) \\? (.+) : (.+?)\\)?$"));
    const auto match = choice.match(condition);
    const auto which = match.hasMatch() ? values.of(match.captured(1)) : std::nullopt;
    return which ? match.captured(which->value != 0 ? 2 : 3) : condition;
}

/// "At the left edge, " before what is about an edge.
QString atEdge(const Telling& telling, const QString& said)
{
    const QString edge = telling.edgeText();
    return edge.isEmpty() ? said : tr("At %1, %2").arg(edge, said);
}

QString withCapital(QString sentence)
{
    sentence[0] = sentence[0].toUpper();
    return sentence;
}

QString lineOf(const Telling& telling, const QStringList& code)
{
    return code.value(telling.step.line - 1);
}

QString asked(const Telling& telling, const QStringList& code)
{
    const Values values(telling, {});
    const QString condition = chosen(conditionIn(lineOf(telling, code)), values);
    if (condition.isEmpty())
        return withCapital(
            atEdge(telling, telling.holds() ? tr("the test holds.") : tr("the test fails.")));
    const QString question = evenly(condition), numbers = filledIn(condition, values),
                  answer = telling.holds() ? tr("yes") : tr("no");
    return withCapital(atEdge(telling, numbers == question
                                           ? tr("is %1? %2.").arg(question, answer)
                                           : tr("is %1? %2: %3.").arg(question, numbers, answer)));
}

/// "dx = x2 - x1 = 70 - (-160) = 230", without saying anything twice.
QString setTo(const QString& name, const QStringList& texts)
{
    QStringList said{name};
    for (const QString& text : texts)
        if (said.last() != text)
            said << text;
    return said.join(QStringLiteral(" = "));
}

/// What the line sets, as far as this step tells it.
QStringList assignments(const Telling& telling, const QStringList& code)
{
    const auto all = assignmentsIn(lineOf(telling, code), code);
    QStringList said;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Values after(telling, {});
        const auto value = after.of(all[i].name);
        const bool isTold = std::ranges::any_of(telling.step.values, [&](const auto& told) {
            return value && latin(told.name) == value->name;
        });
        if (!isTold)
            continue;
        QStringList later; // these are not set yet
        for (std::size_t j = i; j < all.size(); ++j)
            if (const auto other = after.of(all[j].name))
                later << other->name;
        said << setTo(value->name,
                      {evenly(all[i].formula), filledIn(all[i].formula, Values(telling, later)),
                       textOf(*value, Digits::Six)});
    }
    return said;
}

/// Every value of the step, where its line does not say how they came about.
QStringList values(const Telling& telling)
{
    QStringList said;
    for (const auto& told : telling.step.values)
        said << setTo(latin(told.name),
                      {textOf({latin(told.name), told.value, told.kind}, Digits::Six)});
    return said;
}

const clipping::Segment& leftBefore(const Telling& telling)
{
    return telling.before ? telling.before->segment : telling.specimen.line;
}

QString whatIsLeft(const Telling& telling)
{
    const auto& now = telling.step.segment;
    return (now == leftBefore(telling) ? tr("What is left stays as it is, from %1 to %2.")
                                       : tr("What is left now runs from %1 to %2."))
        .arg(words::point(now.a), words::point(now.b));
}

QString cut(const Telling& telling)
{
    const auto& before = leftBefore(telling);
    const auto& now = telling.step.segment;
    const QString edge = telling.edgeText(), a = words::point(now.a), b = words::point(now.b);
    if (before.a != now.a && before.b != now.b)
        return tr("Both ends are cut: End 1 moves to %1, End 2 to %2.").arg(a, b);
    if (before == now)
        return edge.isEmpty() ? tr("The line is cut where an end lies already: nothing moves.")
                              : tr("The line is cut at %1, where an end lies already: nothing "
                                   "moves.")
                                    .arg(edge);
    const QString end = words::end(before.a != now.a ? 1 : 2), to = before.a != now.a ? a : b;
    return edge.isEmpty() ? tr("%1 is cut: it moves to %2.").arg(end, to)
                          : tr("%1 is cut at %2: it moves to %3.").arg(end, edge, to);
}

QString given(const Telling& telling, const QStringList& code)
{
    if (telling.step.name == "left")
        return whatIsLeft(telling);
    QStringList said = assignments(telling, code);
    if (said.isEmpty())
        said = values(telling);
    return said.isEmpty() ? tr("It looks at %1.").arg(latin(telling.step.name))
                          : atEdge(telling, said.join(QStringLiteral(", ")) + u'.');
}

} // namespace

QString generalSentence(const Telling& telling)
{
    const QStringList code = codeOf(telling.specimen.clipper);
    switch (telling.step.what) {
    case What::Test:
        return asked(telling, code);
    case What::Let:
        return given(telling, code);
    case What::Cut:
        return cut(telling);
    case What::Accept:
        return words::acceptedIfInside(telling);
    case What::Reject:
        return tr("The line is rejected: nothing of it is visible.") + words::lost(telling);
    default:
        return tr("It goes round and round: it is stopped here, and nothing is visible.");
    }
}

} // namespace app
