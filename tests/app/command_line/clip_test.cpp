// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/number.h"
#include "app/command_line/window_options.h"
#include "app/cut/cut.h"
#include "app/experiment/paper_scene.h"
#include "app/formats/format.h"
#include "clipping/algorithm.h"
#include "clipping/outside.h"

#include <QBuffer>
#include <QDir>
#include <QImage>
#include <QTest>

#include <cmath>

#include "tests/app/command_line/program.h"
#include "tests/app/document/sheet.h"
#include "tests/deep.h"
#include "tests/test_class.h"

namespace command_line_clip_test {

namespace {

const QByteArray csvHeader = "x1,y1,x2,y2,layer,colour,width,source\n";

QByteArray csvOf(std::span<const clipping::Segment> lines)
{
    std::string text = "x1,y1,x2,y2\n";
    for (const auto& line : lines) {
        for (const double number : {line.a.x, line.a.y, line.b.x, line.b.y}) {
            app::appendNumber(text, number);
            text += ',';
        }
        text.back() = '\n';
    }
    return QByteArray::fromStdString(text);
}

// What the program has to write for these pieces.
QByteArray csvOf(std::span<const clipping::Clipped> pieces)
{
    std::string text = csvHeader.toStdString();
    for (const auto& [segment, source, cut] : pieces) {
        for (const double number : {segment.a.x, segment.a.y, segment.b.x, segment.b.y}) {
            app::appendNumber(text, number);
            text += ',';
        }
        text += "Drawing,#000000,1," + std::to_string(source) + '\n';
    }
    return QByteArray::fromStdString(text);
}

QString key(const clipping::Algorithm& algorithm)
{
    return QString::fromUtf8(algorithm.key.data(), qsizetype(algorithm.key.size()));
}

app::Sheet sheetOf(QByteArray svg)
{
    QBuffer buffer(&svg);
    buffer.open(QIODevice::ReadOnly);
    auto imported = app::findFormat(u"svg")->read(buffer);
    return imported ? app::sheetOf(imported.value->document) : app::Sheet();
}

} // namespace

class ClipTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString path(const QString& name) const { return folder_.filePath(name); }

private slots:
    void csvIsWhatTheLibraryClips_data()
    {
        QTest::addColumn<int>("row");
        for (int i = 0; i < int(clipping::algorithms().size()); ++i)
            QTest::newRow(qPrintable(key(clipping::algorithms()[std::size_t(i)]))) << i;
    }
    void csvIsWhatTheLibraryClips()
    {
        QFETCH(int, row);
        const auto& algorithm = clipping::algorithms()[std::size_t(row)];
        std::vector<clipping::Segment> lines(5000);
        app::PaperScene(6).fill(lines);
        lines[10] = {{-200, 75}, {200, 75}}; // along an edge
        lines[20] = {{-200, -25}, {0, 175}}; // a corner
        lines[30] = {{50, 50}, {50, 50}};    // a point
        std::vector<clipping::Clipped> inside(lines.size());
        inside.resize(algorithm.corrected.clipAll(lines, app::paperWindow, inside));
        std::vector<clipping::Clipped> outside(lines.size() + inside.size());
        outside.resize(clipping::outsideAll(lines, inside, outside));

        const QStringList arguments{"clip", "-",   "--from", "csv", "-w", "-100,-75,100,75",
                                    "--to", "csv", "-o",     "-",   "-a", key(algorithm)};
        QCOMPARE(clearcut(arguments, csvOf(lines)).out, csvOf(inside));
        QCOMPARE(clearcut(arguments + QStringList{"--keep", "outside"}, csvOf(lines)).out,
                 csvOf(outside));
        if (algorithm.key == "exact") // is what clips unless another is named
            QCOMPARE(clearcut(arguments.first(arguments.size() - 2), csvOf(lines)).out,
                     csvOf(inside));
    }

    void windowsAreWrittenInManyWays_data()
    {
        QTest::addColumn<QStringList>("window");
        QTest::newRow("apart") << QStringList{"-w", "-1,-2,3,4"};
        QTest::newRow("joined") << QStringList{"-w=-1,-2,3,4"};
        QTest::newRow("glued") << QStringList{"-w-1,-2,3,4"};
        QTest::newRow("long, apart") << QStringList{"--window", "-1,-2,3,4"};
        QTest::newRow("long, joined") << QStringList{"--window=-1,-2,3,4"};
        QTest::newRow("spaces") << QStringList{"--window", "-1, -2.0, +3, 4e0"};
        QTest::newRow("pixels") << QStringList{"-w", "-1px,-2px,3px,4px"};
    }
    void windowsAreWrittenInManyWays()
    {
        QFETCH(QStringList, window);
        const auto run =
            clearcut(QStringList{"clip", "-", "--from", "csv", "--to", "csv", "-o", "-"} + window,
                     "-9,0,9,0\n0,-9,0,9\n");
        QCOMPARE(run.code, 0);
        QCOMPARE(run.out,
                 csvHeader + "-1,0,3,0,Drawing,#000000,1,0\n0,-2,0,4,Drawing,#000000,1,1\n");
        QVERIFY2(run.err.startsWith("Shapes: 0 kept whole, 2 cut, 0 removed.\n"),
                 run.err.constData());
    }

    // A page of 100 mm by 50 mm with the user origin in its middle, a unit being half a millimetre:
    // lengths with a unit count from the paper's corner, bare numbers from the user origin.
    void lengthsWithAUnitCountFromThePapersCorner_data()
    {
        QTest::addColumn<QString>("window");
        QTest::addColumn<QByteArray>("left");
        QTest::newRow("lengths") << "10mm,10mm,90mm,40mm" << QByteArray("-80,0,80,0");
        QTest::newRow("bare numbers") << "-80,-30,80,30" << QByteArray("-80,0,80,0");
        QTest::newRow("left of the paper") << "-1cm,0cm,10cm,5cm" << QByteArray("-120,0,100,0");
        QTest::newRow("the corner itself") << "0in,0in,50mm,25mm" << QByteArray("-100,0,0,0");
    }
    void lengthsWithAUnitCountFromThePapersCorner()
    {
        QFETCH(QString, window);
        QFETCH(QByteArray, left);
        const auto run =
            clearcut({"clip", "-", "--from", "svg", "--to", "csv", "-o", "-", "-w", window},
                     "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='50mm' "
                     "viewBox='-100 -50 200 100'><path d='M-500 0H500' stroke='red'/></svg>");
        QCOMPARE(run.code, 0);
        QCOMPARE(run.out.split('\n').value(1), left + ",Drawing,#ff0000,1");
        if (left == "-80,0,80,0")
            QVERIFY2(run.err.contains("Window (given): -80,-30,80,30 in the drawing's coordinates, "
                                      "10mm,10mm,90mm,40mm from the paper's top left corner."),
                     run.err.constData());
    }

    // A bare number beside a length would count from another point than it.
    void aWindowOfNumbersAndLengthsIsRefused()
    {
        for (const char* command : {"clip", "compare"})
            for (const char* window :
                 {"0,0,10mm,10mm", "10mm,-30,80,4cm", "0in,0in,0,25mm", "1px,1px,3px,4"}) {
                QStringList arguments{command, "-", "--from", "svg", "-w", window, "-a", "md"};
                if (command == QByteArray("clip"))
                    arguments << QStringList{"--to", "csv", "-o", "-"};
                const auto run = clearcut(arguments, "<svg xmlns='http://www.w3.org/2000/svg' "
                                                     "width='100mm' viewBox='-9 -5 20 10'/>");
                QCOMPARE(run.code, 2);
                QCOMPARE(run.out, "");
                const QByteArray sentence =
                    "--window " + QByteArray(window)
                    + ": give all four numbers with a unit, or all four without.";
                QVERIFY2(run.err.contains(sentence), run.err.constData());
            }
    }

    void aCutSaysAtWhichWindow_data()
    {
        QTest::addColumn<QByteArray>("root");
        QTest::addColumn<QStringList>("more");
        QTest::addColumn<QByteArray>("window");
        const QByteArray half = "width='40mm' height='20mm' viewBox='0 0 80 40'>",
                         whole = "width='40mm' height='20mm' viewBox='0 0 40 20'>",
                         saved = "<metadata><clearcut:window xmin='5' ymin='6' xmax='7' "
                                 "ymax='18'/></metadata>",
                         paper = " from the paper's top left corner",
                         own = " in the drawing's coordinates";
        QTest::newRow("given") << half << QStringList{"-w", "1,2,30,40"}
                               << "given): 1,2,30,40" + own + ", 0.5mm,1mm,15mm,20mm" + paper;
        QTest::newRow("saved") << half + saved << QStringList()
                               << "saved in the drawing): 5,6,7,18" + own + ", 2.5mm,3mm,3.5mm,9mm"
                                      + paper;
        QTest::newRow("page") << half << QStringList()
                              << "the page): 0,0,80,40" + own + ", 0mm,0mm,40mm,20mm" + paper;
        QTest::newRow("--page") << half + saved << QStringList{"--page"}
                                << "the page): 0,0,80,40" + own + ", 0mm,0mm,40mm,20mm" + paper;
        QTest::newRow("margin") << half << QStringList{"--page", "--margin", "1mm"}
                                << "the page, margin 1mm): 2,2,78,38" + own + ", 1mm,1mm,39mm,19mm"
                                       + paper;
        QTest::newRow("millimetres") << whole << QStringList() << "the page): 0,0,40,20" + own;
        const QByteArray outside = "; keeps the outside";
        QTest::newRow("outside") << whole << QStringList{"-k", "outside"}
                                 << "the page): 0,0,40,20" + own + outside;
        QTest::newRow("outside, saved")
            << whole
                   + "<metadata><clearcut:window keep='outside' xmin='5' ymin='6' xmax='7' "
                     "ymax='18'/></metadata>"
            << QStringList() << "saved in the drawing): 5,6,7,18" + own + outside;
        QTest::newRow("no size") << QByteArray(">") << QStringList()
                                 << QByteArray("the bounds of all objects): -10.5,0,190.5,9.5")
                                        + own + ", -2.778mm,0mm,50.403mm,2.514mm" + paper;
    }
    void aCutSaysAtWhichWindow()
    {
        QFETCH(QByteArray, root);
        QFETCH(QStringList, more);
        QFETCH(QByteArray, window);
        const QByteArray drawing = "<svg xmlns='http://www.w3.org/2000/svg' "
                                   "xmlns:clearcut='urn:clearcut:1' "
                                   + root + "<path d='M-10 9h200' stroke='red'/></svg>";
        more = QStringList{"clip", "-", "--from", "svg", "--to", "csv", "-o", "-"} + more;
        const auto run = clearcut(more, drawing);
        QCOMPARE(run.code, 0);
        QVERIFY2(run.err.endsWith("\nWindow (" + window + ".\n"), run.err.constData());
        QCOMPARE(clearcut(more << "-q", drawing).err, "");
    }

    // Whoever writes an SVG drawing by hand finds there what a window may say.
    void thePageNamesWhatAWindowOfAFileSays()
    {
        const QByteArray page = contentOf(SOURCE_DIR "/resources/desktop/clearcut.1");
        const QByteArray section = page.mid(page.indexOf(".Sh CLIP WINDOWS IN SVG FILES"));
        for (const char* word : {"name", "operation", "visible", "keep", "xmin", "angle", "cut-out",
                                 "intersect", "urn:clearcut:1"})
            QVERIFY2(section.left(section.indexOf(".Sh FILES")).contains(word), word);
    }

    void anEmptyTableHasNoDrawnWindow()
    {
        const auto run =
            clearcut({"clip", "-", "--from", "csv", "--to", "svg", "-o", "-"}, "x1,y1,x2,y2\n");
        QVERIFY2(run.err.contains(
                     "Window (the default page, because the drawing is empty): 0,0,297,210 in "),
                 run.err.constData());
    }

    // Alone as beside other windows, and for lines as for areas.
    void aWindowWithoutAreaContainsNothing()
    {
        const auto run =
            clearcut({"clip", "-", "--from", "csv", "--to", "csv", "-o", "-", "-w", "3,0,3,9"},
                     "0,5,9,5\n3,-9,3,99\n");
        QCOMPARE(run.code, 0);
        QCOMPARE(run.out, csvHeader);
        QVERIFY2(run.err.contains("a window without area, which contains nothing"),
                 run.err.constData());
    }

    void theHelpAndThePageSayFromWhereLengthsCount()
    {
        const QByteArray rule = "count from the paper's top left corner";
        QVERIFY(clearcut({"clip", "--help"}).out.simplified().contains(rule));
        QVERIFY(contentOf(SOURCE_DIR "/resources/desktop/clearcut.1").simplified().contains(rule));
    }

    void aCutThatLeavesNothingSaysSo()
    {
        const QByteArray drawing = "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' "
                                   "height='50mm' viewBox='-100 -50 200 100'><path d='M-90 0H90' "
                                   "stroke='red'/></svg>";
        const auto errorOf = [](const QByteArray& text, const QStringList& more) {
            const auto run = clearcut(
                QStringList{"clip", "-", "--from", "svg", "--to", "svg", "-o", "-"} + more, text);
            return run.code == 0 ? run.err : "exit code " + QByteArray::number(run.code);
        };
        const QByteArray outside = errorOf(drawing, {"-w", "100,0,200,20"});
        QVERIFY2(outside.contains("Nothing is left: all of the drawing is outside the window. The "
                                  "drawing is in -90,0,90,0 in the drawing's coordinates, "
                                  "5mm,25mm,95mm,25mm from the paper's top left corner."),
                 outside.constData());
        const QByteArray inside = errorOf(drawing, {"--page", "--keep", "outside"});
        QVERIFY2(inside.contains("Nothing is left: all of the drawing is inside the window."),
                 inside.constData());
        QVERIFY(errorOf("<svg xmlns='http://www.w3.org/2000/svg'/>", {})
                    .contains("The drawing is empty: there is nothing to cut."));
        QVERIFY(!errorOf(drawing, {}).contains("Nothing is left"));
        QCOMPARE(errorOf(drawing, {"-w", "100,0,200,20", "-q"}), "");
    }

    // A border on the page's edge is kept whole by --page, whatever the size of the page.
    void thePageKeepsABorderOfEverySize_data()
    {
        QTest::addColumn<QByteArray>("unit");
        QTest::addColumn<bool>("boxed");
        for (const char* unit : {"", "px", "mm", "in"})
            for (const bool boxed : {false, true})
                QTest::addRow("%s, %s", unit, boxed ? "view box" : "no view box")
                    << QByteArray(unit) << boxed;
    }
    void thePageKeepsABorderOfEverySize()
    {
        QFETCH(QByteArray, unit);
        QFETCH(bool, boxed);
        const auto commands = app::commands();
        const app::ParsedArguments parsed(commands.front(), {"-", "-o", "-", "--page"});
        QCOMPARE(commands.front().key, "clip");
        app::CutOptions options{clipping::findAlgorithm("exact")->corrected.clipAll};
        for (int size = 1; size <= 5000; size += tests::caseStep()) {
            const QByteArray n = QByteArray::number(size), length = n + unit;
            const QByteArray border = boxed ? n : length;
            QByteArray svg =
                "<svg xmlns='http://www.w3.org/2000/svg' width='" + length + "' height='" + length
                + "'" + (boxed ? " viewBox='0 0 " + n + ' ' + n + "'" : "") + "><rect width='"
                + border + "' height='" + border + "' fill='none' stroke='red'/></svg>";
            QBuffer buffer(&svg);
            buffer.open(QIODevice::ReadOnly);
            const auto imported = app::findFormat(u"svg")->read(buffer);
            QVERIFY(imported);
            options.region = app::regionOf(app::windowsOf(parsed, *imported.value),
                                           imported.value->document.page());
            const auto cut = app::cut(imported.value->document, options);
            QVERIFY2(cut.counts.whole == 1 && cut.counts.cut == 0, svg.constData());
        }
    }

    // A page whose view box has another proportion: --page is the whole sheet.
    void thePageIsTheSheet()
    {
        const auto run =
            clearcut({"clip", "-", "--from", "svg", "--to", "csv", "-o", "-", "--page"},
                     "<svg xmlns='http://www.w3.org/2000/svg' width='200mm' "
                     "height='100mm' viewBox='0 0 100 100'>"
                     "<path d='M-500 50H500M50 -500V500' stroke='red'/></svg>");
        QVERIFY2(run.out.contains("\n-50,50,150,50,") && run.out.contains("\n50,0,50,100,"),
                 run.out.constData());
    }

    void hiddenShapesAreCutAndStayHidden()
    {
        const QByteArray line = "<path d='M-9 5H99' stroke='red'/>";
        const QByteArray drawing =
            "<svg xmlns='http://www.w3.org/2000/svg' "
            "xmlns:i='http://www.inkscape.org/namespaces/inkscape' "
            "xmlns:s='http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd' width='10' height='10'>"
            "<g i:groupmode='layer' i:label='shown'>"
            + line
            + "<path d='M-9 6H99' display='none'/></g>"
              "<g i:groupmode='layer' i:label='hidden' display='none'>"
            + line + line
            + "</g>"
              "<g i:groupmode='layer' i:label='locked' s:insensitive='true'>"
            + line + "</g></svg>";
        writeText(path("hidden.svg"), drawing);
        const auto cut = [&](const QStringList& more) {
            return clearcut(QStringList{"clip", path("hidden.svg"), "-w", "0,0,10,10"} + more);
        };
        const auto run = cut({"-o", path("cut.svg")});
        QVERIFY2(
            run.err.contains(
                "Shapes: 0 kept whole, 5 cut, 0 removed.\nHidden shapes are cut like the others: 3 "
                "left and still hidden, 0 removed. --drop-hidden leaves out all of them."),
            run.err.constData());
        const app::Sheet before = sheetOf(drawing), sheet = sheetOf(contentOf(path("cut.svg")));
        QCOMPARE(sheet.layers, before.layers);
        QCOMPARE(sheet.shapes.size(), before.shapes.size());
        for (std::size_t i = 0; i < sheet.shapes.size(); ++i) {
            QCOMPARE(sheet.shown(sheet.shapes[i]), before.shown(before.shapes[i]));
            QCOMPARE(sheet.shapes[i].paths.at(0).start.x, 0.0);
            QCOMPARE(sheet.shapes[i].paths.at(0).segments.at(0).to.x, 10.0);
        }

        const auto dropped = cut({"-o", path("dropped.svg"), "--drop-hidden"});
        QVERIFY2(dropped.err.contains(
                     "Shapes: 0 kept whole, 2 cut, 0 removed.\nHidden shapes: 3 left out."),
                 dropped.err.constData());
        const app::Sheet shown = sheetOf(contentOf(path("dropped.svg")));
        QCOMPARE(shown.layers.size(), 2u);
        QCOMPARE(shown.layers.at(1).name, "locked");
        QCOMPARE(shown.shapes.size(), 2u);
        QCOMPARE(shown.shapes.at(1).layer, 1u);

        QCOMPARE(cut({"--in-place"}).code, 0);
        QCOMPARE(sheetOf(contentOf(path("hidden.svg"))), sheet);
    }

    // A hidden line on the left, a visible one on the right, and windows that meet either.
    void hiddenShapesThatAreGoneAreNotCountedAsHidden_data()
    {
        QTest::addColumn<QString>("window");
        QTest::addColumn<QByteArray>("hidden"); // what is said of the hidden shape
        QTest::addColumn<QByteArray>("why");    // that nothing (visible) is left
        const QByteArray left = "1 left and still hidden, 0 removed.",
                         gone = "0 left and still hidden, 1 removed.";
        QTest::newRow("all whole") << "0,0,100,10" << left << QByteArray();
        QTest::newRow("both cut") << "20,0,80,10" << left << QByteArray();
        QTest::newRow("hidden gone") << "50,0,100,10" << gone << QByteArray();
        QTest::newRow("visible gone") << "0,0,50,10" << left
                                      << QByteArray("Nothing visible is left: every visible shape "
                                                    "is outside the window. These shapes "
                                                    "are in 70,5,90,5 in ");
        QTest::newRow("both gone")
            << "0,0,100,1" << gone << QByteArray("Nothing is left: all of the drawing is outside");
    }
    void hiddenShapesThatAreGoneAreNotCountedAsHidden()
    {
        QFETCH(QString, window);
        QFETCH(QByteArray, hidden);
        QFETCH(QByteArray, why);
        const QStringList clip{"clip", "-", "--from", "svg", "--to", "svg", "-o", "-", "-w"};
        const auto drawing = [](const QByteArray& more) {
            return "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='10'>"
                   "<path d='M10 5H30' stroke='red' display='none'/>"
                   + more + "</svg>";
        };
        const auto run =
            clearcut(clip + QStringList{window}, drawing("<path d='M70 5H90' stroke='red'/>"));
        QCOMPARE(run.code, 0);
        QVERIFY2(run.err.contains("Hidden shapes are cut like the others: " + hidden),
                 run.err.constData());
        QCOMPARE(run.err.contains("is left: "), !why.isEmpty());
        QVERIFY2(run.err.contains(why), run.err.constData());
        const bool kept = hidden.startsWith('1');
        QCOMPARE(clearcut(clip + QStringList{window}, drawing({}))
                     .err.contains("Nothing visible is left: every shape is hidden."),
                 kept);
    }

    void formatsThatCannotHideReportHiddenShapes()
    {
        const QByteArray drawing = "<svg xmlns='http://www.w3.org/2000/svg' width='10' height='10'>"
                                   "<path d='M1 5H9' stroke='red'/><path d='M1 6H9' stroke='red' "
                                   "display='none'/></svg>";
        for (const auto& format : app::formats())
            for (const char* command : {"clip", "convert"}) {
                if (!format.write)
                    continue;
                const QString key = QLatin1StringView(format.key);
                const QStringList arguments{command, "-", "--from", "svg", "--to", key, "-o", "-"};
                const auto run = clearcut(arguments, drawing);
                const QByteArray said = "Hidden shapes: 1 left out; a file of type " + key.toUtf8()
                                        + " cannot hide them.";
                QCOMPARE(run.err.contains(said), format.hides == app::StoresHidden::No);
                QCOMPARE(clearcut(arguments + QStringList{"-q"}, drawing).err, "");
            }
    }

    void theTitleAndLicenceAreStillThereAfterACut()
    {
        const QByteArray about =
            "<title>Plan</title><desc>of a house</desc><metadata><rdf:RDF "
            "xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#' "
            "xmlns:dc='http://purl.org/dc/elements/1.1/'><dc:creator>A. Drawer</dc:creator>"
            "<dc:rights rdf:resource='http://cc.example/by/4.0/'/></rdf:RDF></metadata>";
        const auto run = clearcut({"clip", "-", "--from", "svg", "--to", "svg", "-o", "-"},
                                  "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>"
                                      + about + "<path d='M-1 1H99' stroke='red'/></svg>");
        QVERIFY(run.code == 0 && !run.err.contains("not kept"));
        for (const char* part :
             {"<title>Plan</title>", "<desc>of a house</desc>",
              "<dc:creator>A. Drawer</dc:creator>", "\"http://cc.example/by/4.0/\""})
            QVERIFY2(run.out.contains(part), run.out.constData());
    }

    void markersAreLostAndTheirLinesAreKept()
    {
        const auto run = clearcut({"convert", "-", "--from", "svg", "--to", "csv", "-o", "-"},
                                  "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>"
                                  "<path d='M0 0H9' stroke='red' marker-end='url(#a)'/></svg>");
        QCOMPARE(run.err, "1 × arrowhead or other marker (not kept; its line is kept; line 1)\n");
        QCOMPARE(run.out.count('\n'), 2);
    }

    void convertTakesATolerance()
    {
        const auto rows = [&](const QStringList& more) {
            return clearcut(QStringList{"convert", "-", "--from", "svg", "--to", "csv", "-o", "-"}
                                + more,
                            "<svg xmlns='http://www.w3.org/2000/svg' width='90mm' height='90mm' "
                            "viewBox='0 0 180 180'><circle cx='90' cy='90' r='80'/></svg>")
                .out.count('\n');
        };
        QVERIFY(rows({"--tolerance", "1mm"}) < rows({}) / 2);
        QCOMPARE(rows({"--tolerance", "0.1"}), rows({}));
        QCOMPARE(clearcut({"convert", "-", "--from", "svg", "--to", "csv", "-o", "-", "--tolerance",
                           "0"},
                          "<svg xmlns='http://www.w3.org/2000/svg'/>")
                     .code,
                 2);
    }

    void theWindowOfTheDrawingOrItsPage()
    {
        const QByteArray drawing =
            "<svg xmlns='http://www.w3.org/2000/svg' xmlns:clearcut='urn:clearcut:1' width='40mm' "
            "height='20mm' viewBox='0 0 80 40'>%1<path d='M-10 9h200' stroke='red'/></svg>";
        auto plain = drawing, windowed = drawing;
        plain.replace("%1", "");
        windowed.replace(
            "%1", "<metadata><clearcut:window xmin='5' ymin='6' xmax='7' ymax='18'/></metadata>");
        const auto line = [&](const QByteArray& text, const QStringList& more) {
            const QStringList usual{"clip", "-", "--from", "svg", "--to", "csv", "-o", "-", "-q"};
            return clearcut(usual + more, text).out.split('\n').value(1);
        };
        QCOMPARE(line(plain, {}), "0,9,80,9,Drawing,#ff0000,1");
        QCOMPARE(line(windowed, {}), "5,9,7,9,Drawing,#ff0000,1");
        QCOMPARE(line(windowed, {"--page"}), "0,9,80,9,Drawing,#ff0000,1");
        QCOMPARE(line(windowed, {"--page", "--margin", "1mm"}), "2,9,78,9,Drawing,#ff0000,1");
        QCOMPARE(line(windowed, {"--page", "--margin=-1"}), "-1,9,81,9,Drawing,#ff0000,1");
        QCOMPARE(line(plain, {"-w", "1cm,0mm,0.6in,1mm"}), "");
        QCOMPARE(line(plain, {"-w", "1cm,0mm,20.5mm,10mm"}), "20,9,41,9,Drawing,#ff0000,1");
    }

    // Two windows with a gap, a hole in the second, and one that is hidden.
    void allSavedWindowsCut_data()
    {
        QTest::addColumn<QByteArray>("windows");
        QTest::addColumn<QStringList>("more");
        QTest::addColumn<QByteArray>("lines");
        QTest::addColumn<QByteArray>("said");
        const auto window = [](const QByteArray& x, const QByteArray& more) {
            return "<clearcut:window ymin='0' ymax='20' " + x + ' ' + more + "/>";
        };
        const QByteArray two = window("xmin='5' xmax='20'", "") + window("xmin='30' xmax='60'", ""),
                         hole = window("xmin='40' xmax='50'", "operation='cut-out'"),
                         hidden = window("xmin='0' xmax='90'", "visible='no'");
        const auto row = [](const char* name, const QByteArray& windows, const QStringList& more,
                            const QByteArray& lines, const QByteArray& said) {
            QTest::newRow(name) << windows << more << lines << said;
        };
        row("several", hidden + two + hole, {}, "5-20 30-40 50-60",
            "Windows (saved in the drawing): add 5,0,20,20 in the drawing's coordinates; add "
            "30,0,60,20 in the drawing's coordinates; cut out 40,0,50,20 in the drawing's "
            "coordinates.");
        row("outside", two + hole, {"--keep", "outside"}, "0-5 20-30 40-50 60-90",
            "Windows (saved in the drawing): ");
        const QByteArray kept = window("xmin='5' xmax='20'", "keep='outside'");
        row("its side", kept, {}, "0-5 20-90", "Window (saved in the drawing): 5,0,20,20 in ");
        row("another side", kept, {"--keep", "inside"}, "5-20", "Window (saved in the drawing): ");
        row("a hole", hole, {}, "0-40 50-90",
            "Windows (saved in the drawing): cut out 40,0,50,20 in ");
        row("all hidden", hidden, {}, "0-90", "Window (the page): 0,0,90,20 in ");
        row("another one", two + hole, {"-w", "35,0,45,20"}, "35-45",
            "Window (given): 35,0,45,20 in ");
    }
    void allSavedWindowsCut()
    {
        QFETCH(QByteArray, windows);
        QFETCH(QStringList, more);
        const QByteArray drawing =
            "<svg xmlns='http://www.w3.org/2000/svg' xmlns:clearcut='urn:clearcut:1' width='90mm' "
            "height='20mm' viewBox='0 0 90 20'><metadata>"
            + windows + "</metadata><path d='M0 9h90' stroke='red'/></svg>";
        const auto run = clearcut(
            QStringList{"clip", "-", "--from", "svg", "--to", "csv", "-o", "-"} + more, drawing);
        QByteArrayList found;
        for (const QByteArray& row : run.out.split('\n').mid(1))
            if (const auto numbers = row.split(','); numbers.size() > 3)
                found << numbers[0] + '-' + numbers[2];
        QTEST(found.join(' '), "lines");
        QFETCH(QByteArray, said);
        QVERIFY2(run.err.contains(said), run.err.constData());
        const auto svg = clearcut(
            QStringList{"clip", "-", "--from", "svg", "--to", "svg", "-o", "-"} + more, drawing);
        QVERIFY(!svg.out.contains("clearcut:window "));
    }

    void layersInterleavedComeBackInTheOrderOfTheRows()
    {
        const auto run =
            clearcut({"clip", "-", "--from", "csv", "--to", "csv", "-o", "-", "-w", "0,0,9,9"},
                     "1,1,2,2,b\n20,1,30,2,a\n3,3,4,4,a\n# no row\n5,5,6,6,b\n");
        QCOMPARE(run.out,
                 csvHeader
                     + "1,1,2,2,b,#000000,1,0\n3,3,4,4,a,#000000,1,2\n5,5,6,6,b,#000000,1,3\n");
    }

    void curvesAreCutAsCurvesAndTabledAsLinesInsideTheWindow()
    {
        const QByteArray drawing =
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100' width='100mm' "
            "height='100mm'><circle cx='50' cy='50' r='40' fill='none' stroke='black'/></svg>";
        const QStringList usual{"clip", "-", "--from", "svg", "-w", "20.3,0,66.7,71.9",
                                "-o",   "-", "-q"};
        const auto svg = clearcut(usual + QStringList{"--to", "svg"}, drawing);
        const auto& shapes = sheetOf(svg.out).shapes;
        QCOMPARE(shapes.size(), 1u);
        QVERIFY(std::ranges::all_of(shapes[0].paths, [](const app::Subpath& path) {
            return !path.closed && std::ranges::all_of(path.segments, &app::PathSegment::curved);
        }));
        const auto rows = clearcut(usual + QStringList{"--to", "csv"}, drawing).out.split('\n');
        QVERIFY(rows.size() > 10);
        const auto coarse =
            clearcut(usual + QStringList{"--to", "csv", "--tolerance", "1mm"}, drawing);
        QVERIFY(coarse.out.count('\n') < rows.size() / 2);
        for (const QByteArray& row : rows.sliced(1)) {
            const auto fields = row.split(',');
            for (int i = 0; i < 4 && fields.size() > 1; ++i) {
                const double number = fields[i].toDouble();
                QVERIFY(number >= (i % 2 ? 0 : 20.3) && number <= (i % 2 ? 71.9 : 66.7));
            }
        }
    }

    void decimalsStayInTheWindow()
    {
        const auto run = clearcut({"clip", "-", "--from", "csv", "--to", "csv", "-o", "-",
                                   "--precision", "1", "-w", "-0.17,-0.17,0.17,0.17"},
                                  "-1,0.333,1,-0.1\n-1,-1,1,1\n");
        QCOMPARE(
            run.out,
            csvHeader
                + "-0.1,0.1,0.1,0.1,Drawing,#000000,1,0\n-0.1,-0.1,0.1,0.1,Drawing,#000000,1,1\n");
    }

    void theSvgAgreesWithAClipPathOfLibrsvg_data()
    {
        QTest::addColumn<QString>("algorithm");
        for (const auto& algorithm : clipping::algorithms())
            QTest::newRow(qPrintable(key(algorithm))) << key(algorithm);
    }
    // Our cut drawing, against librsvg masking the whole drawing. Caps and joins are the difference
    // that there has to be: a cut acts on the centre line, a mask on the ink.
    void theSvgAgreesWithAClipPathOfLibrsvg()
    {
        QFETCH(QString, algorithm);
        QByteArray art;
        for (int i = 0; i < 60; ++i)
            art += QByteArrayLiteral("<path d='M%1 10 L%2 190'/><path d='M%1 %2 C 20 190 190 20 %2 "
                                     "%1' stroke-dasharray='7 4 2'/>")
                       .replace("%1", QByteArray::number(i * 7 % 200))
                       .replace("%2", QByteArray::number(i * 37 % 200));
        const QByteArray head = "<svg xmlns='http://www.w3.org/2000/svg' width='800' height='800' "
                                "viewBox='0 0 200 200'>";
        const QByteArray style = " fill='none' stroke='black' stroke-width='.5'>";
        writeText(path("art.svg"), head + "<g" + style + art + "</g></svg>");
        writeText(
            path("masked.svg"),
            head
                + "<clipPath id='c'><rect x='45.5' y='30.25' width='100' height='120'/></clipPath>"
                  "<g clip-path='url(#c)'><g"
                + style + art + "</g></g></svg>");
        QCOMPARE(clearcut({"clip", path("art.svg"), "-o", path("cut.svg"), "-a", algorithm, "-w",
                           "45.5,30.25,145.5,150.25"})
                     .code,
                 0);
        QImage pictures[2];
        for (const int i : {0, 1}) {
            const QString png = path(QString::number(i) + ".png");
            runProgram("rsvg-convert",
                       {"-b", "white", "-o", png, path(i ? "cut.svg" : "masked.svg")});
            pictures[i] = QImage(png).convertToFormat(QImage::Format_Grayscale8);
        }
        QCOMPARE(pictures[0].size(), QSize(800, 800));
        QCOMPARE(pictures[1].size(), QSize(800, 800));
        qint64 ink = 0, different = 0;
        for (int y = 0; y < 800; ++y)
            for (int x = 0; x < 800; ++x) {
                const int a = qGray(pictures[0].pixel(x, y)), b = qGray(pictures[1].pixel(x, y));
                ink += 255 - a;
                different += std::abs(a - b);
            }
        QVERIFY(ink > 1'000'000);
        QVERIFY2(different < ink / 100,
                 qPrintable(QStringLiteral("%1 of %2").arg(different).arg(ink)));
    }

    void everyFormatIsWritten()
    {
        writeText(path("a.csv"), "0,0,90,90\n");
        for (const auto& format : app::formats()) {
            if (!format.write)
                continue;
            const auto name = QString::fromUtf8(format.key.data(), qsizetype(format.key.size()));
            const QString out = path("out." + name);
            const auto toFile = clearcut({"clip", path("a.csv"), "-o", out, "--dpi", "50"});
            QCOMPARE(toFile.code, 0);
            const auto toStream =
                clearcut({"clip", path("a.csv"), "--to", name, "-o", "-", "--dpi", "50"});
            QVERIFY(toStream.out.size() > 40);
            QCOMPARE(toStream.out, contentOf(out));
        }
        QVERIFY(!QImage(path("out.png")).isNull());
    }

    void theReportSaysWhatWasLost()
    {
        writeText(path("text.svg"), "<svg xmlns='http://www.w3.org/2000/svg' width='10' "
                                    "height='10'><image/><image/><rect x='-5' "
                                    "width='10' height='10' fill='red'/></svg>");
        const auto run = clearcut({"clip", path("text.svg"), "-o", path("x.svg"), "--stats"});
        QCOMPARE(run.code, 0);
        QVERIFY2(run.err.contains("2 × image"), run.err.constData());
        QVERIFY2(run.err.contains("Shapes: 0 kept whole, 1 cut, 0 removed.\n"
                                  "Window (the page): "
                                  "0,0,10,10 in the drawing's coordinates, 0mm,0mm,2.646mm,2.646mm "
                                  "from the paper's top left corner.\nLines: 4 before, "),
                 run.err.constData());
        QCOMPARE(run.out, "");
        QCOMPARE(clearcut({"clip", path("text.svg"), "-o", path("x.svg"), "-q"}).err, "");
    }

    // An area without a stroke has no path that could be opened.
    void onlyOpenedStrokesAreReported()
    {
        const auto reported = [](const QByteArray& stroke) {
            return clearcut(
                       {"clip", "-", "--from", "svg", "--to", "svg", "-o", "-", "-w", "0,0,50,50"},
                       "<svg xmlns='http://www.w3.org/2000/svg' width='99' height='99'>"
                       "<polygon points='10,10 90,10 90,90 70,40 50,90 30,40' fill='#f00' "
                       "stroke='"
                           + stroke + "'/></svg>")
                .err;
        };
        QVERIFY(reported("#000").startsWith(
            "Shapes: 0 kept whole, 1 cut, 0 removed; closed paths opened: 1.\n"));
        QVERIFY(reported("none").startsWith("Shapes: 0 kept whole, 1 cut, 0 removed.\n"));
    }

    // Where lines only touch the window, the counts are the same for every type of file.
    void contactsAreReportedAlike_data()
    {
        QTest::addColumn<QStringList>("more");
        QTest::addColumn<QByteArray>("what");
        QTest::newRow("svg") << QStringList{"--to", "svg"} << QByteArray("left out");
        QTest::newRow("pdf") << QStringList{"--to", "pdf"} << QByteArray("left out");
        QTest::newRow("csv") << QStringList{"--to", "csv"} << QByteArray("kept as points");
        QTest::newRow("csv as a drawing")
            << QStringList{"--to", "csv", "--occlude"} << QByteArray("kept as points");
    }
    void contactsAreReportedAlike()
    {
        QFETCH(QStringList, more);
        QFETCH(QByteArray, what);
        const QByteArray touching = "0,0,10,10\n5,20,15,0\n", cut = "0,15,30,15\n";
        const auto errorOf = [&](const QByteArray& table) {
            auto run = clearcut(
                QStringList{"clip", "-", "--from", "csv", "-o", "-", "-w", "10,10,20,20"} + more,
                table);
            return run.code == 0 ? run.err.replace("Shapes with covered lines: 0 cut, 0 removed; "
                                                   "fills removed: 0.\n",
                                                   "")
                                 : "failed";
        };
        const QByteArray report = "; only touching the window, and " + what + ": 2.\n";
        QVERIFY2(errorOf(touching + cut + "50,50,60,60\n")
                     .startsWith("Shapes: 0 kept whole, 1 cut, 1 removed" + report),
                 errorOf(touching + cut + "50,50,60,60\n"));
        const QByteArray all = errorOf(touching);
        QVERIFY2(all.startsWith("Shapes: 0 kept whole, 0 cut, 0 removed" + report), all);
        QCOMPARE(all.contains("Nothing is left: no line of the drawing is in the window, but some "
                              "touch it."),
                 what == "left out");
    }

    // Rounding makes neither repeated points nor lines without length; a point stays one.
    void fewDecimalsMakeNoPoints()
    {
        const QByteArray drawing =
            "<svg xmlns='http://www.w3.org/2000/svg' width='10' height='10' fill='none' "
            "stroke='red'><path d='M0 0L.2 .2L.4 .4L5 5L5.1 5.1'/><path d='M1 1L1.2 1.2'/>"
            "<path d='M7 7h0' stroke-linecap='round'/><path d='M2 2C2.1 2 2 2.1 2.2 2.2'/></svg>";
        const auto converted = [&](const char* type, const QByteArray& input, const char* from) {
            return clearcut(
                {"convert", "-", "--from", from, "--to", type, "-o", "-", "--precision", "0"},
                input);
        };
        const auto svg = converted("svg", drawing, "svg");
        QVERIFY2(svg.out.contains("<line x1=\"0\" y1=\"0\" x2=\"5\" y2=\"5\""), svg.out);
        QVERIFY(svg.out.contains("<line x1=\"7\" y1=\"7\" x2=\"7\" y2=\"7\""));
        QCOMPARE(svg.out.count("<line") + svg.out.count("<path") + svg.out.count("<poly"), 2);
        const QByteArray told = "Lines that --precision would make points are left out: 2.\n";
        QCOMPARE(svg.err, told);
        const auto csv = converted("csv", drawing, "svg");
        QCOMPARE(csv.out.split('\n').mid(1),
                 (QByteArrayList{"0,0,5,5,Drawing,#ff0000,1", "7,7,7,7,Drawing,#ff0000,1", ""}));
        QCOMPARE(csv.err, told);
        QCOMPARE(converted("pdf", drawing, "svg").err, told);
        // From table to table the rows are the same, whether they are read as a drawing or not.
        const QByteArray table = "0,0,.2,.2\n.4,.4,5,5\n7,7,7,7\n";
        const QStringList clip{"clip", "-", "--from", "csv",     "--to",        "csv",
                               "-o",   "-", "-w",     "0,0,9,9", "--precision", "0"};
        const auto rows = clearcut(clip, table),
                   whole = clearcut(clip + QStringList{"--occlude"}, table);
        QCOMPARE(rows.out.split('\n').mid(1), (QByteArrayList{"0,0,5,5,Drawing,#000000,1,1",
                                                              "7,7,7,7,Drawing,#000000,1,2", ""}));
        QCOMPARE(whole.out, rows.out);
        QVERIFY(rows.err.contains("Lines that --precision would make points are left out: 1.\n"));
        QVERIFY(whole.err.contains("Lines that --precision would make points are left out: 1.\n"));
    }

    void theOutputHasNoWindowAndCuttingAgainChangesNothing()
    {
        const QString rosette = SOURCE_DIR "/resources/samples/rosette.svg";
        const QStringList window{"-w", "33.3,44.4,155.5,166.6"};
        QCOMPARE(clearcut(QStringList{"clip", rosette, "-o", path("1.svg")} + window).code, 0);
        QCOMPARE(clearcut(QStringList{"clip", path("1.svg"), "-o", path("2.svg")} + window).code,
                 0);
        const auto once = sheetOf(contentOf(path("1.svg"))),
                   twice = sheetOf(contentOf(path("2.svg")));
        QVERIFY(contentOf(rosette).contains("clearcut:window "));
        QVERIFY(!contentOf(path("1.svg")).contains("clearcut:window "));
        QVERIFY(!once.shapes.empty());
        QCOMPARE(twice, once);
    }

    void inPlaceOnlyWhenAskedAndWhenNothingIsLost()
    {
        const QByteArray text = "0,0,90,90\n";
        writeText(path("b.csv"), text);
        const QStringList clip{"clip", path("b.csv"), "-w", "0,0,1,1"};
        QCOMPARE(clearcut(clip + QStringList{"-o", path("b.csv")}).code, 2);
        QCOMPARE(clearcut(clip + QStringList{"-o", path("./b.csv")}).code, 2);
        QFile::link(path("b.csv"), path("link.csv"));
        QCOMPARE(clearcut(clip + QStringList{"-o", path("link.csv")}).code, 2);
        QCOMPARE(contentOf(path("b.csv")), text);
        QCOMPARE(clearcut(clip + QStringList{"--in-place"}).code, 0);
        QCOMPARE(contentOf(path("b.csv")), csvHeader + "0,0,1,1,Drawing,#000000,1,0\n");

        const QByteArray lossy =
            "<svg xmlns='http://www.w3.org/2000/svg' width='10' height='10'><text>hi</text></svg>";
        writeText(path("c.svg"), lossy);
        const auto refused = clearcut({"clip", path("c.svg"), "--in-place"});
        QCOMPARE(refused.code, 1);
        QVERIFY2(refused.err.contains("1 × text"), refused.err.constData());
        QCOMPARE(contentOf(path("c.svg")), lossy);
    }

    void convertCutsNothing()
    {
        const QString rosette = SOURCE_DIR "/resources/samples/rosette.svg";
        QCOMPARE(clearcut({"convert", rosette, "-o", path("r.svg")}).code, 0);
        QCOMPARE(sheetOf(contentOf(path("r.svg"))), sheetOf(contentOf(rosette)));
        const auto csv = clearcut({"convert", "-", "--from", "csv", "-o", "-", "--to", "csv"},
                                  "0,1,2,3,b\n4,5,6,7,a\n");
        QCOMPARE(csv.out, csvHeader + "0,1,2,3,b,#000000,1,0\n4,5,6,7,a,#000000,1,1\n");
        QCOMPARE(csv.err, "");
    }

    void namesMayBeginWithADash()
    {
        writeText(path("d.csv"), "0,0,1,1\n");
        const auto run =
            runProgram("/bin/bash", {"-c", "cd " + folder_.path()
                                               + " && cp d.csv -- -d.csv && '" CLEARCUT_BINARY
                                                 "' clip -o - --to csv -- -d.csv"});
        QCOMPARE(run.code, 0);
        QVERIFY(run.out.startsWith("x1,"));
    }
};

} // namespace command_line_clip_test

TEST_CLASS(command_line_clip_test::ClipTest, Core)
#include "tests/app/command_line/clip_test.moc"
