// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/line_text.h"

#include <QLocale>
#include <QTest>

#include <cmath>
#include <numbers>

#include "tests/test_class.h"

namespace teaching_line_text_test {

class LineTextTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { QLocale::setDefault(QLocale::c()); }

    void linesAreRead_data()
    {
        QTest::addColumn<QString>("text");
        QTest::newRow("as shown") << QString::fromUtf8("−160, −30.5 → 70, 1.3e2");
        QTest::newRow("as typed") << "-160,-30.5 -> 70,130";
        QTest::newRow("no spaces") << "-160,-30.5->70,130";
        QTest::newRow("no arrow") << "-160 -30.5 70 130";
        QTest::newRow("brackets") << "(-160, -30.5) -> (70, 130)";
        QTest::newRow("semicolons") << "-160; -30.5; 70; 130";
        QTest::newRow("points") << "-160,-30.5 70,130";
        QTest::newRow("points, more spaces") << "  -160 , -30.5   70 , 130 ";
        QTest::newRow("points by a semicolon") << "-160,-30.5; 70,130";
        QTest::newRow("points by spaces and a semicolon") << "-160 -30.5; 70 130";
        QTest::newRow("to") << "-160, -30.5 to 70, 130";
        QTest::newRow("brackets without anything between") << "(-160,-30.5)(70,130)";
        QTest::newRow("brackets and a comma") << "(-160,-30.5), (70,130)";
    }
    void linesAreRead()
    {
        QFETCH(const QString, text);
        QCOMPARE(app::lineFrom(text), (clipping::Segment{{-160, -30.5}, {70, 130}}));
    }
    void otherTextIsNotALine()
    {
        for (const char* text :
             {"", "1, 2", "1, 2 -> 3", "1, 2 -> 3, 4, 5", "a, 2 -> 3, 4", "1 2 3 4 x",
              "1,, 2 -> 3, 4 ->", "1e999999x, 0 -> 0, 0", "1 -> 2 -> 3 -> 4", "to 1 2 3 4",
              "1 2 3 4 to", "1,2 to to 3,4", ",1,2,3,4"})
            QVERIFY2(!app::lineFrom(QString::fromUtf8(text)), text);
    }
    void nonFiniteNumbersAreRead()
    {
        const auto line = app::lineFrom("nan, 0 -> inf, 1");
        QVERIFY(line && std::isnan(line->a.x) && std::isinf(line->b.x));
    }
    void everyBitComesBackInEveryCountry()
    {
        const clipping::Segment line{{1.0 / 3, -1e-300}, {123456.789, std::numbers::pi * 1e200}};
        for (const auto& locale :
             {QLocale::c(), QLocale(QLocale::German, QLocale::Germany), QLocale(QLocale::French),
              QLocale(QLocale::Greek), QLocale(QLocale::English), QLocale(QLocale::Swedish)}) {
            QLocale::setDefault(locale);
            const QString text = app::lineText(line);
            QVERIFY2(app::lineFrom(text) == line, qPrintable(locale.name() + ": " + text));
        }
    }
    void aPointIsReadInEveryCountry()
    {
        QCOMPARE(app::pairText("-0.5", "3"), "(-0.5, 3)");
        QLocale::setDefault(QLocale(QLocale::Greek));
        QCOMPARE(app::pairText("-0,5", "3"), "(-0,5; 3)");
    }
    void aDecimalCommaIsOneWhereItIsUsed()
    {
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
        QCOMPARE(app::lineFrom("1,5; 2 -> 3; 4,25"), (clipping::Segment{{1.5, 2}, {3, 4.25}}));
        QCOMPARE(app::lineFrom("1,5 2 3 4,25"), (clipping::Segment{{1.5, 2}, {3, 4.25}}));
        QCOMPARE(app::lineFrom("-160,-30 70,130"), (clipping::Segment{{-160, -30}, {70, 130}}));
        QCOMPARE(app::lineFrom("160,30 70,130"), (clipping::Segment{{160, 30}, {70, 130}}));
        QCOMPARE(app::lineText({{1.5, 2}, {3, 4.25}}), QString::fromUtf8("1,5; 2 → 3; 4,25"));
    }
};

} // namespace teaching_line_text_test

TEST_CLASS(teaching_line_text_test::LineTextTest, None)
#include "tests/app/teaching/line_text_test.moc"
