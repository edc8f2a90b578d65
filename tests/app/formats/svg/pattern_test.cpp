// SPDX-License-Identifier: GPL-3.0-or-later
// A pattern becomes the mean colour of its tile.
#include <QTest>

#include <cmath>

#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace formats_svg_pattern_test {

namespace {

const QByteArray box = "<rect x='10' y='20' width='40' height='20' fill='url(#p)'/>";
const QByteArray tile = "<pattern id='p' patternUnits='userSpaceOnUse' width='8' height='8' ";

} // namespace

class PatternTest : public QObject {
    Q_OBJECT
private slots:
    void meanColour_data()
    {
        QTest::addColumn<QByteArray>("elements");
        QTest::addColumn<QList<int>>("colour"); // red, green, blue, alpha
        const auto row = [](const char* name, const QByteArray& elements,
                            const QList<int>& colour) {
            QTest::newRow(name) << elements << colour;
        };
        const QByteArray half = "<rect width='4' height='8' fill='red'/>",
                         whole = "<rect width='8' height='8' fill='blue'/>";
        row("plain", tile + '>' + whole + "</pattern>" + box, {0, 0, 255, 255});
        row("half", tile + '>' + half + "</pattern>" + box, {255, 0, 0, 128});
        row("above", tile + '>' + whole + half + "</pattern>" + box, {128, 0, 128, 255});
        row("stroke", tile + "><path d='M0 4H8' stroke='red' stroke-width='2'/></pattern>" + box,
            {255, 0, 0, 64});
        row("shifted", tile + "x='4'>" + half + "</pattern>" + box, {255, 0, 0, 128});
        row("box units",
            "<pattern id='p' width='.5' height='1'><rect width='10' height='20' fill='red'/>"
            "</pattern>"
                + box,
            {255, 0, 0, 128});
        row("content in box units",
            "<pattern id='p' width='.5' height='1' patternContentUnits='objectBoundingBox'>"
            "<rect width='.25' height='1' fill='red'/></pattern>"
                + box,
            {255, 0, 0, 128});
        row("view box",
            tile + "viewBox='0 0 2 2'><rect width='1' height='2' fill='red'/></pattern>" + box,
            {255, 0, 0, 128});
        row("taken from another",
            tile + "/><pattern id='q' href='#p'>" + half
                + "</pattern><rect width='8' height='8' fill='url(#q)'/>",
            {255, 0, 0, 128});
        row("in a pattern",
            tile + '>' + half
                + "</pattern><pattern id='q' patternUnits='userSpaceOnUse' width='8' height='8'>"
                  "<rect width='8' height='8' fill='url(#p)'/></pattern>"
                  "<rect width='8' height='8' fill='url(#q)'/>",
            {255, 0, 0, 128});
    }
    void meanColour()
    {
        QFETCH(const QByteArray, elements);
        QFETCH(const QList<int>, colour);
        const auto fill = shapeOf(elements).style.fill;
        QCOMPARE(fill.has_value(), colour[3] > 0);
        if (!fill)
            return;
        const QList<int> found{fill->red, fill->green, fill->blue, fill->alpha};
        for (int i = 0; i < 4; ++i)
            QVERIFY2(std::abs(found[i] - colour[i]) <= 2, qPrintable(QString::number(found[i])));
    }

    void isTold()
    {
        const QByteArray elements = tile + "><circle r='9' zap='1'/></pattern>" + box;
        QCOMPARE(reportOf(elements), "1 pattern");
        QCOMPARE(readText(drawing(elements)).value->report[0].instead, "its mean colour is used");
    }

    void patternsOfThemselvesEnd()
    {
        const QByteArray self = tile + "><rect width='8' height='8' fill='url(#p)'/></pattern>";
        QVERIFY(!shapeOf(self + box).style.fill);
        QByteArray all;
        for (int i = 0; i < 100; ++i)
            all += "<pattern id='p" + QByteArray::number(i)
                   + "' width='1' height='1'><rect width='9' height='9' fill='url(#p"
                   + QByteArray::number(i + 1) + ")'/></pattern>";
        QVERIFY(readText(drawing(all + "<rect width='8' height='8' fill='url(#p0)'/>")));
    }
};

} // namespace formats_svg_pattern_test

TEST_CLASS(formats_svg_pattern_test::PatternTest, None)
#include "tests/app/formats/svg/pattern_test.moc"
