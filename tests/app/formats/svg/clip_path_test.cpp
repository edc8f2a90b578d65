// SPDX-License-Identifier: GPL-3.0-or-later
// Clip paths of any form are cuts; those that are not are told.
#include <QTest>

#include "tests/app/formats/lossy.h"
#include "tests/app/formats/svg/lengths_of.h"
#include "tests/test_class.h"

namespace formats_svg_clip_path_test {

namespace {

// The paths as text: "0,0 9,9 | 1,1 2,2 z".
QString textOfPaths(const std::vector<app::Subpath>& paths)
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

QString pathsOf(const QByteArray& elements) { return textOfPaths(shapeOf(elements).paths); }

QByteArray clipPath(const QByteArray& content, const QByteArray& attributes = {})
{
    return "<clipPath id='c' " + attributes + ">" + content + "</clipPath>";
}

QByteArray clipped(const QByteArray& elements)
{
    return "<g clip-path='url(#c)'>" + elements + "</g>";
}

const QByteArray whole = "<rect width='100' height='100'/>";
const QString cutOnce = "1 clip path was replaced by a real cut; 1 shape was cut where a clip path "
                        "ends";

} // namespace

class ClipPathTest : public QObject {
    Q_OBJECT

private slots:
    void linesAndAreasAreCut()
    {
        const auto cut = [](const QByteArray& clip, const QByteArray& element) {
            return pathsOf(clipPath(clip) + clipped(element));
        };
        const QByteArray box = "<rect x='10' y='10' width='20' height='20'/>";
        const QByteArray line = "<path d='M0 20L40 20' fill='none' stroke='red'/>";
        QCOMPARE(cut(box, line), "10,20 30,20");
        QCOMPARE(cut(box, "<path d='M0 0L5 9' stroke='red'/>"), "");
        QCOMPARE(cut(box, "<path d='M12 12L20 20' fill='red'/>"), "12,12 20,20");
        QCOMPARE(cut(box, "<path d='M0 20H15V40H25V20H40' fill='none' stroke='red'/>"),
                 "10,20 15,20 15,30 | 25,30 25,20 30,20");
        QCOMPARE(cut("<path d='M20 0L40 20 20 40 0 20z'/>",
                     "<path d='M0 10H40' stroke='red' fill='none'/>"),
                 "10,10 30,10");
        QCOMPARE(areaOf(clipPath(box) + clipped("<path d='M20 0H40V40H20z' fill='red'/>")), 200.0);
        QCOMPARE(cut("", line), "");
        QCOMPARE(cut("<path d='M0 20H90'/>", line), "");
    }

    // The length of a hatch of 10 mm that is left.
    void formsOfClipPaths_data()
    {
        QTest::addColumn<QByteArray>("clip");
        QTest::addColumn<double>("left");
        const auto row = [](const char* name, const QByteArray& clip, double left) {
            QTest::newRow(name) << clip << left;
        };
        const QByteArray ring = "M10 50A40 40 0 1 1 90 50A40 40 0 1 1 10 50ZM30 50A20 20 0 1 1 70 "
                                "50A20 20 0 1 1 30 50Z";
        const QByteArray halves = "<rect width='50' height='100'/><rect x='40' width='30' "
                                  "height='100' transform='matrix(-1 0 0 1 110 0)'/>";
        const QByteArray square = "<path id='q' d='M0 0H10V100H0z'/>";
        row("ring by evenodd", clipPath("<path clip-rule='evenodd' d='" + ring + "'/>"), 370.03);
        row("without a ring by nonzero", clipPath("<path d='" + ring + "'/>"), 479.31);
        row("the rule is inherited",
            "<g clip-rule='evenodd'>" + clipPath("<path d='" + ring + "'/>") + "</g>", 370.03);
        row("two circles",
            clipPath("<circle cx='30' cy='50' r='15'/><circle cx='70' cy='50' r='15'/>"), 149.44);
        row("overlapping shapes in opposite directions", clipPath(halves), 630.0);
        row("concave", clipPath("<path d='M0 0H100L50 50 100 100H0z'/>"), 650.0);
        row("crossing itself", clipPath("<path d='M0 0L100 100 100 0 0 100z'/>"), 500.0);
        row("units of the box",
            clipPath("<rect x='.25' y='-.1' width='50%' height='1.2'/>",
                     "clipPathUnits='objectBoundingBox'"),
            450.0);
        row("units of the box, transformed",
            clipPath("<rect x='.25' y='-.1' width='.5' height='1.2'/>",
                     "clipPathUnits='objectBoundingBox' transform='translate(40 0)'"),
            315.0);
        row("transform of the clip path",
            clipPath("<rect width='5' height='10'/>", "transform='scale(10)'"), 450.0);
        row("a clip path in a clip path",
            "<clipPath id='d'><rect width='50' height='100'/></clipPath>"
                + clipPath("<rect x='30' width='50' height='100'/>", "clip-path='url(#d)'"),
            180.0);
        row("a clip path of a child",
            "<clipPath id='d'><circle cx='50' cy='50' r='30'/></clipPath>"
                + clipPath("<rect clip-path='url(#d)' width='50' height='100'/><rect x='90' "
                           "width='10' height='100'/>"),
            90 + 131.29);
        row("used", square + clipPath("<use href='#q' x='20'/><use href='#q' x='60'/>"), 180.0);
        row("used and clipped",
            square + "<clipPath id='d'><rect width='100' height='55'/></clipPath>"
                + clipPath("<use href='#q' x='20' clip-path='url(#d)'/>"),
            50.0);
        row("hidden shapes",
            clipPath(whole.left(5) + " display='none'" + whole.mid(5) + whole.left(5)
                     + " visibility='hidden'" + whole.mid(5)),
            0.0);
        row("content that SVG ignores", clipPath("<g>" + whole + "</g>"), 0.0);
        row("nothing", clipPath(""), 0.0);
    }
    void formsOfClipPaths()
    {
        QFETCH(QByteArray, clip);
        QFETCH(double, left);
        const bool hasSquare = clip.startsWith("<path id='q'");
        const QByteArray defs = hasSquare ? "<defs>" + clip + "</defs>" : clip;
        QCOMPARE(lengthOf(defs + clipped(hatch())), left);
    }

    // The left half of the box of what is drawn.
    void boxesOfAnyElement_data()
    {
        QTest::addColumn<QByteArray>("element");
        const QByteArray lines = "<path stroke='#000' fill='none' d='M10 10L50 20M10 20L50 10'/>";
        const auto row = [](const char* name, const QByteArray& element) {
            QTest::newRow(name) << element;
        };
        row("path", lines);
        row("group", "<g transform='translate(5)'>" + lines + "</g>");
        row("svg", "<svg width='100' height='100' viewBox='0 0 100 100'>" + lines + "</svg>");
        row("switch", "<switch>" + lines + "<path d='M0 0H99'/></switch>");
        row("use", "<defs><g id='q'>" + lines + "</g></defs><use href='#q' x='7'/>");
        row("symbol", "<symbol id='q' viewBox='0 0 50 50'>" + lines
                          + "</symbol><use href='#q' width='50' height='50' x='9'/>");
    }
    void boxesOfAnyElement()
    {
        QFETCH(QByteArray, element);
        const QByteArray half =
            clipPath("<rect width='.5' height='1'/>", "clipPathUnits='objectBoundingBox'");
        QCOMPARE(lengthOf(half + clipped(element)), 41.23);
        QCOMPARE(lengthOf(half + "<g transform='rotate(30) scale(2)'>" + clipped(element) + "</g>"),
                 82.46);
    }

    void clipsAroundEachOtherIntersect()
    {
        const QByteArray clips = "<clipPath id='a'><rect width='50' height='100'/></clipPath>"
                                 "<clipPath id='b'><rect x='30' width='70' "
                                 "height='100'/></clipPath>";
        QCOMPARE(lengthOf(clips
                          + "<g clip-path='url(#a)'><g transform='translate(10)' "
                            "clip-path='url(#b)'>"
                          + hatch() + "</g></g>"),
                 90.0);
    }

    // What follows, precedes or lies around clipped content stays in its order.
    void theOrderStays()
    {
        const auto object = [](const QByteArray& id) {
            return "<path id='" + id + "' d='M0 20H100' stroke='red'/>";
        };
        const auto read =
            readText(drawing(clipPath("<rect width='50' height='100'/>") + object("a")
                             + "<g id='g' clip-path='url(#c)'>" + object("b") + "<g id='h'>"
                             + object("d") + "</g>" + object("e") + "</g>" + object("f")));
        QVERIFY(read);
        QStringList ids;
        const auto& shapes = app::sheetOf(read.value->document).shapes;
        for (const app::Shape& shape : shapes)
            ids << shape.id;
        QCOMPARE(ids, QString("a b d e f").split(' '));
        QCOMPARE(textOfPaths(shapes[2].paths), "0,20 50,20");
        QCOMPARE(textOfPaths(shapes[4].paths), "0,20 100,20");
        const app::Containers& tree = read.value->document.containers();
        QCOMPARE(tree[tree.containerOf(2)].svgId, "h");
    }

    void areasStayFilled()
    {
        QCOMPARE(areaOf(clipPath("<path clip-rule='evenodd' d='M10 10H90V90H10zM30 30H70V70H30z'/>")
                        + clipped(whole)),
                 6400.0 - 1600);
        const auto shape = shapeOf(clipPath("<circle cx='50' cy='50' r='40'/>") + clipped(whole));
        QCOMPARE(shape.paths.size(), 1u);
        QVERIFY(std::ranges::all_of(shape.paths[0].segments, &app::PathSegment::curved));
    }

    void cutCurvesStayCurves()
    {
        const auto shape = shapeOf(clipPath("<rect width='50' height='100'/>")
                                   + "<circle cx='50' cy='50' r='20' "
                                     "fill='none' stroke='red' clip-path='url(#c)'/>");
        QCOMPARE(textOfPaths(shape.paths), "50,70 ~30,50 ~50,30");
    }

    // A shape that is its own clip path is not shattered.
    void aShapeThatIsItsClipPathStaysWhole()
    {
        const QByteArray circle = "<circle cx='50' cy='50' r='40' fill='none' stroke='red'/>";
        QCOMPARE(reportOf(clipPath(circle) + clipped(circle)),
                 "1 clip path was replaced by a real cut");
        QVERIFY(shapeOf(clipPath(circle) + clipped(circle)).paths.at(0).closed);
    }

    void filledAndStrokedShapesBecomeTwo()
    {
        const auto result =
            readText(drawing(clipPath("<rect width='50' height='100'/>")
                             + "<rect id='r' x='40' y='10' width='20' height='20' fill='red' "
                               "stroke='blue' clip-path='url(#c)'/>"));
        const auto& shapes = app::sheetOf(result.value->document).shapes;
        QCOMPARE(shapes.size(), 2u);
        QVERIFY(shapes[0].style.fill && !shapes[0].style.stroke && shapes[0].id == "r");
        QVERIFY(shapes[0].paths.at(0).closed);
        QCOMPARE(textOfPaths(shapes[1].paths), "50,30 40,30 40,10 50,10");
        QVERIFY(!shapes[1].style.fill && shapes[1].style.stroke && shapes[1].id.isEmpty());
    }

    void theReportCounts()
    {
        const QByteArray line = "<path d='M0 20H100' stroke='red'/>";
        QCOMPARE(reportOf(clipPath("<rect width='50' height='100'/>")
                          + clipped(line + line + "<path d='M60 1H70' stroke='red'/>")),
                 "1 clip path was replaced by a real cut; 2 shapes were cut where clip paths end; "
                 "1 shape that a clip path hides was removed");
        QCOMPARE(reportOf(clipPath(whole) + clipped("") + clipped("")),
                 "2 clip paths were replaced by real cuts");
        const auto read = readText(drawing(clipPath(whole) + clipped(line)));
        QVERIFY(app::mustSaveAs(read.value->report) && !isLossy(*read.value));
    }

    // The report says why a clip path is not applied; the shapes are whole.
    void clipPathsThatAreNotApplied_data()
    {
        QTest::addColumn<QByteArray>("elements");
        QTest::addColumn<QString>("expected");
        const auto row = [](const QByteArray& elements, const char* expected) {
            QTest::addRow("%s", expected) << elements << QString(expected);
        };
        const QByteArray line = "<path d='M0 20H40' stroke='red' fill='none'/>";
        row(clipPath("<text>x</text>") + clipped(line), "1 clip path with an element “text”");
        row("<g clip-path='url(#gone)'>" + line + "</g>",
            "1 reference to a clip path that is not in the file was ignored");
        row("<g clip-path='url(other.svg#c)'>" + line + "</g>", "1 reference to another file");
        row("<g style='clip-path:nonsense(1px)'>" + line + "</g>",
            "1 value “clip-path: nonsense(1px)” that is not understood");
        row(clipPath("<rect width='1' height='1'/>", "clipPathUnits='objectBoundingBox'")
                + clipped("<text/>" + line),
            "1 clip path in the box of something with texts or images; 1 text");
    }
    void clipPathsThatAreNotApplied()
    {
        QFETCH(QByteArray, elements);
        QFETCH(QString, expected);
        QCOMPARE(reportOf(elements), expected);
        QCOMPARE(pathsOf(elements), "0,20 40,20");
    }

    void clipPathsThatContainThemselvesEnd()
    {
        const QByteArray line = "<path d='M0 20H40' stroke='red' fill='none'/>";
        const QByteArray half = "<rect width='20' height='100'/>";
        const QByteArray self = clipPath(half, "clip-path='url(#c)'");
        QCOMPARE(pathsOf(self + clipped(line)), "0,20 20,20");
        QCOMPARE(reportOf(self + clipped(line)), "1 clip path that clips itself; " + cutOnce);
        const QByteArray pair = clipPath("<rect clip-path='url(#d)' width='20' height='100'/>")
                                + "<clipPath id='d' clip-path='url(#c)'>" + whole + "</clipPath>";
        QCOMPARE(pathsOf(pair + clipped(line)), "0,20 20,20");
    }

    // Its centre line ends at the clip path's edge, but not its sides.
    void wideStrokesAtSlantedClipPathsAreTold()
    {
        const auto reported = [](const QByteArray& stroke, const QByteArray& corners) {
            return reportOf("<clipPath id='k'><polygon points='" + corners
                            + "'/></clipPath><path d='M0 50H100' stroke='#000' stroke-width='"
                            + stroke + "' clip-path='url(#k)'/>");
        };
        const QByteArray slanted = "50,10 90,50 50,90 10,50", upright = "20,20 80,20 80,80 20,80";
        const QString wide =
            "; 1 wide stroke was cut at its centre line, and does not end where its "
            "clip path does";
        QCOMPARE(reported("15", "60,0 100,60 40,100 0,40"), cutOnce + wide);
        QCOMPARE(reported("1", "60,0 100,60 40,100 0,40"), cutOnce);
        QCOMPARE(reported("15", upright), cutOnce);
        QCOMPARE(reported("15", slanted), cutOnce + wide);
    }

    void theSideOfAWideStrokeIsTold()
    {
        const auto reported = [](const QByteArray& y) {
            return reportOf(
                clipPath("<rect width='100' height='50'/>")
                + clipped("<path d='M0 " + y + "H100' stroke='red' stroke-width='20'/>"));
        };
        QVERIFY(reported("55").contains("1 wide stroke of which a clip path shows only a side"));
        QVERIFY(!reported("65").contains("wide"));
        QVERIFY(reported("45").contains("1 wide stroke that reaches out of its clip path"));
        QVERIFY(!reported("40").contains("wide"));
        // As drawing programs write a stroke that is inside its shape.
        QVERIFY(reportOf(clipPath("<circle cx='50' cy='50' r='30'/>")
                         + clipped("<circle cx='50' cy='50' r='30' fill='none' stroke='red' "
                                   "stroke-width='16'/>"))
                    .contains("1 wide stroke that reaches out of its clip path"));
    }

    void clipPathsAreKnownByTheirIds()
    {
        const auto read = readText(drawing(clipPath("<circle cx='30' cy='50' r='15'/><circle "
                                                    "cx='70' cy='50' r='15'/>")
                                           + clipped(hatch())));
        QCOMPARE(read.value->clipPaths.size(), std::size_t(1));
        QCOMPARE(read.value->clipPaths[0].id, "c");
        QCOMPARE(read.value->clipPaths[0].windows.size(), std::size_t(1));
        const auto unused = readText(drawing(clipPath(whole) + hatch()));
        QCOMPARE(unused.value->clipPaths.size(), std::size_t(1));
        QVERIFY(unused.value->report.empty());
    }
};

} // namespace formats_svg_clip_path_test

TEST_CLASS(formats_svg_clip_path_test::ClipPathTest, Core)
#include "tests/app/formats/svg/clip_path_test.moc"
