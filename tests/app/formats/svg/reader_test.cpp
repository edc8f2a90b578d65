// SPDX-License-Identifier: GPL-3.0-or-later
// Pages, layers, hidden things, transforms, <use>, viewports, clip paths, and the report.
#include <QTest>

#include "tests/app/formats/svg/text.h"

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
        for (int size = 1; size <= 5000; ++size) {
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
                 "1 transform that is not understood");
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

    void clipPathsAreCutForReal()
    {
        const auto cut = [](const QByteArray& clip, const QByteArray& element) {
            return pathsOf("<clipPath id='c'>" + clip + "</clipPath><g clip-path='url(#c)'>"
                           + element + "</g>");
        };
        const QByteArray box = "<rect x='10' y='10' width='20' height='20'/>";
        const QByteArray line = "<path d='M0 20L40 20' fill='none' stroke='red'/>";
        QCOMPARE(cut(box, line), "10,20 30,20");
        QCOMPARE(cut(box, "<path d='M0 0L5 9' stroke='red'/>"), "");
        QCOMPARE(cut(box, "<path d='M12 12L20 20' fill='red'/>"), "12,12 20,20");
        QCOMPARE(cut(box, "<path d='M0 20H15V40H25V20H40' fill='none' stroke='red'/>"),
                 "10,20 15,20 15,30 | 25,30 25,20 30,20");
        QCOMPARE(cut(box, "<path d='M20 0H40V40H20z' fill='red'/>"), "30,10 30,30 20,30 20,10 z");
        QCOMPARE(cut("<path d='M20 0L40 20 20 40 0 20z'/>",
                     "<path d='M0 10H40' stroke='red' fill='none'/>"),
                 "10,10 30,10");
        QCOMPARE(cut("<path d='M20 0L0 20 20 40 40 20z'/>",
                     "<path d='M0 10H40' stroke='red' fill='none'/>"),
                 "10,10 30,10");
        QCOMPARE(cut("", line), "");
        QCOMPARE(pathsOf("<clipPath id='c'>" + box
                         + "</clipPath><path clip-path='url(#gone)' d='M0 0H9'/>"),
                 "0,0 9,0");
        QCOMPARE(reportOf("<clipPath id='c'>" + box
                          + "</clipPath><g clip-path='url(#c)'/><g clip-path='url(#c)'/>"),
                 "2 clip paths were replaced by real cuts");
        const QByteArray lost = "1 clip path that is not convex";
        for (const QByteArray clip :
             {"<path d='M0 0H9L4 4 9 9H0z'/>", "<path d='M0 0L9 9 9 0 0 9z'/>", "<text>x</text>",
              "<rect width='1' height='1'/><rect width='1' height='1'/>"}) {
            const QByteArray elements =
                "<clipPath id='c'>" + clip + "</clipPath><g clip-path='url(#c)'>" + line + "</g>";
            QCOMPARE(reportOf(elements), lost);
            QCOMPARE(pathsOf(elements), "0,20 40,20");
        }
    }

    void cutCurvesStayCurves()
    {
        const auto shape = shapeOf("<clipPath id='c'><rect width='50' "
                                   "height='100'/></clipPath><circle cx='50' cy='50' r='20' "
                                   "fill='none' stroke='red' clip-path='url(#c)'/>");
        QCOMPARE(text(shape.paths), "50,70 ~30,50 ~50,30");
    }

    void filledAndStrokedShapesBecomeTwo()
    {
        const auto result =
            readText(drawing("<clipPath id='c'><rect width='50' height='100'/></clipPath><rect "
                             "id='r' x='40' y='10' width='20' "
                             "height='20' fill='red' stroke='blue' clip-path='url(#c)'/>"));
        const auto& shapes = app::sheetOf(result.value->document).shapes;
        QCOMPARE(shapes.size(), 2u);
        QCOMPARE(text(shapes[0].paths), "40,10 50,10 50,30 40,30 z");
        QVERIFY(shapes[0].style.fill && !shapes[0].style.stroke && shapes[0].id == "r");
        QCOMPARE(text(shapes[1].paths), "50,30 40,30 40,10 50,10");
        QVERIFY(!shapes[1].style.fill && shapes[1].style.stroke && shapes[1].id.isEmpty());
    }

    void whatCannotBeKeptIsReported()
    {
        QCOMPARE(reportOf("<text/><text/><image/><foreignObject/><script/><path d='M0 0h1' "
                          "mask='url(#m)' filter='url(#f)' "
                          "marker-end='url(#e)'><animate/></path>"),
                 "2 texts; 1 image; 1 foreign object; 1 script; 1 mask; 1 filter; 1 arrowhead or "
                 "other marker");
        QCOMPARE(reportOf("<path d='M0 0h1h1' marker='url(#e)'/>"),
                 "3 arrowheads or other markers");
        QCOMPARE(
            readText(drawing("<path d='M0 0h1h1' marker='url(#e)'/>")).value->report.at(0).instead,
            "their lines are kept");
        QCOMPARE(
            reportOf("<title/><desc/><metadata/><defs><text/></defs><unknown><text/></unknown>"),
            "");
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

QTEST_APPLESS_MAIN(ReaderTest)
#include "reader_test.moc"
