// SPDX-License-Identifier: GPL-3.0-or-later
// Pages, layers, hidden things, transforms, <use>, viewports, and the report.
#include <QTest>

#include "tests/app/formats/lossy.h"
#include "tests/app/formats/svg/text.h"
#include "tests/deep.h"
#include "tests/test_class.h"

namespace formats_svg_reader_test {

namespace {

app::Sheet sheetOf(const QByteArray& text)
{
    const auto result = readText(text);
    return result ? app::sheetOf(result.value->document) : app::Sheet{};
}

app::Page page(const QByteArray& attributes)
{
    return sheetOf("<svg " + attributes + "><path d='M10 20L40 80'/></svg>").page;
}

// The paths as text: "0,0 9,9 | 1,1 2,2 z".
QString text(const std::vector<app::Subpath>& paths)
{
    QStringList all;
    for (const app::Subpath& path : paths) {
        const auto number = [](double x) {
            return QString::number(std::round(x * 1e6) / 1e6 + 0.0, 'g', 9);
        };
        QStringList points{number(path.start.x) + ',' + number(path.start.y)};
        for (const app::PathSegment& segment : path.segments)
            points << (segment.curved ? "~" : "") + number(segment.to.x) + ','
                          + number(segment.to.y);
        all << points.join(' ') + (path.closed ? " z" : "");
    }
    return all.join(" | ");
}

QString pathsOf(const QByteArray& elements) { return text(shapeOf(elements).paths); }

QString layersOf(const app::Sheet& sheet)
{
    QStringList all;
    for (std::uint32_t i = 0; i < sheet.layers.size(); ++i) {
        const auto count = std::ranges::count(sheet.shapes, i, &app::Shape::layer);
        all << QStringLiteral("%1 %2%3%4")
                   .arg(sheet.layers[i].name)
                   .arg(count)
                   .arg(sheet.layers[i].visible ? "" : " invisible",
                        sheet.layers[i].locked ? " locked" : "");
    }
    return all.join(", ");
}

} // namespace

class ReaderTest : public QObject {
    Q_OBJECT

private slots:
    void pages()
    {
        using app::Unit;
        QCOMPARE(page("width='15cm' height='200mm' viewBox='1 2 3 4'"),
                 (app::Page{{1, 2}, {3, 4}, {15, Unit::Cm}, {200, Unit::Mm}}));
        QCOMPARE(page("width='200' height='100px'"),
                 (app::Page{{0, 0}, {200, 100}, {200, Unit::Px}, {100, Unit::Px}}));
        QCOMPARE(page("width='1in' height='1in'").size, (app::Point{96, 96}));
        QCOMPARE(page("viewBox='0 0 50 60'"),
                 (app::Page{{0, 0}, {50, 60}, {100, Unit::Percent}, {100, Unit::Percent}}));
        QCOMPARE(page("viewBox='0 0 0 60' width='5' height='6'").size, (app::Point{5, 6}));
        QCOMPARE(page("viewBox='0,0,50,60' width='-3'").width, (app::Length{100, Unit::Percent}));
        const app::Page open = page(""); // what is drawn ends at 40,80
        QCOMPARE(open, (app::Page{{0, 0}, {40, 80}, {40, Unit::Px}, {80, Unit::Px}}));
        QCOMPARE(page("width='100%' height='100%'"), open);
        QCOMPARE(page("height='5'"), (app::Page{{0, 0}, {40, 5}, {40, Unit::Px}, {5, Unit::Px}}));
        QCOMPARE(sheetOf("<svg/>").page, app::Page{});
        const app::Page uneven =
            page("width='100' height='100' viewBox='0 10 100 50' preserveAspectRatio='none'");
        QCOMPARE(uneven.min, (app::Point{0, 20}));
        QCOMPARE(uneven.size, (app::Point{100, 100}));
    }

    // Where SVG's default, xMidYMid meet, and every other preserveAspectRatio puts a view box of
    // 100 by 100 units on a sheet of 200 mm by 100 mm, a unit being 1 mm or, with slice, 2 mm.
    void thePageIsTheSheet_data()
    {
        QTest::addColumn<QByteArray>("aspect");
        QTest::addColumn<app::Page>("expected");
        using app::Unit;
        const app::Length wide{200, Unit::Mm}, high{100, Unit::Mm};
        const auto row = [&](const char* aspect, const app::Point& min, const app::Point& size) {
            QTest::newRow(aspect) << QByteArray(aspect) << app::Page{min, size, wide, high};
        };
        row("", {-40, 20}, {200, 100});
        row("xMidYMid", {-40, 20}, {200, 100});
        row("defer xMidYMin meet", {-40, 20}, {200, 100});
        row("xMinYMid", {10, 20}, {200, 100});
        row("xMaxYMax", {-90, 20}, {200, 100});
        row("xMidYMid slice", {10, 45}, {100, 50});
        row("xMinYMin slice", {10, 20}, {100, 50});
        row("xMaxYMax slice", {10, 70}, {100, 50});
    }
    void thePageIsTheSheet()
    {
        QFETCH(QByteArray, aspect);
        QFETCH(app::Page, expected);
        const auto of = [&](const QByteArray& box) {
            return page("width='200mm' height='100mm' viewBox='" + box + "' preserveAspectRatio='"
                        + aspect + "'");
        };
        QCOMPARE(of("10 20 100 100"), expected);
        // Read again it is the same, and what is written with few decimals stays as it is.
        app::Sheet sheet;
        sheet.page = expected;
        QCOMPARE(sheetOf(textOf(sheet)).page, expected);
        QCOMPARE(of("10 20 756 378.01").size, (app::Point{756, 378.01}));
    }

    void pagesInPixelsAreExact()
    {
        for (int size = 1; size <= 5000; size += tests::caseStep()) {
            const QByteArray n = QByteArray::number(size);
            const double pixels = size;
            const app::Page bare = page("width='" + n + "' height='" + n + "'");
            QCOMPARE(bare.size, (app::Point{pixels, pixels}));
            QCOMPARE(bare.millimetresPerUnit(), 25.4 / 96);
            QCOMPARE(page("width='" + n + "px' height='" + n + "px'"), bare);
            const app::Page boxed =
                page("width='" + n + "mm' height='" + n + "mm' viewBox='0 0 " + n + ' ' + n + "'");
            QCOMPARE(boxed.size, (app::Point{pixels, pixels}));
            QCOMPARE(boxed.millimetresPerUnit(), 1.0);
        }
    }

    void aDrawingWithoutPageKeepsItsPlace()
    {
        // To the user origin, where programs put the corner, and written with that size.
        const auto imported = [](const QByteArray& d) {
            return *readText("<svg xmlns='http://www.w3.org/2000/svg' width='100%' height='100%'>"
                             "<path d='"
                             + d + "' stroke='red' fill='none' stroke-width='0'/></svg>")
                        .value;
        };
        const app::Imported right = imported("M10 20L30 60");
        const app::Page page = right.document.page();
        QCOMPARE(page.rectangle(), (clipping::Window{{0, 0}, {30, 60}}));
        QVERIFY(right.drawn == page.rectangle());
        QVERIFY(textOf(right.document)
                    .contains("width=\"30px\" height=\"60px\" viewBox=\"0 0 30 60\""));
        // What is left of the page is not lost to a cut that names no window.
        const app::Imported around = imported("M-10 -20L30 60");
        QCOMPARE(around.document.page(), page);
        QVERIFY(around.drawn == (clipping::Window{{-10, -20}, {30, 60}}));
        const auto again = readText(textOf(around.document));
        QVERIFY(again.value->document == around.document);
        QVERIFY(!again.value->drawn);
    }

    void layers()
    {
        const QByteArray p = "<path d='M0 0h1'/>";
        const auto layer = [](const QByteArray& attributes, const QByteArray& content) {
            return "<g inkscape:groupmode='layer' " + attributes + ">" + content + "</g>";
        };
        const auto read = [&](const QByteArray& text) { return layersOf(sheetOf(drawing(text))); };
        QCOMPARE(read(""), "Drawing 0");
        QCOMPARE(read(p + "<g>" + p + "</g>"), "Drawing 2");
        QCOMPARE(read(layer("inkscape:label='A'", "") + layer("id='b'", p)), "A 0, b 1");
        QCOMPARE(read(p + layer("inkscape:label='A'", p) + p + layer("inkscape:label='B'", p) + p),
                 "Drawing 1, A 1, Drawing (2) 1, B 1, Drawing (3) 1");
        QCOMPARE(read(layer("inkscape:label='A'", p + layer("inkscape:label='B'", p) + p + p)),
                 "A 1, B 1, A (2) 2");
        QCOMPARE(read(layer("inkscape:label='A' style='display:none'", p)), "A 1 invisible");
        QCOMPARE(read("<g xmlns:s='http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd'>"
                      + layer("inkscape:label='A' s:insensitive='true'", p) + "</g>"),
                 "A 1 locked");
        const app::Sheet invisible =
            sheetOf(drawing(layer("display='none'", p + layer("inkscape:label='B'", p))));
        QVERIFY(!invisible.shapes.at(0).hidden && !invisible.shown(invisible.shapes.at(0)));
        QVERIFY(!invisible.shown(invisible.shapes.at(1)));
    }

    void hiddenThings()
    {
        const auto hidden = [](const QByteArray& text) { return shapeOf(text).hidden; };
        QVERIFY(!hidden("<path d='M0 0h1'/>"));
        QVERIFY(hidden("<path d='M0 0h1' display='none'/>"));
        QVERIFY(hidden("<g style='display:none'><path d='M0 0h1' display='inline'/></g>"));
        QVERIFY(hidden("<g visibility='hidden'><path d='M0 0h1'/></g>"));
        QVERIFY(!hidden("<g visibility='hidden'><path d='M0 0h1' visibility='visible'/></g>"));
        QVERIFY(hidden("<path d='M0 0h1' visibility='collapse'/>"));
    }

    void transforms()
    {
        const auto moved = [](const QByteArray& transform) {
            return pathsOf("<path d='M1 2L3 4' transform='" + transform + "'/>");
        };
        QCOMPARE(moved(""), "1,2 3,4");
        QCOMPARE(moved("translate(10)"), "11,2 13,4");
        QCOMPARE(moved(" translate( 10 , 20 ) "), "11,22 13,24");
        QCOMPARE(moved("scale(2)"), "2,4 6,8");
        QCOMPARE(moved("scale(2 -1)"), "2,-2 6,-4");
        QCOMPARE(moved("rotate(90)"), "-2,1 -4,3");
        QCOMPARE(moved("rotate(180 1 2)"), "1,2 -1,0");
        QCOMPARE(moved("skewX(45)"), "3,2 7,4");
        QCOMPARE(moved("skewY(45)"), "1,3 3,7");
        QCOMPARE(moved("matrix(1 2 3 4 5 6)"), "12,16 20,28");
        QCOMPARE(moved("translate(10)scale(2)"), "12,4 16,8");
        QCOMPARE(moved("scale(2),translate(10)"), "22,4 26,8");
        QCOMPARE(moved("translate(1e1-1)"), "11,1 13,3");
        QCOMPARE(moved("turn(3)"), "1,2 3,4");
        QCOMPARE(
            pathsOf("<path d='M1 2L3 4' style='transform:translate(10px,1px) rotate(90deg)'/>"),
            "8,2 6,4");
        QCOMPARE(pathsOf("<path d='M1 2L3 4' transform='scale(0)'/>"), "");
        QCOMPARE(reportOf("<path d='M1 2L3 4' transform='turn(3)'/>"),
                 "1 value “transform: turn(3)” that is not understood");
    }

    // By CSS Transforms: the place of the origin, the box it refers to, units, separate properties.
    void transformsOfCss_data()
    {
        QTest::addColumn<QByteArray>("style");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* style, const char* expected) {
            QTest::newRow(style) << QByteArray(style) << QString(expected);
        };
        row("transform:scale(2)", "40,40 60,40 60,60 40,60 z");
        row("transform:scale(2);transform-origin:20px 20px", "20,20 40,20 40,40 20,40 z");
        row("transform:scale(2);transform-origin:20% 20%", "20,20 40,20 40,40 20,40 z");
        row("transform:scale(2);transform-origin:left top", "40,40 60,40 60,60 40,60 z");
        row("transform:scale(2);transform-origin:bottom right",
            "-60,-60 -40,-60 -40,-40 -60,-40 z");
        row("transform:scale(2);transform-origin:center", "-10,-10 10,-10 10,10 -10,10 z");
        row("transform:scale(2);transform-box:fill-box", "20,20 40,20 40,40 20,40 z");
        row("transform:scale(2);transform-box:fill-box;transform-origin:center",
            "15,15 35,15 35,35 15,35 z");
        row("transform:rotate(.25turn);transform-box:fill-box;transform-origin:100% 0",
            "30,10 30,20 20,20 20,10 z");
        row("transform:translate(50%,-1in);transform-box:fill-box",
            "25,-76 35,-76 35,-66 25,-66 z");
        row("transform:translate(50%)", "70,20 80,20 80,30 70,30 z");
        row("transform:translateX(1px) translatey(2px)", "21,22 31,22 31,32 21,32 z");
        row("transform:skew(45deg,0)", "40,20 50,20 60,30 50,30 z");
        row("rotate:90deg", "-20,20 -20,30 -30,30 -30,20 z");
        row("rotate:z 100grad", "-20,20 -20,30 -30,30 -30,20 z");
        row("translate:1px", "21,20 31,20 31,30 21,30 z");
        row("scale:200% 1", "40,20 60,20 60,30 40,30 z");
        row("translate:1px 2px;rotate:90deg;scale:2;transform:translate(3px)",
            "-39,48 -39,68 -59,68 -59,48 z");
        row("rotate:none;translate:none;scale:none;transform:none", "20,20 30,20 30,30 20,30 z");
    }
    void transformsOfCss()
    {
        QFETCH(QByteArray, style);
        QFETCH(QString, expected);
        const QByteArray rect =
            "<rect x='20' y='20' width='10' height='10' style='" + style + "'/>";
        QCOMPARE(pathsOf(rect), expected);
        QCOMPARE(reportOf(rect), "");
    }

    void transformsThatAreNotUnderstoodAreTold()
    {
        for (const QByteArray style :
             {"transform:rotateX(9deg)", "transform:translate(9)", "transform:rotate(9)",
              "rotate:x 9deg", "rotate:1 0 0 9deg", "scale:1 2 3", "translate:1px 2px 3px",
              "transform-box:stroke-box", "transform-origin:left left", "transform-origin:9 9"}) {
            const QByteArray rect = "<rect width='10' height='10' style='" + style + "'/>";
            QCOMPARE(pathsOf(rect), "0,0 10,0 10,10 0,10 z");
            QVERIFY2(reportOf(rect).startsWith("1 value “"), style);
        }
        QCOMPARE(pathsOf("<path d='M0 0h1' transform='translate(5)' style='transform:turn(1)'/>"),
                 "5,0 6,0"); // as without it
    }

    // The box of a group is that of its shapes, also through <use>, and in their own places.
    void boxesOfGroups()
    {
        const QByteArray flip = " style='transform:scaleX(-1);transform-box:fill-box;"
                                "transform-origin:center'";
        const QByteArray inside = "<path d='M10 0H20'/><g transform='translate(30)'><path d='M0 0"
                                  "H10'/></g>";
        QCOMPARE(
            sheetOf(drawing("<g" + flip + ">" + inside + "</g>")).shapes.at(0).paths.at(0).start,
            (app::Point{40, 0})); // the box is from 10 to 40
        QCOMPARE(
            pathsOf("<defs><path id='p' d='M0 0H10'/></defs><use href='#p' x='50'" + flip + "/>"),
            "60,0 50,0");
        QCOMPARE(pathsOf("<path d='M0 0C0 40 90 40 90 0'" + flip + "/>"), "90,0 ~0,0");
        QCOMPARE(
            pathsOf("<path d='M0 0C30 40 60 40 90 0' style='transform:scaleY(-1);transform-box:"
                    "fill-box;transform-origin:0 100%'/>"),
            "0,60 ~90,60"); // the curve reaches down to 30, its control points to 40
        QCOMPARE(reportOf("<g" + flip + "><text/><path d='M0 0h1'/></g>"),
                 "1 transform in the box of something with texts or images; 1 text");
        QCOMPARE(reportOf("<g" + flip + "><path d='M0 0h1' style='zip:1'/></g>"),
                 "1 use of the style property “zip”");
    }

    void strokesThatDoNotScaleHaveTheirWidthInPixels()
    {
        const auto result = readText(
            "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' viewBox='0 0 10 "
            "10'><path d='M0 0h1' stroke='red' stroke-width='2' stroke-dasharray='3' "
            "transform='scale(7)' vector-effect='non-scaling-stroke'/></svg>");
        const app::Style style = result.value->document.objects()[0].style();
        QVERIFY(std::abs(style.width * 10 - 2 * 25.4 / 96) < 1e-12); // millimetres
        QVERIFY(std::abs(style.dashes.at(0) * 10 - 3 * 25.4 / 96) < 1e-12);
    }

    void sizesAndPlacesInCss()
    {
        QCOMPARE(pathsOf("<style>circle{r:3px;cx:5px;cy:5px}</style><circle/>"),
                 "8,5 ~5,8 ~2,5 ~5,2 ~8,5 z");
        QCOMPARE(pathsOf("<rect x='9' style='x:1px;y:2px;WIDTH:3px;height:4px'/>"),
                 "1,2 4,2 4,6 1,6 z");
        QCOMPARE(pathsOf("<rect style='width:10%;height:1in;rx:auto'/>"), "0,0 10,0 10,96 0,96 z");
        QCOMPARE(pathsOf("<path d='M9 9h9' style='d:path(\"M1 2L3 4\")'/>"), "1,2 3,4");
        QCOMPARE(pathsOf("<path d='M9 9h9' style='d:none'/>"), "");
        QCOMPARE(
            pathsOf("<defs><path id='p' d='M0 0H1'/></defs><use href='#p' style='x:5px;y:6px'/>"),
            "5,6 6,6");
        QCOMPARE(pathsOf("<svg style='x:5px;width:10px;height:10px'><path d='M0 0H1'/></svg>"),
                 "5,0 6,0");
        QCOMPARE(pathsOf("<circle r='3' cx='5' cy='5' style='r:-1px;cx:7'/>"), // both are invalid
                 "8,5 ~5,8 ~2,5 ~5,2 ~8,5 z");
        QCOMPARE(
            reportOf("<circle r='3' style='r:-1px;cx:7'/>"),
            "1 value “r: -1px” that is not understood; 1 value “cx: 7” that is not understood");
        using app::Unit;
        QCOMPARE(page("style='width:50mm;height:20mm' viewBox='0 0 5 2'"),
                 (app::Page{{0, 0}, {5, 2}, {50, Unit::Mm}, {20, Unit::Mm}}));
    }

    void dashesByPathLength()
    {
        const auto dashes = [](const QByteArray& shape) {
            return shapeOf("<g fill='none' stroke='red'>" + shape + "</g>").style.dashes;
        };
        QCOMPARE(dashes("<path d='M10 20H90' pathLength='1' stroke-dasharray='.1'/>"),
                 std::vector<double>{8});
        QCOMPARE(dashes("<path d='M10 20H90' pathLength='1' stroke-dasharray='.1' "
                        "transform='scale(3)'/>"),
                 std::vector<double>{24});
        QCOMPARE(dashes("<rect width='10' height='10' pathLength='80' stroke-dasharray='2 4'/>"),
                 (std::vector<double>{1, 2}));
        const auto round = dashes("<circle r='25' pathLength='8' stroke-dasharray='1'/>");
        QVERIFY(std::abs(round.at(0) - 2 * 3.14159265358979 * 25 / 8) < 0.01); // Bézier curves
        const auto curved = dashes("<path d='M0 0C0 0 0 100 0 100' pathLength='10' "
                                   "stroke-dasharray='1'/>");
        QVERIFY(std::abs(curved.at(0) - 10) < 1e-7);
        QVERIFY(dashes("<path d='M0 0h9' pathLength='0' stroke-dasharray='1'/>").empty());
        QCOMPARE(dashes("<path d='M0 0h9' pathLength='-1' stroke-dasharray='1'/>"),
                 std::vector<double>{1});
        QCOMPARE(reportOf("<path d='M0 0h9' pathLength='-1' stroke-dasharray='1'/>"),
                 "1 value “pathLength: -1” that is not understood");
    }

    // As SVG 2 says: an element of size 0 or less is not drawn, a negative radius counts as
    // missing.
    void sizesOfZeroOrLessAreTold()
    {
        const QString sizeless =
            "1 element of size 0 or less, which SVG does not draw, was left out";
        for (const QByteArray shape :
             {"<rect width='0' height='9'/>", "<rect width='-5' height='9'/>", "<circle r='-3'/>",
              "<circle/>", "<ellipse rx='0' ry='9'/>", "<path d='M0 0h9' transform='scale(0)'/>",
              "<svg width='0' height='9'><path d='M0 0h9'/></svg>"}) {
            QCOMPARE(pathsOf(shape), "");
            QCOMPARE(reportOf(shape), sizeless);
            QVERIFY(!isLossy(*readText(drawing(shape)).value)); // no program shows it
        }
        QCOMPARE(pathsOf("<rect width='10' height='10' rx='-2'/>"), "0,0 10,0 10,10 0,10 z");
        QCOMPARE(pathsOf("<rect width='10' height='10' rx='-2' ry='5'/>"),
                 pathsOf("<rect width='10' height='10' ry='5'/>"));
        QCOMPARE(pathsOf("<ellipse rx='-3' ry='1'/>"), pathsOf("<circle r='1'/>"));
        QCOMPARE(reportOf("<ellipse rx='-3' ry='1'/>"), "1 part of a damaged shape");
        QCOMPARE(reportOf("<svg viewBox='0 0 0 9'><path d='M0 0h9'/></svg>"),
                 "1 viewBox that is no rectangle was ignored");
    }

    void conditionsOfElements()
    {
        const QByteArray german = "<path d='M1 1h1' systemLanguage='de'/>",
                         english = "<path d='M2 2h1' systemLanguage='fr, en-GB'/>",
                         all = "<path d='M3 3h1'/>",
                         extended = "<path d='M4 4h1' requiredExtensions='urn:x'/>";
        QCOMPARE(pathsOf(german), "");
        QCOMPARE(reportOf(german), "1 element for another language than English");
        QCOMPARE(pathsOf(english), "2,2 3,2");
        QCOMPARE(pathsOf("<switch>" + german + english + all + "</switch>"), "2,2 3,2");
        QCOMPARE(pathsOf("<switch>" + german + all + english + "</switch>"), "3,3 4,3");
        QCOMPARE(reportOf("<switch>" + german + german + all + "</switch>"),
                 "2 elements for other languages than English");
        QCOMPARE(pathsOf("<switch>" + extended + all + "</switch>"), "3,3 4,3");
        const auto result = readText(drawing("<switch>" + extended + all + "</switch>"));
        QCOMPARE(result.value->report.size(), std::size_t(1));
        QVERIFY(!isLossy(*result.value)); // private data of another program
    }

    void sheetsInOtherFilesAreTold()
    {
        const QString lost = "1 reference to another file";
        const auto withInstruction =
            readText("<?xml-stylesheet href='a.css'?>" + drawing("<path d='M0 0h1'/>"));
        QCOMPARE(withInstruction.value->report.at(0).what, "reference to another file");
        QCOMPARE(reportOf("<link xmlns='http://www.w3.org/1999/xhtml' rel='stylesheet'/>"), lost);
        QCOMPARE(reportOf("<path d='M0 0h1v1' fill='url(a.svg#g)'/>"), lost);
        QCOMPARE(reportOf("<path d='M0 0h1v1' clip-path='url(a.svg#g)'/>"), lost);
        QCOMPARE(reportOf("<style>@import url(a.css);</style>"),
                 "1 style rule “@import url(a.css)”");
        QCOMPARE(reportOf("<use/>"), "");
    }

    void otherPaintsAreTold()
    {
        QCOMPARE(reportOf("<hatch id='h'/><path d='M0 0h1v1' fill='url(#h)'/>"),
                 "1 paint of the kind “hatch”");
        QCOMPARE(
            reportOf("<path d='M0 0h1v1' fill='red' stroke='blue' style='paint-order:stroke'/>"),
            "1 stroke below the fill of its shape became a shape of its own");
        QCOMPARE(reportOf("<path d='M0 0h1v1' fill='red' style='paint-order:stroke'/>"), "");
        for (const char* const soft : {"auto", "geometricPrecision"})
            QCOMPARE(reportOf("<path d='M0 0h1v1' shape-rendering='" + QByteArray(soft) + "'/>"),
                     "");
        for (const char* const hard :
             {"shape-rendering='crispEdges'", "style='shape-rendering:optimizeSpeed'"})
            QVERIFY(reportOf("<path d='M0 0h1v1' " + QByteArray(hard) + "/>")
                        .contains("shape-rendering"));
        // Inkscape writes the plain colour before that of a profile.
        QVERIFY(reportOf("<path d='M0 0h1v1' fill='#ff0000 icc-color(cmyk, 0, 1, 1, 0)'/>")
                    .startsWith("1 colour of a colour profile"));
    }

    void miterLimitHasNoUnit()
    {
        QCOMPARE(reportOf("<path d='M0 0h1v1' stroke='#000' stroke-miterlimit='5mm'/>"),
                 "1 value “stroke-miterlimit: 5mm” that is not understood");
        QCOMPARE(
            shapeOf("<path d='M0 0h1v1' stroke='#000' stroke-miterlimit='2e1'/>").style.miterLimit,
            20.0);
    }

    void whatSvgWouldNotDrawAtAllIsReadAndTold()
    {
        const auto told = [](const QByteArray& attributes) {
            const auto result = readText("<svg xmlns='http://www.w3.org/2000/svg' " + attributes
                                         + "><path d='M0 0h1v1'/></svg>");
            return result && result.value->document.objects().size() == 1
                           && result.value->report.size() == 1
                       ? result.value->report[0].what
                       : result.error;
        };
        QCOMPARE(told("width='0' height='9'"), "size of the drawing of 0 or less, with which SVG "
                                               "draws nothing, was ignored");
        QCOMPARE(told("systemLanguage='ru' width='9' height='9'"),
                 "drawing for another language or extension was read all the same");
        QCOMPARE(told("width='wide' height='9'"), "value “width: wide” that is not understood");
    }

    void basicShapes()
    {
        QCOMPARE(pathsOf("<rect x='1' y='2' width='3' height='4'/>"), "1,2 4,2 4,6 1,6 z");
        QCOMPARE(pathsOf("<rect width='10' height='10' rx='2'/>"),
                 "2,0 8,0 ~10,2 10,8 ~8,10 2,10 ~0,8 0,2 ~2,0 z");
        QCOMPARE(pathsOf("<rect width='10' height='10' rx='9' ry='1'/>"),
                 "5,0 ~10,1 10,9 ~5,10 ~0,9 0,1 ~5,0 z");
        QCOMPARE(pathsOf("<rect width='10' height='0'/>"), "");
        QCOMPARE(pathsOf("<circle cx='5' cy='5' r='3'/>"), "8,5 ~5,8 ~2,5 ~5,2 ~8,5 z");
        QCOMPARE(pathsOf("<circle r='0'/>"), "");
        QCOMPARE(pathsOf("<ellipse cx='5' cy='5' rx='3' ry='1'/>"), "8,5 ~5,6 ~2,5 ~5,4 ~8,5 z");
        QCOMPARE(pathsOf("<line x1='10%' y1='1in' x2='1cm' y2='.5'/>"), "10,96 37.795276,0.5");
        QCOMPARE(pathsOf("<line x1='5' x2='5'/>"), "5,0");
        QCOMPARE(pathsOf("<polyline points='1,2 3,4'/>"), "1,2 3,4");
        QCOMPARE(pathsOf("<polygon points='1,2 3,4 5 6'/>"), "1,2 3,4 5,6 z");
    }

    void usedElements()
    {
        const QByteArray defs =
            "<defs><path id='p' d='M0 0L1 1' fill='red'/>"
            "<symbol id='s' viewBox='0 0 10 10'><path d='M0 0L10 10'/></symbol></defs>";
        QCOMPARE(pathsOf(defs + "<use href='#p' x='5' y='6' transform='scale(2)'/>"),
                 "10,12 12,14");
        QCOMPARE(pathsOf(defs + "<use xlink:href='#s' width='50' height='20'/>"), "15,0 35,20");
        QCOMPARE(pathsOf(defs + "<use xlink:href='#s' x='10'/>"), "10,0 110,100");
        QCOMPARE(pathsOf("<svg x='10' y='20' width='50' height='50' viewBox='0 0 5 5'><path d='M0 "
                         "0L1 1'/></svg>"),
                 "10,20 20,30");
        QCOMPARE(pathsOf("<svg width='50' height='20' viewBox='0 0 10 10' "
                         "preserveAspectRatio='xMaxYMin slice' "
                         "overflow='visible'><path d='M0 0L10 10'/></svg>"),
                 "0,0 50,50");
        QCOMPARE(pathsOf("<svg x='50'><line x2='100%'/></svg>"), "50,0 150,0");
        QCOMPARE(pathsOf("<svg x='50' width='20'><line x2='90' stroke='red'/></svg>"), "50,0 70,0");
        QCOMPARE(shapeOf(defs + "<use id='u' href='#p'/>").id, "u");
        QCOMPARE(reportOf(defs + "<use href='#gone'/><use href='other.svg#p'/>"),
                 "1 reference to another file");
    }

    void whatCannotBeKeptIsReported()
    {
        QCOMPARE(reportOf("<text/><text/><image/><foreignObject/><script/><path d='M0 0h1' "
                          "mask='url(#m)' filter='url(#f)' "
                          "marker-end='url(#e)'><animate/></path>"),
                 "2 texts; 1 image; 1 foreign object; 1 script; 1 mask; 1 filter; 1 arrowhead or "
                 "other marker");
        QCOMPARE(reportOf("<path d='M0 0h1h1' style='marker:url(#e)'/>"),
                 "3 arrowheads or other markers");
        QCOMPARE(readText(drawing("<path d='M0 0h1h1' style='marker:url(#e)'/>"))
                     .value->report.at(0)
                     .instead,
                 "their lines are kept");
        QCOMPARE(reportOf("<title/><desc/><metadata/><defs><text/></defs>"), "");
        QCOMPARE(reportOf("<unknown><text/></unknown>"),
                 "1 element “unknown” that SVG does not have was left out");
        QCOMPARE(reportOf("<switch><foreignObject/><path d='M0 0h1'/></switch>"),
                 "1 foreign object was replaced by what the file has in place of it");
        QCOMPARE(reportOf("<switch><foreignObject/><path systemLanguage='xx'/></switch>"),
                 "1 element for another language than English; 1 foreign object");
        QCOMPARE(reportOf("<switch><text/><path d='M0 0'/></switch>"), "1 text");
        QCOMPARE(reportOf("<g xmlns='http://other.example'><text/></g>"), "");
    }

    // What a file says about itself is kept as the file has it, prefixes declared where they are
    // used first, and what is written of it is read as the same again.
    void whatAFileSaysAboutItselfIsKept_data()
    {
        QTest::addColumn<QByteArray>("elements");
        QTest::addColumn<app::About>("about");
        const auto row = [](const char* name, const QByteArray& elements, const app::About& about) {
            QTest::newRow(name) << elements << about;
        };
        row("nothing",
            "<title/><desc> </desc><metadata> <window xmlns='urn:clearcut:1'/></metadata>", {});
        row("title and description",
            "<title>A &amp; B</title><title xml:lang='de'>C</title><desc id='d'>D<b>E</b></desc>",
            {{},
             {},
             "<title>A &amp; B</title>\n<title xml:lang=\"de\">C</title>",
             "<desc id=\"d\">D<b>E</b></desc>",
             {}});
        row("plain text", "<metadata>Created by P</metadata>",
            {{}, {}, {}, {}, "<metadata>Created by P</metadata>"});
        row("attributes of the metadata",
            "<metadata id='m' class='a &lt; b' x:y='z' xmlns:x='urn:x'/><metadata id='n'>B"
            "</metadata>",
            {{},
             {},
             {},
             {},
             "<metadata xmlns:x=\"urn:x\" id=\"m\" class=\"a &lt; b\" x:y=\"z\"/>\n"
             "<metadata id=\"n\">B</metadata>"});
        row("an id around the clip window",
            "<metadata id='m'><window xmlns='urn:clearcut:1' xmin='0' ymin='0' xmax='9' ymax='9'/>"
            "</metadata>",
            {{}, {}, {}, {}, "<metadata id=\"m\"/>"});
        row("text around the clip window",
            "<metadata>A<window xmlns='urn:clearcut:1' xmin='0' ymin='0' xmax='9' ymax='9'>"
            "<x/></window><?p q?><!--c--></metadata><metadata>B</metadata>",
            {{}, {}, {}, {}, "<metadata>A<?p q?><!--c--></metadata>\n<metadata>B</metadata>"});
        row("Dublin Core",
            "<metadata xmlns:dc='http://purl.org/dc/elements/1.1/'>"
            "<r:RDF xmlns:r='http://www.w3.org/1999/02/22-rdf-syntax-ns#'><cc:Work r:about='' "
            "xmlns:cc='http://creativecommons.org/ns#'><dc:creator>&lt;A&gt;</dc:creator>"
            "<cc:license r:resource='http://cc.example/by-sa/4.0/'/></cc:Work></r:RDF></metadata>",
            {{},
             {},
             {},
             {},
             "<metadata xmlns:dc=\"http://purl.org/dc/elements/1.1/\">"
             "<r:RDF xmlns:r=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\"><cc:Work "
             "xmlns:cc=\"http://creativecommons.org/ns#\" r:about=\"\">"
             "<dc:creator>&lt;A&gt;</dc:creator>"
             "<cc:license "
             "r:resource=\"http://cc.example/by-sa/4.0/\"/></cc:Work></r:RDF></metadata>"});
        row("other default namespaces",
            "<metadata><a xmlns='urn:a'><b xmlns=''/><c/></a></metadata>",
            {{}, {}, {}, {}, "<metadata><a xmlns=\"urn:a\"><b xmlns=\"\"/><c/></a></metadata>"});
    }
    void whatAFileSaysAboutItselfIsKept()
    {
        QFETCH(QByteArray, elements);
        QFETCH(app::About, about);
        const auto result = readText(drawing(elements));
        QVERIFY2(result, qPrintable(result.error));
        QVERIFY(result.value->report.empty());
        const app::About& read = result.value->document.about();
        QCOMPARE(read.title, about.title);
        QCOMPARE(read.description, about.description);
        QCOMPARE(read.metadata, about.metadata);
        const QByteArray text = textOf(result.value->document);
        const auto again = readText(text);
        QVERIFY2(again.value->document == result.value->document, text.constData());
        QCOMPARE(textOf(again.value->document), text);
    }

    void withoutANamespaceItIsSvgAsWell()
    {
        const app::Sheet sheet =
            sheetOf("<svg width='9' height='9'><title>T</title><metadata><a/></metadata></svg>");
        QCOMPARE(sheet.about.title, "<title>T</title>");
        QCOMPARE(sheet.about.metadata, "<metadata><a/></metadata>");
        QCOMPARE(sheetOf(textOf(sheet)), sheet);
    }

    void commentsAroundTheRootAndIdsAreKept()
    {
        const app::Sheet sheet =
            sheetOf("<?xml version='1.0'?><!-- SPDX-License-Identifier: CC0-1.0 --><!-- & --><svg "
                    "xmlns='http://www.w3.org/2000/svg' "
                    "xmlns:i='http://www.inkscape.org/namespaces/inkscape' "
                    "id='root' width='9' height='9'><!-- inside --><g i:groupmode='layer' "
                    "i:label='A' id='l'>"
                    "<path id='p' d='M0 0h1'/><g i:groupmode='layer' id='m'><path d='M0 0h2'/></g>"
                    "<path d='M0 0h3'/></g></svg><!-- after -->");
        QCOMPARE(sheet.about.comments,
                 "<!-- SPDX-License-Identifier: CC0-1.0 -->\n<!-- & -->\n<!-- after -->");
        QCOMPARE(sheet.about.id, "root");
        QStringList ids;
        for (const app::Layer& layer : sheet.layers)
            ids << layer.id;
        QCOMPARE(ids, (QStringList{"l", "m", ""}));
        QCOMPARE(sheetOf(textOf(sheet)), sheet);
    }

    void tooMuchMetadataIsALoss()
    {
        const QByteArray much(17'000'000, 'x');
        QCOMPARE(reportOf("<title>T</title><metadata>" + much + "</metadata><desc>D</desc>"),
                 "1 title, description and metadata of more than 16 MB");
    }

    void idsAndNames()
    {
        QCOMPARE(shapeOf("<path id='a&amp;\xc3\xa9' d='M0 0h1'/>").id,
                 QString::fromUtf8("a&\xc3\xa9"));
    }
};

} // namespace formats_svg_reader_test

TEST_CLASS(formats_svg_reader_test::ReaderTest, None)
#include "tests/app/formats/svg/reader_test.moc"
