// SPDX-License-Identifier: GPL-3.0-or-later
// Markers become shapes beside their lines. picture_test compares them with librsvg.
#include "app/formats/svg/marker_vertices.h"

#include <QTest>

#include <cmath>

#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace formats_svg_marker_test {

using namespace app::svg;
using app::Point;

namespace {

// The vertices of a path as "S0,0@0 M5,0@45 E5,5@90".
QString vertices(const char* data)
{
    QStringList all;
    for (const MarkerVertex& vertex : markerVertices(parsePathData(data)))
        all << QStringLiteral("%1%2,%3@%4")
                   .arg("SME"[int(vertex.kind)])
                   .arg(vertex.at.x)
                   .arg(vertex.at.y)
                   .arg(std::round(vertex.angle * 180 / std::acos(-1.0)));
    return all.join(' ');
}

const QByteArray square = "<marker id='m' markerWidth='2' markerHeight='2' refX='1' refY='1'>"
                          "<path d='M0 0H2V2H0z'/></marker>";

// The objects of the elements as "0,0 2,2": the box of each.
QString boxes(const QByteArray& elements)
{
    QStringList all;
    const auto result = readText(drawing(elements));
    if (!result)
        return result.error;
    const app::Objects& objects = result.value->document.objects();
    for (std::size_t i = 0; i < objects.size(); ++i) {
        Point min{1e9, 1e9}, max{-1e9, -1e9};
        objects[i].path().forEachPoint([&](const Point& p) {
            min = {std::min(min.x, p.x), std::min(min.y, p.y)};
            max = {std::max(max.x, p.x), std::max(max.y, p.y)};
        });
        all << QStringLiteral("%1,%2 %3,%4").arg(min.x).arg(min.y).arg(max.x).arg(max.y);
    }
    return all.join("; ");
}

QByteArray marked(const QByteArray& attributes)
{
    return "<path d='M10 10H20' fill='none' stroke='#000' " + attributes + "/>";
}

} // namespace

class MarkerTest : public QObject {
    Q_OBJECT
private slots:
    void verticesOfPaths()
    {
        QCOMPARE(vertices("M0 0H5V5"), "S0,0@0 M5,0@45 E5,5@90");
        QCOMPARE(vertices("M0 0H5V5H0z"), "S0,0@-45 M5,0@45 M5,5@135 M0,5@-135 E0,0@-45");
        QCOMPARE(vertices("M0 0H5M0 9H5"), "S0,0@0 M5,0@0 M0,9@0 E5,9@0");
        QCOMPARE(vertices("M0 0C0 5 5 5 5 0"), "S0,0@90 E5,0@-90");
        QCOMPARE(vertices("M0 0C0 0 5 5 5 5"), "S0,0@45 E5,5@45");
        QCOMPARE(vertices("M0 0H5H5V5"), "S0,0@0 M5,0@0 M5,0@45 E5,5@90"); // one has no length
        QCOMPARE(vertices("M0 0H5H0"), "S0,0@0 M5,0@0 E0,0@180");          // it turns back
        QCOMPARE(vertices("M0 0A5 5 0 1 1 10 0A5 5 0 1 1 0 0H9"),
                 "S0,0@-90 M10,0@90 M0,0@-45 E9,0@0"); // arcs are several curves
        QCOMPARE(vertices(""), "");
    }

    void placesAndSizes()
    {
        QCOMPARE(boxes(square + marked("marker-end='url(#m)'")), "10,10 20,10; 19,9 21,11");
        QCOMPARE(boxes(square + marked("style='marker:url(#m)' stroke-width='2'")),
                 "10,10 20,10; 8,8 12,12; 18,8 22,12");
        QCOMPARE(boxes("<marker id='m' markerUnits='userSpaceOnUse' markerWidth='4' "
                       "markerHeight='4' viewBox='0 0 2 2' refX='right' refY='top'>"
                       "<path d='M0 0H2V2H0z'/></marker>"
                       + marked("marker-end='url(#m)' stroke-width='2'")),
                 "10,10 20,10; 16,10 20,14");
        QCOMPARE(boxes("<marker id='m' markerWidth='2' markerHeight='2' orient='90'>"
                       "<path d='M0 0H2V1H0z'/></marker>"
                       + marked("marker-end='url(#m)'")),
                 "10,10 20,10; 19,10 20,12");
        QCOMPARE(boxes("<marker id='m' markerWidth='2' markerHeight='2' "
                       "orient='auto-start-reverse'><path d='M0 0H2V1H0z'/></marker>"
                       + marked("style='marker:url(#m)'")),
                 "10,10 20,10; 8,9 10,10; 20,10 22,11");
    }

    void areCutAtTheirViewports()
    {
        const QByteArray wide = "<path d='M-5 0H2V1H-5z'/></marker>";
        QCOMPARE(boxes("<marker id='m' markerWidth='2' markerHeight='2'>" + wide
                       + marked("marker-end='url(#m)'")),
                 "10,10 20,10; 20,10 22,11");
        QCOMPARE(boxes("<marker id='m' markerWidth='2' markerHeight='2' overflow='visible'>" + wide
                       + marked("marker-end='url(#m)'")),
                 "10,10 20,10; 15,10 22,11");
    }

    void coloursOfTheirLines()
    {
        const auto result = readText(
            drawing("<marker id='m' markerWidth='2' markerHeight='2' overflow='visible'>"
                    "<path d='M0 0H2V1' fill='context-stroke' stroke='context-fill'/></marker>"
                    "<g color='#00f'><path d='M0 0H9V9' fill='#f00' stroke='currentColor' "
                    "marker-end='url(#m)'/></g>"));
        QVERIFY(result);
        const app::Style style = result.value->document.objects()[1].style();
        QVERIFY(style.fill && style.stroke);
        QVERIFY(*style.fill == (app::Colour{0, 0, 255}));
        QVERIFY(*style.stroke == (app::Colour{255, 0, 0}));
    }

    void inMarkers()
    {
        QCOMPARE(boxes(square
                       + "<marker id='n' markerWidth='9' markerHeight='9' overflow='visible'>"
                         "<path d='M0 0H5' stroke='#000' marker-end='url(#m)'/></marker>"
                       + marked("marker-end='url(#n)'")),
                 "10,10 20,10; 20,10 25,10; 24,9 26,11");
        QCOMPARE(boxes("<marker id='m' markerWidth='9' markerHeight='9' overflow='visible'>"
                       "<path d='M0 0H5' stroke='#000' marker-end='url(#m)'/></marker>"
                       + marked("marker-end='url(#m)'")),
                 "10,10 20,10; 20,10 25,10"); // never in itself
    }

    void areToldAndGrouped()
    {
        QCOMPARE(reportOf(square + marked("style='marker:url(#m)'")),
                 "2 arrowheads or other markers became shapes beside their lines");
        const auto result = readText(drawing(square + marked("id='a' style='marker:url(#m)'")));
        QVERIFY(result);
        QVERIFY(textOf(result.value->document).contains("clearcut:group"));
        QCOMPARE(result.value->document.objects()[0].particulars().id, "a");
        QCOMPARE(reportOf(marked("marker-end='url(#gone)'")), "1 arrowhead or other marker");
    }

    void onBasicShapes()
    {
        const QByteArray marks = " fill='none' stroke='#000' marker-mid='url(#m)'/>";
        QCOMPARE(boxes(square + "<rect x='10' y='10' width='5' height='5'" + marks),
                 "10,10 15,15; 14,9 16,11; 14,14 16,16; 9,14 11,16");
        QCOMPARE(boxes(square + "<circle cx='20' cy='20' r='5'" + marks),
                 "15,15 25,25; 19,24 21,26; 14,19 16,21; 19,14 21,16");
    }

    void percentagesReferToTheViewport()
    {
        QCOMPARE(boxes("<marker id='m' markerWidth='2%' markerHeight='2%' refX='1%' refY='1%' "
                       "viewBox='0 0 2 2'><path d='M0 0H2V2H0z'/></marker>"
                       + marked("marker-end='url(#m)'")),
                 "10,10 20,10; 19,9 21,11");
    }

    void inheritedOverflowIsVisible()
    {
        QCOMPARE(boxes("<marker id='m' markerWidth='2' markerHeight='2' overflow='inherit'>"
                       "<path d='M-5 0H2V1H-5z'/></marker>"
                       + marked("marker-end='url(#m)'")),
                 "10,10 20,10; 15,10 22,11");
    }

    void attributeOfAllMarkersIsNone()
    {
        QCOMPARE(boxes(square + marked("marker='url(#m)'")), "10,10 20,10");
    }

    void paintOrder()
    {
        const auto painted = [](const QByteArray& order) {
            return boxes(square
                         + "<path d='M10 10H20V20' fill='red' stroke='#000' marker-end='url(#m)' "
                           "paint-order='"
                         + order + "'/>");
        };
        const QString shape = "10,10 20,20", mark = "19,19 21,21";
        QCOMPARE(painted("normal"), shape + "; " + mark);
        QCOMPARE(painted("markers"), mark + "; " + shape);
        QCOMPARE(painted("markers stroke"), mark + "; " + shape + "; " + shape);
        QCOMPARE(painted("fill markers"), shape + "; " + mark + "; " + shape);
        QCOMPARE(painted("stroke markers"), shape + "; " + mark + "; " + shape);
        QCOMPARE(painted("stroke stroke"), shape + "; " + mark); // not understood
    }

    void manyEnd()
    {
        const QByteArray path =
            "<path d='M0 0" + QByteArray("h1").repeated(600'000) + "' marker-mid='url(#m)'/>";
        const auto result = readText(drawing(square + path));
        QVERIFY(!result);
        QVERIFY2(result.error.contains("exceeds the limit"), qPrintable(result.error));
    }
};

} // namespace formats_svg_marker_test

TEST_CLASS(formats_svg_marker_test::MarkerTest, None)
#include "tests/app/formats/svg/marker_test.moc"
