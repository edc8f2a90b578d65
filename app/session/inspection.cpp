// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/inspection.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/comparison/line_class.h"
#include "app/teaching/value_unit.h"
#include "app/view/ruler.h"
#include "clipping/outcode.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace app {

using clipping::What;

using clipping::Edge;

namespace {

QLatin1StringView latin(std::string_view text)
{
    return QLatin1StringView(text.data(), qsizetype(text.size()));
}

/// The edge as it appears on the screen.
QString edgeName(Edge edge)
{
    switch (edge) {
    case Edge::Left:
        return Text::tr("left edge");
    case Edge::Right:
        return Text::tr("right edge");
    case Edge::Bottom:
        return Text::tr("top edge");
    case Edge::Top:
        return Text::tr("bottom edge");
    default:
        return {};
    }
}

/// The unit of values, and the variant that reports them.
struct Measure {
    Variant variant;
    Unit unit;
    double millimetresPerUnit;
    Point origin; ///< the origin of positions

    bool isFromZero() const { return origin == Point(0); }
    double inUnit(double length) const { return app::inUnit(length, unit, millimetresPerUnit); }
    QString point(const Point& p) const
    {
        const auto number = [&](double v) { return lengthNumber(v, unit, millimetresPerUnit, 1); };
        return QStringLiteral("(%1; %2)").arg(number(p.x - origin.x), number(p.y - origin.y));
    }
};

/// A number in the unit of the inspection; empty: it has no meaning there.
std::optional<double> shownNumber(const clipping::NamedValue& value, const Measure& measure)
{
    if (value.kind != clipping::ValueKind::Number)
        return value.value;
    const double number = value.value;
    switch (unitOfValue(measure.variant, value.name).value_or(ValueUnit::Bare)) {
    case ValueUnit::Length:
        return measure.inUnit(number);
    case ValueUnit::Area:
        return measure.inUnit(measure.inUnit(number));
    case ValueUnit::X:
        return measure.inUnit(number - measure.origin.x);
    case ValueUnit::Y:
        return measure.inUnit(number - measure.origin.y);
    case ValueUnit::FixedLength:
        return measure.isFromZero() ? std::optional(measure.inUnit(number)) : std::nullopt;
    case ValueUnit::FixedArea:
        return measure.isFromZero() ? std::optional(measure.inUnit(measure.inUnit(number)))
                                    : std::nullopt;
    case ValueUnit::Turned:
        return std::nullopt;
    default:
        return number;
    }
}

/// "D = 100"; empty: its number has no meaning in this unit.
QString valueText(const clipping::NamedValue& value, const Measure& measure)
{
    const auto number = shownNumber(value, measure);
    if (!number)
        return {};
    return latin(value.name) + QStringLiteral(" = ")
           + (value.kind == clipping::ValueKind::Bits ? outcodeText(unsigned(*number))
                                                      : shortText(*number));
}

/// A step in one word: the variable that it assigns, otherwise its kind.
std::string_view wordOf(const clipping::Step& step)
{
    static constexpr std::array words{
        std::pair{What::Test, "test"},     std::pair{What::Let, "set"},
        std::pair{What::Cut, "cut"},       std::pair{What::Accept, "accept"},
        std::pair{What::Reject, "reject"}, std::pair{What::GiveUp, "give up"}};
    if (!step.name.empty())
        return step.name;
    return std::ranges::find(words, step.what, &std::pair<What, const char*>::first)->second;
}

QString stepText(const clipping::Step& step, const Measure& measure)
{
    QString text = latin(wordOf(step));
    if (const QString edge = edgeName(step.edge); !edge.isEmpty())
        text += QStringLiteral(", ") + edge;
    QStringList values;
    for (const auto& value : step.values)
        if (const QString said = valueText(value, measure); !said.isEmpty())
            values << said;
    if (!values.isEmpty())
        text += QStringLiteral(": ") + values.join(QStringLiteral(", "));
    if (step.what == What::Reject || step.what == What::GiveUp)
        return Text::tr("%1\n     leaves nothing").arg(text);
    return Text::tr("%1\n     leaves %2 to %3")
        .arg(text, measure.point(step.segment.a), measure.point(step.segment.b));
}

QString endText(const Inspection& line, const Measure& measure)
{
    switch (line.trace.outcome) {
    case clipping::Outcome::DidNotEnd:
        return Text::tr("The algorithm did not end and was stopped: nothing is visible");
    case clipping::Outcome::Invisible:
        return Text::tr("Nothing is visible");
    case clipping::Outcome::Visible:
        break;
    }
    return Text::tr("Visible: %1 to %2")
        .arg(measure.point(line.trace.visible.a), measure.point(line.trace.visible.b));
}

} // namespace

Variant explaining(const Session& session, std::size_t segment)
{
    const auto& asked = session.differences.asked();
    const auto& list = session.differences.found().list;
    const auto found = std::ranges::lower_bound(list, segment, {}, &Difference::source);
    if (!asked || found == list.end() || found->source != segment)
        return session.variant();
    return asked->a == exactVariant() ? asked->b : asked->a;
}

std::optional<std::size_t> lineOfOnlyObject(const Session& session)
{
    const ObjectRanges& selection = session.selection();
    if (selection.size() != 1)
        return std::nullopt;
    const SceneLines& lines = session.scene.lines();
    const std::size_t object = selection.first(), line = lines.firstLineOf(object);
    return line < lines.firstLineOf(object + 1) ? std::optional(line) : std::nullopt;
}

Inspection inspect(const Session& session, std::size_t segment)
{
    const clipping::Window window = session.window();
    Inspection line{.variant = explaining(session, segment),
                    .number = segment,
                    .object = session.scene.lines().objectOf(segment),
                    .segment = session.scene.lines()[segment]};
    line.fromCode = clipping::outcodeOf(line.segment.a, window);
    line.toCode = clipping::outcodeOf(line.segment.b, window);
    line.visible = clipped(line.variant, line.segment, window);
    line.lineClass = lineClassOf(line.segment, window, line.visible.has_value());
    const auto& uses = functionsOf(line.variant);
    line.cost = uses.count({&line.segment, 1}, window);
    line.trace = uses.trace(line.segment, window);
    if (line.visible) {
        const double whole = glm::distance(line.segment.a, line.segment.b);
        line.share = whole > 0 ? glm::distance(line.visible->a, line.visible->b) / whole : 1;
    }
    return line;
}

QString verdictText(const Inspection& line)
{
    const QString name = nameOf(line.variant);
    return line.visible ? Text::tr("%1: visible, %2").arg(name, percentText(line.share))
                        : Text::tr("%1: nothing visible").arg(name);
}

QString costText(const clipping::OperationCounts& cost)
{
    QStringList parts;
    const auto add = [&](std::uint64_t count, const char* one, const char* many) {
        if (count > 0)
            parts << (count == 1 ? Text::tr(one) : Text::tr(many).arg(countText(count)));
    };
    add(cost.comparisons, QT_TRANSLATE_NOOP("Text", "1 comparison"),
        QT_TRANSLATE_NOOP("Text", "%1 comparisons"));
    add(cost.additions, QT_TRANSLATE_NOOP("Text", "1 addition"),
        QT_TRANSLATE_NOOP("Text", "%1 additions"));
    add(cost.multiplications, QT_TRANSLATE_NOOP("Text", "1 multiplication"),
        QT_TRANSLATE_NOOP("Text", "%1 multiplications"));
    add(cost.divisions, QT_TRANSLATE_NOOP("Text", "1 division"),
        QT_TRANSLATE_NOOP("Text", "%1 divisions"));
    add(cost.negations, QT_TRANSLATE_NOOP("Text", "1 negation"),
        QT_TRANSLATE_NOOP("Text", "%1 negations"));
    return parts.isEmpty() ? Text::tr("nothing") : parts.join(QStringLiteral(", "));
}

QStringList stepTexts(const Inspection& line, Unit unit, const Page& page)
{
    const Measure measure{line.variant, unit, page.realMillimetresPerUnit(), originOf(page, unit)};
    QStringList texts;
    for (const clipping::Step& step : line.trace.steps)
        if (step.what != What::Test) // the microscope shows tests
            texts << QStringLiteral("%1.  %2").arg(texts.size() + 1).arg(stepText(step, measure));
    texts << endText(line, measure);
    if (const Misprint* misprint = line.variant.misprint)
        texts << misprint->whatIsWrong;
    return texts;
}

} // namespace app
