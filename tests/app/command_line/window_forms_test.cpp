// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/command.h"
#include "app/command_line/window_forms.h"
#include "app/command_line/window_options.h"
#include "app/formats/format.h"

#include <QBuffer>
#include <QTest>

#include <numbers>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace command_line_window_forms_test {

namespace {

using app::PathShape;
using app::Point;
using app::RectangleShape;
using app::WindowOperation;

const QByteArray drawing =
    "<svg xmlns='http://www.w3.org/2000/svg' "
    "xmlns:i='http://www.inkscape.org/namespaces/inkscape' width='100mm' height='50mm' "
    "viewBox='-100 -50 200 100'>"
    "<rect id='box' x='-20' y='-10' width='40' height='20'/>"
    "<path id='line' d='M-99,0 99,0' stroke='black' fill='none'/>"
    "<clipPath id='holes'><circle cx='-50' r='20'/><circle cx='50' r='20'/></clipPath>"
    "<g clip-path='url(#holes)'><path d='M-99,0 -60,0' stroke='black'/></g>"
    "<g i:groupmode='layer' i:label='Lakes' id='lakes'><g id='both'>"
    "<circle id='lake' cx='50' cy='0' r='10'/><circle id='pond' cx='-50' cy='0' "
    "r='5'/></g></g></svg>";

app::Imported imported()
{
    QByteArray bytes = drawing;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::ReadOnly);
    return std::move(*app::findFormat(u"svg")->read(buffer).value);
}

std::vector<app::ClipWindow> windows(const char* text)
{
    return app::windowsOf({"window", QString::fromUtf8(text)}, imported());
}

std::vector<Point> cornersOf(const app::ClipWindow& window)
{
    std::vector<Point> points;
    std::get<PathShape>(window.shape).path.forEachPoint([&](const Point& p) {
        points.push_back(p);
    });
    return points;
}

QString refusalOf(const char* text)
{
    try {
        windows(text);
    } catch (const app::WrongUsage& usage) {
        return usage.sentence;
    } catch (const app::Failure& failure) {
        return failure.sentence;
    }
    return {};
}

// The ends of the pieces that a command line leaves of the line from (-99, 0) to (99, 0).
QByteArray pieces(const QStringList& options)
{
    const QByteArray line = "x1,y1,x2,y2\n-99,0,99,0\n";
    const auto run = clearcut(
        QStringList{"clip", "-", "--from", "csv", "--to", "csv", "-o", "-", "-q"} + options, line);
    QByteArray ends;
    for (const QByteArray& row : run.out.split('\n').mid(1))
        if (const auto cells = row.split(','); cells.size() > 3)
            ends += cells[0] + ' ' + cells[2] + ';';
    return run.code == 0 ? ends : run.err;
}

} // namespace

class WindowFormsTest : public QObject {
    Q_OBJECT

private slots:
    void rectangles()
    {
        QCOMPARE(windows("-1,-2,3,4").front().shape,
                 app::WindowShape(RectangleShape{{{-1, -2}, {3, 4}}}));
        // From the paper's corner; a unit is half a millimetre.
        QCOMPARE(windows("10mm,10mm,2cm,30mm").front().shape,
                 app::WindowShape(RectangleShape{{{-80, -30}, {-60, 10}}}));
        const auto turned = windows("0,0,4,2@30").front();
        QCOMPARE(std::get<RectangleShape>(turned.shape).angle, -std::numbers::pi / 6);
        QCOMPARE(windows("0,0,4,2@90").front().shape,
                 app::WindowShape(RectangleShape{{{1, -1}, {3, 3}}}));
        QCOMPARE(windows("page").front().shape,
                 app::WindowShape(RectangleShape{{{-100, -50}, {100, 50}}}));
    }

    /// At 1 : 50 a unit is a real millimetre: `--margin` is on paper.
    void lengthsAreRealAtTheScaleOfTheDrawing()
    {
        const QByteArray plan =
            "<svg xmlns='http://www.w3.org/2000/svg' xmlns:c='urn:clearcut:1' width='297mm' "
            "height='210mm' viewBox='0 0 14850 10500'><metadata><c:page scale='50' unit='m'/>"
            "</metadata><path d='M0,1000H14850' stroke='black'/></svg>";
        const auto ends = [&](const QStringList& options) {
            const auto run = clearcut(
                QStringList{"clip", "-", "--from", "svg", "--to", "csv", "-o", "-", "-q"} + options,
                plan);
            return run.code == 0 ? run.out.split('\n').value(1) : run.err;
        };
        QVERIFY2(ends({"-w", "0.5m,0.5m,250cm,2500mm"}).startsWith("500,1000,2500,1000"),
                 ends({"-w", "0.5m,0.5m,250cm,2500mm"}));
        QVERIFY(ends({"-w", "1ft,0ft,10ft,10ft"}).startsWith("304.8,1000,3048,1000"));
        QVERIFY(ends({"--page", "--margin", "10mm"}).startsWith("500,1000,14350,1000"));
        const auto told = clearcut({"info", "-", "--from", "svg"}, plan);
        QVERIFY2(told.out.contains("1:50, a unit is 1mm of the real thing"), told.out);
        QVERIFY(told.out.contains("0.02mm"));
    }

    void circlesAndPolygons()
    {
        const auto circle = std::get<PathShape>(windows("circle:50mm,25mm,5mm").front().shape);
        QCOMPARE(circle.recipe, app::Recipe(app::EllipseRecipe{{0, 0}, {10, 10}}));
        QCOMPARE(cornersOf(windows("polygon:0,0 10,0  5,8").front()),
                 (std::vector<Point>{{0, 0}, {10, 0}, {5, 8}}));
        QCOMPARE(cornersOf(windows("polygon: 0, 0; 10 ,0;5,8; 1,1").front()),
                 (std::vector<Point>{{0, 0}, {10, 0}, {5, 8}, {1, 1}}));
    }

    void shapesOfTheDrawing()
    {
        QCOMPARE(windows("shape:box").front().shape,
                 app::WindowShape(RectangleShape{{{-20, -10}, {20, 10}}}));
        QCOMPARE(windows("layer:Lakes").size(), 2u);
        QCOMPARE(windows("layer:Lakes")[1].name, "pond");
        QCOMPARE(windows("shape:lakes"), windows("layer:Lakes")); // its id
        QCOMPARE(windows("shape:both").size(), 2u);
        QCOMPARE(windows("shape:holes").size(), 1u); // a clip path: circles apart are one window
        QCOMPARE(windows("shape:holes")[0].name, "holes");
        QCOMPARE(cornersOf(windows("shape:holes")[0]).front(), Point(-30, 0));
    }

    void masksLieOnTheirPapersCorner()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("mask.svg");
        writeText(path, "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='50mm' "
                        "viewBox='0 0 100 50'><rect x='10' y='20' width='30' height='5'/></svg>");
        const auto mask = windows(("file:" + path).toUtf8().constData());
        QCOMPARE(mask.size(), 1u);
        QCOMPARE(mask.front().shape, app::WindowShape(RectangleShape{{{-80, -10}, {-20, 0}}}));
    }

    void wrongOnesAreRefusedInOneSentence_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char* text, const char* sentence) {
            QTest::newRow(text) << text << sentence;
        };
        row("0,0,4,2@x", "--window 0,0,4,2@x: give four lengths");
        row("0,0,4,2@1@2", "give four lengths");
        row("0,0,4,2@inf", "give four lengths");
        row("0,0,4", "give four lengths");
        row("circle:1,2", "give the centre and a radius greater than 0");
        row("circle:1,2,0", "a radius greater than 0");
        row("circle:1,2,nan", "a radius greater than 0");
        row("circle:1mm,2mm,3", "give all numbers with a unit");
        row("circle", "give the centre and a radius");
        row("circle:1e308,0,1e309", "“1e309” is too large");
        row("circle:1e308in,0in,1in", "The window is too large");
        row("polygon:0,0 1,1", "three or more corners");
        row("polygon:0,0 1,1 2", "three or more corners");
        row("polygon:0,0 1,1,2 3", "three or more corners");
        row("shape:lak", "there is no “lak” in the drawing. Did you mean “lake”?");
        row("shape:k", "there is no “k” in the drawing, which has “");
        row("shape:line", "nothing there encloses an area");
        row("layer:lakes", "Did you mean “Lakes”?");
        row("square:1,2,3", "give XMIN,YMIN,XMAX,YMAX[@DEGREES], circle:CX,CY,R");
        row("file:/nowhere/mask.svg", "/nowhere/mask.svg");
    }
    void wrongOnesAreRefusedInOneSentence()
    {
        QFETCH(QString, text);
        QFETCH(QString, sentence);
        const QString said = refusalOf(text.toUtf8().constData());
        QVERIFY2(said.contains(sentence), qPrintable(said));
    }

    void theOrderOfTheOptionsCounts()
    {
        const QString wide = "polygon:-50,-50 50,-50 50,50 -50,50", small = "-10,-10,10,10";
        QCOMPARE(pieces({"-w", wide, "--cut-out", small}), "-50 -10;10 50;");
        QCOMPARE(pieces({"--cut-out", small, "-w", wide}), "-99 99;");
        QCOMPARE(pieces({"--cut-out", small}), "-99 -10;10 99;");
        QCOMPARE(pieces({"-w", wide, "--intersect", "0,-5,80,5"}), "0 50;");
        QCOMPARE(pieces({"-w", wide, "--replace", small, "-w", "40,-5,80,5"}), "-10 10;40 80;");
        QCOMPARE(pieces({"--replace", small}), "-10 10;");
        QCOMPARE(pieces({"-w", "-90,-1,-80,1", "--window", "circle:0,0,5"}), "-90 -80;-5 5;");
        QCOMPARE(pieces({"-w", "-90,-1,-80,1", "-w", "circle:0,0,5", "--keep", "outside"}),
                 "-99 -90;-80 -5;5 99;");
    }

    void severalShapesAreUnitedBeforeTheyIntersect()
    {
        for (const char* lakes : {"layer:Lakes", "shape:lakes"}) {
            const auto run = clearcut({"clip", "-", "--from", "svg", "--to", "csv", "-o", "-", "-w",
                                       "page", "--intersect", QString::fromUtf8(lakes)},
                                      drawing);
            QCOMPARE(run.code, 0);
            QVERIFY2(run.out.contains("\n-55,0,-45,0,") && run.out.contains("\n40,0,60,0,"),
                     run.out);
        }
    }

    void severalShapesReplaceTogether()
    {
        const auto run = clearcut({"clip", "-", "--from", "svg", "--to", "csv", "-o", "-", "-w",
                                   "page", "--replace", "layer:Lakes"},
                                  drawing);
        QVERIFY2(run.out.contains("\n-55,0,-45,0,") && run.out.contains("\n40,0,60,0,"), run.out);
        QVERIFY2(!run.out.contains("\n-99,0,"), run.out);
    }

    void thePageAndAWindowAreGivenAlike()
    {
        const auto run = clearcut(
            {"clip", "-", "--from", "svg", "--to", "csv", "-o", "-", "-w", "0,0,1,1", "--page"},
            drawing);
        QCOMPARE(run.code, 2);
        QVERIFY2(run.err.contains("write --window page"), run.err);
    }

    void comparisonsAreAtOneWindowThatBothCanClip()
    {
        const auto compared = [](const QStringList& window, const QStringList& variants) {
            return clearcut(QStringList{"compare", "-", "--from", "svg"} + window + variants,
                            drawing);
        };
        for (const char* window : {"circle:0,0,9", "0,0,30,20@20", "polygon:0,0 30,0 9,20"})
            for (const char* row : {"cb", "skala"}) {
                const auto run = compared({"-w", window}, {"-a", row});
                QCOMPARE(run.code, 0);
                QVERIFY2(run.err.contains("They agree on all"), run.err.constData());
            }
        QCOMPARE(compared({"-w", "0,0,30,20@20"}, {"-a", "md", "-b", "lb:published"}).code, 0);
        const auto refused = [&](const QStringList& window, const char* row, const char* sentence) {
            const auto run = compared(window, {"-a", row});
            return run.code == 2 && run.err.contains(sentence);
        };
        QVERIFY(refused({"-w", "circle:0,0,9"}, "md", "MD clips at rectangles only"));
        QVERIFY(refused({"-w", "circle:0,0,9"}, "cb:published",
                        "CB as published clips at rectangles only"));
        QVERIFY(refused({"-w", "polygon:0,0 9,0 2,2 0,9"}, "cb",
                        "compared at rectangles and convex polygons; this window is concave"));
        QVERIFY(refused({"-w", "circle:0,0,9", "-w", "page"}, "cb", "and these are 2"));
    }

    void theReportNamesEveryWindow()
    {
        const auto run = clearcut({"clip", "-", "--from", "svg", "--to", "svg", "-o", "-", "-w",
                                   "page", "--cut-out", "shape:lake"},
                                  drawing);
        QCOMPARE(run.code, 0);
        QVERIFY2(run.err.contains("Windows (given): add -100,-50,100,50"), run.err.constData());
        QVERIFY2(run.err.contains("; cut out a shape within 40,-10,60,10"), run.err.constData());
    }
};

} // namespace command_line_window_forms_test

TEST_CLASS(command_line_window_forms_test::WindowFormsTest, Core)
#include "tests/app/command_line/window_forms_test.moc"
