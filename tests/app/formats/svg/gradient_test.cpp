// SPDX-License-Identifier: GPL-3.0-or-later
// A gradient becomes its mean colour on the shape that it paints.
#include "app/formats/svg/gradient.h"
#include "app/formats/svg/spread_points.h"

#include <QTest>

#include <cmath>

#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace formats_svg_gradient_test {

using namespace app::svg;
using app::FillRule;
using app::Point;
using app::Subpath;

namespace {

QByteArray named(const QByteArray& kind, const QByteArray& rest, const QByteArray& stops)
{
    return '<' + kind + " id='g' " + rest + '>' + stops + "</" + kind + '>';
}
const QByteArray blackToWhite = "<stop offset='0'/><stop offset='1' stop-color='#fff'/>";

QByteArray linear(const QByteArray& rest, const QByteArray& stops = blackToWhite)
{
    return named("linearGradient", rest, stops);
}
QByteArray radial(const QByteArray& rest, const QByteArray& stops = blackToWhite)
{
    return named("radialGradient", rest, stops);
}

double weightOf(const std::vector<SpreadPoint>& points)
{
    double sum = 0;
    for (const SpreadPoint& point : points)
        sum += point.weight;
    return sum;
}

Subpath square(double from, double to)
{
    return {{from, from}, {{{to, from}}, {{to, to}}, {{from, to}}}, true};
}

} // namespace

class GradientTest : public QObject {
    Q_OBJECT
private slots:
    void meanColour_data()
    {
        QTest::addColumn<QByteArray>("elements");
        QTest::addColumn<int>("grey"); // worked out by hand
        const QByteArray box = "<rect width='80' height='40' fill='url(#g)'/>";
        QTest::newRow("linear") << linear({}) + box << 127;
        QTest::newRow("downwards") << linear("x2='0' y2='1'") + box << 127;
        QTest::newRow("half of the box") << linear("x2='.5'") + box << 191;
        QTest::newRow("percent") << linear("x2='50%'") + box << 191;
        QTest::newRow("reflected") << linear("x2='.5' spreadMethod='reflect'") + box << 127;
        QTest::newRow("repeated") << linear("x2='.25' spreadMethod='repeat'") + box << 127;
        QTest::newRow("user units")
            << linear("gradientUnits='userSpaceOnUse' x2='320'") + box << 32;
        QTest::newRow("transformed") << linear("gradientTransform='scale(4)'") + box << 32;
        QTest::newRow("no length") << linear("x2='0'") + box << 255;
        QTest::newRow("within a transform")
            << linear("gradientUnits='userSpaceOnUse' x2='80'")
                   + "<g transform='rotate(30) scale(.1)'>" + box + "</g>"
            << 127;
        QTest::newRow("triangle") << linear({}) + "<path d='M0 0L90 0L0 30z' fill='url(#g)'/>"
                                  << 85; // a third
        QTest::newRow("ring by evenodd")
            << linear({})
                   + "<path fill-rule='evenodd' fill='url(#g)' d='M0 0h90v30h-90zM45 0h45v30"
                     "h-45z'/>"
            << 64; // its left half
        QTest::newRow("radial") << radial({}) + "<circle r='20' fill='url(#g)'/>" << 170;
        QTest::newRow("focus") << radial("fx='.5' fy='.5'") + "<circle r='20' fill='url(#g)'/>"
                               << 170;
        QTest::newRow("focal circle") << radial("fr='.25'") + "<circle r='20' fill='url(#g)'/>"
                                      << 106; // the integral of (2r - 1) · 2r from r = 1/2 to 1
        QTest::newRow("radius 0") << radial("r='0'") + box << 255;
        QTest::newRow("stroke") << linear("gradientUnits='userSpaceOnUse' x2='40'")
                                       + "<path d='M0 0H40' fill='none' stroke='url(#g)'/>"
                                << 127;
        QTest::newRow("taken from another")
            << linear({}) + "<linearGradient id='h' href='#g' x2='.5'/>"
                   + "<rect width='8' height='4' fill='url(#h)'/>"
            << 191;
        QTest::newRow("colour around it")
            << "<g color='#505050'>" + linear({}, "<stop stop-color='currentColor'/>") + "</g>"
                   + box
            << 80;
    }
    void meanColour()
    {
        QFETCH(const QByteArray, elements);
        QFETCH(const int, grey);
        const app::Style style = shapeOf(elements).style;
        const auto colour = style.fill ? style.fill : style.stroke;
        QVERIFY(colour);
        QVERIFY2(std::abs(colour->red - grey) <= 2, qPrintable(QString::number(colour->red)));
        QCOMPARE(colour->green, colour->red);
        QCOMPARE(colour->alpha, 255);
    }

    void transparentStopsCount()
    {
        const auto fill = shapeOf(linear({}, "<stop stop-color='red'/><stop offset='1' "
                                             "stop-color='#00f' stop-opacity='0'/>")
                                  + "<rect width='8' height='4' fill='url(#g)'/>")
                              .style.fill;
        QVERIFY(fill);
        QVERIFY(std::abs(fill->alpha - 127) <= 1);
        QVERIFY(std::abs(fill->red - 170) <= 2); // more opaque where it is red
        QVERIFY(std::abs(fill->blue - 85) <= 2);
    }

    void isTold()
    {
        const QByteArray box = "<rect width='8' height='4' fill='url(#g)'/>";
        QCOMPARE(reportOf(linear({}) + box), "1 gradient");
        QCOMPARE(readText(drawing(linear({}) + box)).value->report.at(0).instead,
                 "its mean colour is used");
        QCOMPARE(reportOf(linear({}, "<stop stop-color='red'/><stop offset='1' "
                                     "stop-color='#f00'/>")
                          + box),
                 "");
    }

    void pointsFillAreas()
    {
        const std::vector<Subpath> nested{square(0, 10), square(2, 4)};
        const double row = 10.0 / 40;
        QCOMPARE(weightOf(pointsInside(nested, FillRule::NonZero, 40)) * row, 100.0);
        QCOMPARE(weightOf(pointsInside(nested, FillRule::EvenOdd, 40)) * row, 96.0);
        QCOMPARE(weightOf(pointsAlong(nested, 40)), 48.0);
        QCOMPARE(pointsInside({}, FillRule::NonZero, 40).size(), std::size_t(0));
        const std::vector<Subpath> flat{{{0, 0}, {{{9, 0}}, {{3, 0}}}, true}};
        QCOMPARE(pointsInside(flat, FillRule::NonZero, 40).size(), std::size_t(0));
    }
};

} // namespace formats_svg_gradient_test

TEST_CLASS(formats_svg_gradient_test::GradientTest, None)
#include "tests/app/formats/svg/gradient_test.moc"
