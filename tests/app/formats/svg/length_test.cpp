// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/length.h"

#include <QTest>

#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace formats_svg_length_test {

using app::svg::Lengths;

class LengthTest : public QObject {
    Q_OBJECT
private slots:
    void lengths_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<double>("units"); // below 0: not understood
        const auto row = [](const char* text, double units) {
            QTest::newRow(text) << QByteArray(text) << units;
        };
        row("3", 3);
        row("2em", 20);
        row("2EX", 10);
        row("2ch", 10);
        row("2rem", 40);
        row("4Q", 96 / 25.4);
        row("10vw", 80);
        row("10vh", 60);
        row("10vmin", 60);
        row("10vmax", 80);
        row("50%", 100);
        row("calc(1px + 2px)", 3);
        row("calc(50% - 10px)", 90);
        row("CALC( (1em + 2px) * 2 / 4 )", 6);
        row("calc(2 * 3px - -1px)", 7);
        row("calc(1e1px)", 10);
        row("calc(1e-1px*10)", 1);
        row("calc(calc(1px) + calc(2px))", 3);
        row("min(10px, 5em, 100%)", 10);
        row("max(1px, 2px)", 2);
        row("clamp(1px, 50px, 20px)", 20);
        row("calc(2)", 2);
        row("calc(1px + 2)", -1);
        row("calc(1px * 2px)", -1);
        row("calc(1px / 0)", -1);
        row("calc(1 / 2px)", -1);
        row("calc(1px", -1);
        row("calc()", -1);
        row("calc(1px) 2", -1);
        row("clamp(1px, 2px)", -1);
        row("calc(1zap)", -1);
        row("3zap", -1);
    }
    void lengths()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const double, units);
        const Lengths lengths{{200, 100}, 10, 20, {800, 600}};
        const auto length = lengths.parse(text.toStdString(), 200);
        QCOMPARE(length.has_value(), units >= 0);
        if (length)
            QCOMPARE(*length, units);
    }

    void deepCalculationsEnd()
    {
        const QByteArray deep =
            "calc" + QByteArray("(").repeated(100'000) + "1px" + QByteArray(")").repeated(100'000);
        QVERIFY(!Lengths().parse(deep.toStdString(), 1));
        const QByteArray wide = "calc(1px" + QByteArray(" + 1px").repeated(10'000) + ")";
        QCOMPARE(Lengths().parse(wide.toStdString(), 1), 10'001.0);
    }

    void inDrawings()
    {
        const auto width = [](const QByteArray& text) {
            return shapeOf("<line x2='1' stroke='red' style='stroke-width:" + text + "'/>")
                .style.width;
        };
        QCOMPARE(width("calc(1px + 10%)"), 11.0);
        QCOMPARE(width("10vw"), 10.0); // the drawing is 100 pixels wide
        QCOMPARE(shapeOf("<line x2='1' stroke='red' stroke-dasharray='calc(1px + 1px), 3'/>")
                     .style.dashes,
                 (std::vector<double>{2, 3}));
        QCOMPARE(shapeOf("<line x2='1' stroke='red' style='font-size:2px;stroke-width:2em'/>")
                     .style.width,
                 4.0);
    }
};

} // namespace formats_svg_length_test

TEST_CLASS(formats_svg_length_test::LengthTest, None)
#include "tests/app/formats/svg/length_test.moc"
