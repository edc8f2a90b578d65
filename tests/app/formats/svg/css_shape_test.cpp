// SPDX-License-Identifier: GPL-3.0-or-later
// The shapes of CSS as clip paths, in every box they may refer to.
#include <QTest>

#include "tests/app/formats/svg/lengths_of.h"
#include "tests/test_class.h"

namespace formats_svg_css_shape_test {

class CssShapeTest : public QObject {
    Q_OBJECT

private slots:
    // The area of a square from (10, 10) to (90, 90) that is left.
    void shapes_data()
    {
        QTest::addColumn<QByteArray>("shape");
        QTest::addColumn<double>("left");
        const auto row = [](const QByteArray& shape, double left) {
            QTest::addRow("%s", shape.constData()) << shape << left;
        };
        const double pi = std::acos(-1.0);
        row("circle(20px)", 400 * pi);
        row("circle()", 1600 * pi);
        row("circle(25%)", 400 * pi);
        row("circle(closest-side at 30px 50%)", 900 * pi);
        row("CIRCLE(20px AT LEFT TOP)", 100 * pi);
        row("circle(20px at right 20px bottom 20px)", 400 * pi);
        row("circle(farthest-side at 0 0)", 1600 * pi);
        row("ellipse(20px 10px)", 200 * pi);
        row("ellipse(25% closest-side at center)", 800 * pi);
        row("inset(10px)", 3600);
        row("inset(10px 20px 30px 40px)", 800);
        row("inset(0 50% 0 0)", 3200);
        row("inset(60px)", 0);
        row("inset(0 round 40px)", 1600 * pi);
        row("inset(0 round 100px)", 1600 * pi);
        row("inset(0 round 10px 0 0 0 / 20px 0 0 0)", 6400 - (200 - 50 * pi));
        row("rect(10px 70px 60px 20px)", 2500);
        row("rect(auto 40px auto auto)", 3200);
        row("xywh(10px 20px 30px 40px)", 1200);
        row("xywh(0 0 100% 50% round 5px)", 3200 - (100 - 25 * pi));
        row("polygon(0 0, 100% 0, 0 100%)", 3200);
        row("polygon(evenodd, 0 0, 80px 0, 80px 80px, 0 80px, 0 0, 20px 20px, 60px 20px, 60px "
            "60px, 20px 60px, 20px 20px)",
            4800);
        row("path('M0 0H40V40H0z')", 1600);
        row("path(evenodd, \"M0 0H80V80H0zM20 20H60V60H20z\")", 4800);
        row("fill-box", 6400);
        row("inset(25px) view-box", 2500);
        row("view-box inset(25px)", 2500);
        row("inset(0 50% 0 0) stroke-box", 3200);
    }
    void shapes()
    {
        QFETCH(QByteArray, shape);
        QFETCH(double, left);
        const QByteArray square = "<rect x='10' y='10' width='80' height='80' style=\"clip-path:"
                                  + shape.replace('"', "&quot;") + "\"/>";
        const double area = areaOf(square);
        QVERIFY2(std::abs(area - left) < 0.003 * left + 0.01, qPrintable(QString::number(area)));
    }

    // Without a name, the box is that of the stroke.
    void strokesCount()
    {
        const auto cut = [](const QByteArray& shape) {
            return areaOf("<rect x='20' y='20' width='60' height='60' stroke='red' "
                          "stroke-width='20' style='clip-path:"
                          + shape + "'/>");
        };
        QCOMPARE(cut("inset(0 50% 0 0)"), 1800.0);
        QCOMPARE(cut("inset(0 0 0 10px)"), 3600.0);
        QCOMPARE(cut("inset(0 0 0 10px) fill-box"), 3000.0);
        QCOMPARE(cut("polygon(0 0, 40px 0, 40px 80px, 0 80px)"), 1800.0);
    }

    void whatIsNotUnderstoodIsTold_data()
    {
        QTest::addColumn<QByteArray>("shape");
        for (const char* shape :
             {"circle(20)", "circle(-1px)", "circle(1px 2px)", "ellipse(1px)", "inset()",
              "inset(1px round)", "inset(0 round 0 0 0 0 0)", "rect(1px)", "xywh(0 0 -1px 1px)",
              "polygon(1px)", "polygon()", "path(M0 0)", "path('M0 0L')", "star(5px)",
              "circle(1px) middle-box", "fill-box circle(1px) fill-box"})
            QTest::addRow("%s", shape) << QByteArray(shape);
    }
    void whatIsNotUnderstoodIsTold()
    {
        QFETCH(QByteArray, shape);
        const QByteArray elements =
            "<rect width='80' height='80' style=\"clip-path:" + shape + "\"/>";
        QCOMPARE(reportOf(elements),
                 QString("1 value “clip-path: " + shape + "” that is not understood"));
        QCOMPARE(areaOf(elements), 6400.0);
    }
};

} // namespace formats_svg_css_shape_test

TEST_CLASS(formats_svg_css_shape_test::CssShapeTest, Core)
#include "tests/app/formats/svg/css_shape_test.moc"
