// SPDX-License-Identifier: GPL-3.0-or-later
// Conditions of @supports, and rules of style sheets that are told.
#include "app/formats/svg/supports.h"

#include <QTest>

#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace formats_svg_supports_test {

using app::svg::isSupported;

namespace {

QString fillOf(const QByteArray& sheet)
{
    const auto shape = shapeOf("<style>" + sheet + "</style><path d='M0 0H9V9'/>");
    return shape.style.fill ? QString::number(shape.style.fill->red) : "none";
}

QString toldOf(const QByteArray& sheet)
{
    return reportOf("<style>" + sheet + "</style><path d='M0 0H9V9'/>");
}

} // namespace

class SupportsTest : public QObject {
    Q_OBJECT

private slots:
    void conditions_data()
    {
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* condition, const char* expected) {
            QTest::newRow(condition) << expected;
        };
        row("(fill: red)", "yes");
        row("(FILL:red)", "yes");
        row("(--x: 1)", "yes");
        row("(cursor: pointer)", "yes");
        row("not (fill: red)", "no");
        row("(fill: red) and (not (stroke: blue))", "no");
        row("(fill: red) and (stroke: blue)", "yes");
        row("(not (fill: red)) or (stroke: blue)", "yes");
        row("((fill: red))", "yes");
        row("selector(a > b)", "yes");
        row("(transform: rotate(5deg))", "yes");
        row("(fill: nonsense(1))", "unknown");
        row("(zap: 1)", "unknown");
        row("selector(::zap)", "unknown");
        row("font-tech(color-COLRv1)", "unknown");
        row("(fill: red) nor (fill: red)", "unknown");
        row("(fill: red", "unknown");
        row("fill: red", "unknown");
        row("", "unknown");
    }
    void conditions()
    {
        QFETCH(QString, expected);
        const auto answer = isSupported(QTest::currentDataTag());
        QCOMPARE(answer ? (*answer ? "yes" : "no") : "unknown", expected);
    }

    void deepBracketsEnd()
    {
        const std::string deep = std::string(100'000, '(') + "fill:red" + std::string(100'000, ')');
        QVERIFY(!isSupported(deep));
    }

    void rulesInThem()
    {
        QCOMPARE(fillOf("@supports (fill: red) { path { fill: #090000 } }"), "9");
        QCOMPARE(fillOf("@supports not (fill: red) { path { fill: #090000 } }"), "0");
        QCOMPARE(toldOf("@supports not (fill: red) { path { fill: #090000 } }"), "");
        QCOMPARE(toldOf("@supports (zap: 1) { path { fill: #090000 } }"),
                 "1 style rule “@supports (zap: 1)”");
    }

    void layersAreTold()
    {
        QCOMPARE(toldOf("@layer base { path { fill: red } }"), "1 style rule “@layer base”");
        QCOMPARE(toldOf("@layer base, more;"), "1 style rule “@layer base, more”");
    }

    void rulesInRulesAreTold()
    {
        const QByteArray sheet = "path { fill: #090000;\n &amp;:hover { fill: #080000 }\n stroke: "
                                 "blue } circle { fill: red }";
        QCOMPARE(fillOf(sheet), "9");
        const auto result = readText(drawing("<style>" + sheet + "</style><path d='M0 0H9V9'/>"));
        QCOMPARE(toldOf(sheet), "1 style rule “&:hover”");
        QCOMPARE(result.value->report[0].line, 2);
        QVERIFY(result.value->document.objects()[0].style().stroke);
        QCOMPARE(toldOf("path { @media print { fill: red } fill: blue }"),
                 "1 style rule “@media print”");
    }
};

} // namespace formats_svg_supports_test

TEST_CLASS(formats_svg_supports_test::SupportsTest, Core)
#include "tests/app/formats/svg/supports_test.moc"
