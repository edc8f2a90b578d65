// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/variant.h"
#include "app/export/print_job.h"
#include "app/formats/format.h"

#include <QFile>
#include <QPdfWriter>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

#include "tests/app/command_line/program.h"
#include "tests/app/document/sheet.h"
#include "tests/content_of.h"
#include "tests/test_class.h"

namespace export_print_job_test {

using namespace app;

namespace {

constexpr double exact = 0.01; // millimetres

/// A page with a cross of thin lines near its corners, in a unit of half a millimetre.
Document plan(const Point& millimetres)
{
    Sheet sheet;
    sheet.page = {
        {-20, 40}, millimetres * 2.0, {millimetres.x, Unit::Mm}, {millimetres.y, Unit::Mm}};
    sheet.window = sheet.page.rectangle();
    const Point from = sheet.page.min + 30.0, to = sheet.page.min + millimetres * 2.0 - 30.0;
    for (const auto& [a, b] :
         {std::pair(from, to), std::pair(Point(from.x, to.y), Point(to.x, from.y))})
        sheet.shapes.push_back({{{a, {{b}}, false}}, {.stroke = Colour{}, .width = 0.5}, {}, 0});
    return documentOf(sheet);
}

ExportSource sourceOf(const Document& document)
{
    return {document, {}, usualAlgorithm().corrected.clipAll, {}};
}

PrintSheets sheetsOf(const Document& document, const PrintChoice& choice)
{
    const ExportSource source = sourceOf(document);
    const auto drawing = exportDrawing({source, {.format = "pdf", .area = {ExportPart::Page}}});
    auto sheets = printSheets(*drawing.value, choice, source, "plan");
    if (!sheets)
        qFatal("%s", qPrintable(sheets.error));
    return std::move(*sheets.value);
}

/// The lines of a page as poppler reads them, in millimetres from the upper left corner of the
/// paper, and the size of the paper.
struct Seen {
    std::vector<clipping::Segment> lines;
    Point paper{};
};
Seen seenOn(const QString& pdf, int page, const QString& svg)
{
    const QString number = QString::number(page);
    const auto run = runProgram(
        "pdftocairo", {"-svg", "-nocenter", "-noshrink", "-f", number, "-l", number, pdf, svg});
    const auto read = readFile(svg);
    if (run.code != 0 || !read)
        qFatal("%s %s", qPrintable(run.err), qPrintable(read.error));
    const Document& document = read.value->document;
    const double unit = document.page().millimetresPerUnit();
    Seen seen{{}, document.page().size * unit};
    document.objects().forEach(
        0, document.objects().size(), [&](std::size_t, const ObjectView& object) {
            const auto line = object.singleLine();
            if (line && object.style().stroke)
                seen.lines.push_back({(line->a - document.page().min) * unit,
                                      (line->b - document.page().min) * unit});
        });
    return seen;
}

bool near(const Point& a, const Point& b)
{
    return std::abs(a.x - b.x) <= exact && std::abs(a.y - b.y) <= exact;
}

} // namespace

class PrintJobTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString path(const char* name) const { return folder_.filePath(QString::fromLatin1(name)); }

    /// A plan of 180 × 120 mm in the middle of A4, as poppler sees it.
    void isExactOnA4(const QString& pdf, double size)
    {
        const Seen seen = seenOn(pdf, 1, path("seen.svg"));
        QVERIFY2(std::abs(seen.paper.x - 297) < size && std::abs(seen.paper.y - 210) < size,
                 qPrintable(QString("%1 × %2").arg(seen.paper.x).arg(seen.paper.y)));
        QCOMPARE(seen.lines.size(), std::size_t(2));
        const Point corner((297 - 180) / 2.0, (210 - 120) / 2.0);
        const clipping::Segment& line = seen.lines.front();
        const QString text =
            QString("%1 %2 to %3 %4").arg(line.a.x).arg(line.a.y).arg(line.b.x).arg(line.b.y);
        QVERIFY2(near(line.a, corner + 15.0), qPrintable(text));
        QVERIFY2(near(line.b, corner + Point(165, 105)), qPrintable(text));
    }

private slots:
    void aPlanThatFitsIsInTheMiddleOfOneSheet()
    {
        const PrintSheets sheets = sheetsOf(plan({180, 120}), {});
        QVERIFY(sheets.single);
        QCOMPARE(sheets.count(), 1);
        QCOMPARE(sheets.paper(), Point(210, 297));
        QCOMPARE(sheetsOf(plan({250, 120}), {}).paper(), Point(297, 210)); // turned
        QVERIFY(!sheetsOf(plan({250, 120}), {.turn = PaperTurn::Portrait}).single);
        // A whole page of the size of the paper is not divided because of the printer's margin.
        QVERIFY(sheetsOf(plan({210, 297}), {}).single);
    }
    void theFileIsExact()
    {
        const PrintSheets sheets = sheetsOf(plan({180, 120}), {.turn = PaperTurn::Landscape});
        QVERIFY(!printFile(sheets, path("a.pdf")));
        isExactOnA4(path("a.pdf"), exact);
    }
    // Qt rounds the size of the paper to whole points.
    void thePrinterIsExact()
    {
        const PrintSheets sheets = sheetsOf(plan({180, 120}), {.turn = PaperTurn::Landscape});
        {
            QPdfWriter printer(path("b.pdf"));
            printer.setResolution(1200);
            QVERIFY(!printOn(printer, sheets));
        }
        isExactOnA4(path("b.pdf"), 0.4);
    }
    // The two diagonals of a plan of 500 × 300 mm, put together again from what is on the sheets.
    void tilesAreExact()
    {
        const PrintSheets sheets = sheetsOf(plan({500, 300}), {.margin = 8, .marks = false});
        QVERIFY(sheets.count() > 3);
        QVERIFY(!printFile(sheets, path("c.pdf")));
        const Point from(15, 15), to(485, 285);
        int lines = 0;
        for (int page = 0; page < sheets.count(); ++page) {
            const Tile& tile = sheets.sheets.tiling.tiles[std::size_t(page)];
            const Point corner = (tile.window.min - plan({500, 300}).page().min) / 2.0 - 8.0;
            const Seen seen = seenOn(path("c.pdf"), page + 1, path("seen.svg"));
            QVERIFY(near(seen.paper, sheets.paper()));
            for (const clipping::Segment& line : seen.lines)
                for (const Point& end : {line.a + corner, line.b + corner}) {
                    const double t = (end.x - from.x) / (to.x - from.x);
                    const double down = from.y + t * (to.y - from.y);
                    const double up = to.y - t * (to.y - from.y);
                    QVERIFY2(std::min(std::abs(end.y - down), std::abs(end.y - up)) <= exact,
                             qPrintable(QString("%1 %2").arg(end.x).arg(end.y)));
                    ++lines;
                }
        }
        QVERIFY(lines > 2 * sheets.count() / 2);
    }
    void whatCannotBePrintedIsASentence()
    {
        const Document document = plan({5000, 3000});
        const ExportSource source = sourceOf(document);
        const auto drawing = exportDrawing({source, {.format = "pdf", .area = {ExportPart::Page}}});
        for (const PrintChoice& choice :
             {PrintChoice{.paper = {20, 20}, .marks = false}, PrintChoice{.margin = 150},
              PrintChoice{.overlap = 1e9}, PrintChoice{.paper = {0, 0}}}) {
            const auto sheets = printSheets(*drawing.value, choice, source, {});
            QVERIFY(!sheets);
            QVERIFY2(sheets.error.endsWith(u'.'), qPrintable(sheets.error));
        }
    }
    void aStoppedPrintLeavesTheFileAsItWas()
    {
        QFile old(path("old.pdf"));
        QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
        old.close();
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(printFile(sheetsOf(plan({180, 120}), {}), path("old.pdf"), {stop.get_token()}));
        QCOMPARE(contentOf(path("old.pdf")), QByteArray("old"));
        const auto failed = printFile(sheetsOf(plan({180, 120}), {}), path("no folder/a.pdf"));
        QVERIFY(failed && failed->contains("no folder/a.pdf") && failed->endsWith(u'.'));
    }
};

} // namespace export_print_job_test

TEST_CLASS(export_print_job_test::PrintJobTest, Gui)
#include "tests/app/export/print_job_test.moc"
