// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/line_class.h"
#include "app/teaching/manual.h"
#include "app/teaching/overlay_of.h"

#include <QMap>
#include <QRegularExpression>
#include <QTest>

#include <array>

#include "tests/test_class.h"

namespace teaching_outcode_test {

using app::Point;
using clipping::Window;

namespace {

constexpr Window window{{0, 0}, {10, 8}};

/// What one bit asks, as a page writes it: "y > ymax".
bool holds(const QString& question, const Point& p)
{
    const QStringList words = question.split(u' ');
    if (words.size() != 3)
        qFatal("The page asks \"%s\"", qPrintable(question));
    const double value = words[0] == QStringLiteral("x") ? p.x : p.y;
    const double level = words[2] == QStringLiteral("xmin")   ? window.min.x
                         : words[2] == QStringLiteral("xmax") ? window.max.x
                         : words[2] == QStringLiteral("ymin") ? window.min.y
                                                              : window.max.y;
    return words[1] == QStringLiteral(">") ? value > level : value < level;
}

QString pageText() { return app::pageOf(*clipping::findAlgorithm("cohen-sutherland")); }

/// The bits as the page defines them, the first digit first.
QStringList bitsOfThePage()
{
    static const QRegularExpression list(
        QStringLiteral("has four bits, written in this order: ([^.]*)\\."));
    return list.match(pageText()).captured(1).simplified().split(QStringLiteral(", "));
}

/// The outcode of a point by the page's definition.
QString codeByThePage(const Point& p)
{
    QString code;
    for (const QString& bit : bitsOfThePage())
        code += holds(bit, p) ? u'1' : u'0';
    return code;
}

/// A point in each of the nine regions.
std::vector<Point> points()
{
    std::vector<Point> all;
    for (const double x : {-5.0, 4.0, 17.0})
        for (const double y : {-6.0, 3.0, 19.0})
            all.push_back({x, y});
    return all;
}

/// Where a point is seen in a drawing, whose y grows downward.
QString seen(const Point& p)
{
    QStringList words;
    if (p.y < window.min.y || p.y > window.max.y)
        words << (p.y < window.min.y ? QStringLiteral("above") : QStringLiteral("below"));
    if (p.x < window.min.x || p.x > window.max.x)
        words << (p.x < window.min.x ? QStringLiteral("left") : QStringLiteral("right"));
    return words.isEmpty() ? QStringLiteral("inside") : words.join(u' ');
}

QString variable(const app::NarratedStep& narrated, const char* name)
{
    for (const app::Variable& v : narrated.variables)
        if (v.name == QLatin1StringView(name))
            return app::valueText(v);
    return {};
}

/// The one of these variables that a form has.
QString variableAmong(const app::NarratedStep& narrated, std::initializer_list<const char*> names)
{
    for (const char* name : names)
        if (QString value = variable(narrated, name); !value.isEmpty())
            return value;
    return {};
}

app::Narration narrationOf(std::string_view algorithm, clipping::Form form, const Point& a,
                           const Point& b)
{
    return app::narrationOf(
        {{clipping::findAlgorithm(algorithm), form}, {a, b}, window, app::YAxis::Down, {}});
}

} // namespace

/// One convention: what the page says of each bit is what is shown of a drawing, whose y grows
/// downward.
class OutcodeTest : public QObject {
    Q_OBJECT

private slots:
    void thePageDefinesEachBitOnce()
    {
        QCOMPARE(bitsOfThePage().size(), 4);
        QCOMPARE(bitsOfThePage().join(QStringLiteral(", ")), app::outcodeBits());
        for (const clipping::Algorithm& algorithm : clipping::algorithms()) {
            const QString text = app::pageOf(algorithm);
            if (algorithm.key != "cohen-sutherland" && text.contains(QStringLiteral("outcode(")))
                QVERIFY2(text.contains(QStringLiteral("(cohen-sutherland.md)")),
                         algorithm.key.data());
        }
    }
    void theMicroscopeShowsThePagesBits()
    {
        int shown = 0;
        for (const char* key :
             {"cohen-sutherland", "midpoint-subdivision", "skala", "sobkow-pospisil-yang"})
            for (const clipping::Form form : {clipping::Form::Corrected, clipping::Form::Published})
                for (const Point& a : points())
                    for (const Point& b : points()) {
                        const app::Narration narration = narrationOf(key, form, a, b);
                        const app::NarratedStep& first = narration.steps.front();
                        QCOMPARE(variableAmong(first, {"code1", "code[1]"}), codeByThePage(a));
                        QCOMPARE(variableAmong(first, {"code2", "code[2]"}), codeByThePage(b));
                        QVERIFY2(first.sentence.contains(codeByThePage(a)),
                                 qPrintable(first.sentence));
                        ++shown;
                    }
        QCOMPARE(shown, 4 * 2 * 81);
    }
    void theMicroscopeSaysWhereThatIsSeen()
    {
        for (const Point& a : points()) {
            const QString sentence =
                narrationOf("cohen-sutherland", clipping::Form::Corrected, a, {4, 3})
                    .steps.front()
                    .sentence;
            const QString end = QStringLiteral("End 1 has %1 (%2)").arg(codeByThePage(a), seen(a));
            QVERIFY2(sentence.contains(end), qPrintable(sentence + " | " + end));
        }
    }
    void theLineOfThePseudoCodeIsThatOfTheBit()
    {
        static const QRegularExpression asks(QStringLiteral("code(?:Out|\\[i\\]) & (\\w+) "));
        const QMap<QString, QString> bits{{"TOP", "y > ymax"},
                                          {"BOTTOM", "y < ymin"},
                                          {"RIGHT", "x > xmax"},
                                          {"LEFT", "x < xmin"}};
        int tests = 0;
        for (const clipping::Form form : {clipping::Form::Corrected, clipping::Form::Published})
            for (const Point& a : points())
                for (const Point& b : points()) {
                    const app::Narration narration = narrationOf("cohen-sutherland", form, a, b);
                    for (const app::NarratedStep& narrated : narration.steps) {
                        const auto asked = asks.match(narration.code.value(narrated.line - 1));
                        if (!narrated.answer || !asked.hasMatch())
                            continue;
                        const QString bit = bits[asked.captured(1)];
                        const auto digit = bitsOfThePage().indexOf(bit);
                        QVERIFY2(digit >= 0, qPrintable(asked.captured(1)));
                        const QString i = variable(narrated, "i");
                        const QString code = variable(narrated, i.isEmpty() ? "codeOut"
                                                                : i == u'1' ? "code[1]"
                                                                            : "code[2]");
                        QCOMPARE(code[digit] == u'1', *narrated.answer);
                        ++tests;
                    }
                }
        QVERIFY(tests > 50);
    }
    void theOverlayShowsThePagesBits()
    {
        for (const char* key : {"cohen-sutherland", "midpoint-subdivision", "skala", "exact"})
            for (const Point& p : points()) {
                const auto overlay = app::overlayOf({.variant = {clipping::findAlgorithm(key)},
                                                     .window = window,
                                                     .pointer = p,
                                                     .seen = {{-20, -20}, {30, 30}},
                                                     .y = app::YAxis::Down});
                QStringList pointed;
                for (const app::OverlayArea& area : overlay.areas)
                    if (area.pointed)
                        pointed << area.label;
                QCOMPARE(pointed, QStringList(codeByThePage(p)));
            }
    }
};

} // namespace teaching_outcode_test

TEST_CLASS(teaching_outcode_test::OutcodeTest, None)
#include "tests/app/teaching/outcode_test.moc"
