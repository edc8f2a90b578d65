// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/variant.h"
#include "app/document/paper.h"
#include "app/export/drawn_box.h"
#include "app/export/export_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

#include "tests/app/document/sheet.h"
#include "tests/content_of.h"
#include "tests/test_class.h"

namespace export_export_drawing_test {

using namespace app;

namespace {

Shape line(const Point& a, const Point& b, std::uint32_t layer = 0)
{
    return {{{a, {{b}}, false}}, {.stroke = Colour{}, .width = 1}, {}, layer};
}

/// On an A4 page: a line across two windows and over the page's edge, one on a layer of its own,
/// and a hidden one.
Document drawing()
{
    Sheet sheet;
    sheet.layers = {{QStringLiteral("Walls")}, {QStringLiteral("Rooms")}, {"Hidden", false}};
    sheet.shapes = {line({-10, 50}, {400, 50}), line({100, 100}, {120, 110}, 1),
                    line({1, 1}, {2, 2}, 2)};
    Document document = documentOf(sheet);
    document.apply({.windows = ClipWindows{{{.shape = RectangleShape{{{20, 20}, {60, 80}}}},
                                            {.shape = RectangleShape{{{90, 40}, {130, 120}}}}}}});
    return document;
}

ExportJob jobOf(ExportPart part, const char* format = "svg")
{
    return {{drawing(), {}, usualAlgorithm().corrected.clipAll, {}},
            {.format = format, .area = {part}}};
}

/// The lines of a drawing that are shown.
std::vector<std::pair<Point, Point>> linesIn(const Document& document)
{
    std::vector<std::pair<Point, Point>> lines;
    const Sheet sheet = sheetOf(document);
    for (const Shape& shape : sheet.shapes)
        if (sheet.shown(shape))
            for (const Subpath& path : shape.paths)
                lines.emplace_back(path.start, path.segments.back().to);
    return lines;
}

using Lines = std::vector<std::pair<Point, Point>>;

} // namespace

class ExportDrawingTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    static ExportDrawing made(const ExportJob& job)
    {
        auto drawing = exportDrawing(job);
        if (!drawing)
            qFatal("%s", qPrintable(drawing.error));
        return std::move(*drawing.value);
    }

private slots:
    // Lengths of the drawing may be metres or feet, which SVG does not know for its paper.
    void thePaperHasAUnitOfPaper()
    {
        ExportJob job = jobOf(ExportPart::Cut);
        Page page = job.source.document.page();
        page.scale.unit = Unit::Metre;
        page.margins = {10, 10, 10, 10, true};
        job.source.document.apply({.page = page});
        const Page made = ExportDrawingTest::made(job).document.page();
        QCOMPARE(made.width.unit, page.width.unit);
        QVERIFY(!made.margins.shown);
        const QString file = folder_.filePath("metres.svg");
        QVERIFY(exportFile(job, file).end == WriteResult::End::Written);
        const auto read = readFile(file);
        QVERIFY(read);
        QCOMPARE(millimetresOf(read.value->document.page()), millimetresOf(made));
    }

    void aPartThatIsKeptTwiceOnlyHasItsOwnPaper()
    {
        ExportJob job = jobOf(ExportPart::Cut);
        const auto window = [](double from, WindowOperation operation) {
            return ClipWindow{.shape = RectangleShape{{{from, 0}, {from + 10, 100}}},
                              .operation = operation};
        };
        job.source.document.apply({.windows = ClipWindows{{window(0, WindowOperation::Add),
                                                           window(20, WindowOperation::Intersect),
                                                           window(100, WindowOperation::Add)}}});
        const Page page = ExportDrawingTest::made(job).document.page();
        QCOMPARE(page.rectangle().min.x, 100.0);
        QCOMPARE(page.rectangle().max.x, 110.0);
    }

    void theCutDrawingIsAsLargeAsItsWindows()
    {
        const Document cut = made(jobOf(ExportPart::Cut)).document;
        QCOMPARE(linesIn(cut),
                 (Lines{{{20, 50}, {60, 50}}, {{90, 50}, {130, 50}}, {{100, 100}, {120, 110}}}));
        QCOMPARE(cut.page().rectangle(), (clipping::Window{{20, 20}, {130, 120}}));
        QCOMPARE(cut.page().width, (Length{110, Unit::Mm}));
        QCOMPARE(cut.page().millimetresPerUnit(), 1.0);
        QVERIFY(cut.windows().list.empty());
    }
    void thePageIsCutAtItsOwnEdge()
    {
        const Document page = made(jobOf(ExportPart::Page)).document;
        QCOMPARE(linesIn(page), (Lines{{{0, 50}, {297, 50}}, {{100, 100}, {120, 110}}}));
        QCOMPARE(page.page().rectangle(), drawing().page().rectangle());
    }
    void oneWindowIsTakenAlone()
    {
        ExportJob job = jobOf(ExportPart::Window);
        job.choice.area.window = 1;
        const Document window = made(job).document;
        QCOMPARE(linesIn(window), (Lines{{{90, 50}, {130, 50}}, {{100, 100}, {120, 110}}}));
        QCOMPARE(window.page().rectangle(), (clipping::Window{{90, 40}, {130, 120}}));
    }
    void theSelectionIsWholeAndAlone()
    {
        ExportJob job = jobOf(ExportPart::Selection);
        job.source.selection = ObjectRanges{0};
        const Document selected = made(job).document;
        QCOMPARE(linesIn(selected), (Lines{{{-10, 50}, {400, 50}}}));
        QCOMPARE(selected.containers().size(), std::size_t(1)); // layers without objects are gone
        QCOMPARE(selected.page().rectangle(), (clipping::Window{{-10, 49.5}, {400, 50.5}}));
    }
    void aLayerIsWholeAndAlone()
    {
        ExportJob job = jobOf(ExportPart::Layer, "pdf");
        job.choice.area.layer = job.source.document.containers().childrenOf(0).at(1);
        QCOMPARE(linesIn(made(job).document), (Lines{{{100, 100}, {120, 110}}}));
        job.choice.paper = ExportPaper::Page;
        QCOMPARE(made(job).document.page().rectangle(), drawing().page().rectangle());
    }
    void anAreaWithNothingToExportSaysWhy()
    {
        ExportJob job = jobOf(ExportPart::Selection);
        QCOMPARE(exportDrawing(job).error,
                 QStringLiteral("Nothing can be exported: nothing is selected."));
        job.choice.area = {.part = ExportPart::Layer,
                           .layer = job.source.document.containers().childrenOf(0).at(2)};
        QCOMPARE(faultOf(job.source, job.choice.area), QStringLiteral("it is hidden"));
        job.choice.area = {.part = ExportPart::Window, .window = 2};
        QCOMPARE(faultOf(job.source, job.choice.area), QStringLiteral("there is no clip window"));
        QCOMPARE(usableArea(job.source, job.choice.area).part, ExportPart::Cut);
        job.source.document.apply({.windows = ClipWindows()});
        QCOMPARE(usableArea(job.source, job.choice.area).part, ExportPart::Page);
        for (const ExportPartInfo& info : exportParts())
            QCOMPARE(&exportParts()[std::size_t(info.part)], &info);
    }
    // The tip of a mitred corner reaches farther than half of the width.
    void theBoxHoldsTheTipsOfCorners()
    {
        Sheet sheet;
        sheet.shapes.push_back({{{{0, 0}, {{{10, 0}}, {{0, 5}}}, false}},
                                {.stroke = Colour{}, .width = 2, .miterLimit = 10},
                                {},
                                0});
        const auto box = drawnBox(documentOf(sheet));
        QVERIFY(box);
        const double sine = std::sin(std::atan2(5.0, 10.0) / 2);
        const double tip = 10 + std::cos(std::atan2(5.0, 10.0) / 2) / sine; // width / 2 = 1
        QVERIFY2(std::abs(box->max.x - tip) < 1e-9, qPrintable(QString::number(box->max.x)));
        sheet.shapes[0].style.miterLimit = 2;
        QCOMPARE(drawnBox(documentOf(sheet))->max.x, 10 + 5 / std::hypot(10, 5)); // bevelled
    }
    void theBoxHoldsTheCapsOfLines()
    {
        Sheet sheet;
        sheet.shapes.push_back(line({0, 0}, {10, 0}));
        sheet.shapes[0].style.width = 2;
        const auto box = [&](Cap cap) {
            sheet.shapes[0].style.cap = cap;
            return drawnBox(documentOf(sheet)).value();
        };
        QCOMPARE(box(Cap::Butt), (clipping::Window{{0, -1}, {10, 1}}));
        QCOMPARE(box(Cap::Round), (clipping::Window{{-1, -1}, {11, 1}}));
        QCOMPARE(box(Cap::Square), (clipping::Window{{-1, -1}, {11, 1}}));
        sheet.shapes[0].hidden = true;
        QVERIFY(!drawnBox(documentOf(sheet)));
    }
    void theFactsAreThoseOfWhatIsWritten()
    {
        const ExportJob job = jobOf(ExportPart::Cut, "png");
        const ExportFacts facts = factsOf(made(job), formatOf(job.choice));
        QCOMPARE(facts.paths, std::size_t(2)); // the cut line is one object in two parts
        QCOMPARE(facts.layers, std::size_t(2));
        QVERIFY(std::abs(facts.length - (80 + std::hypot(20, 10))) < 1e-9);
        QCOMPARE(facts.paper, Point(110, 100));
        QCOMPARE(facts.pixels, Point(1299, 1181)); // 300 dpi
    }
    void whatAFileCannotHoldIsSaid()
    {
        QCOMPARE(made(jobOf(ExportPart::Page, "svg")).losses, QStringList());
        QCOMPARE(made(jobOf(ExportPart::Page, "pdf")).losses,
                 QStringList{"1 hidden object is left out"});
        ExportJob job = jobOf(ExportPart::Page, "svg");
        job.source.document = documentOf([] {
            Sheet sheet;
            sheet.shapes = {line({1, 1}, {1.01, 1}), line({1, 2}, {9, 2})};
            return sheet;
        }());
        job.choice.precision = 0;
        QCOMPARE(made(job).losses,
                 QStringList{"1 line becomes a point at this precision and is left out"});
    }

    // The border of the cut area would be lines along the window, and others below the stroke.
    void formatsWithoutFillsCutOnlyTheStroke()
    {
        ExportJob job = jobOf(ExportPart::Cut, "dxf");
        job.choice.dxf = DxfVersion::R12;
        Sheet sheet;
        const Subpath square{{10, 10}, {{{50, 10}}, {{50, 50}}, {{10, 50}}}, true};
        sheet.shapes = {{{square}, {.stroke = Colour{}, .fill = Colour{9, 9, 9, 128}}, {}, 0}};
        job.source.document = documentOf(sheet);
        job.source.document.apply(
            {.windows = ClipWindows{{{.shape = RectangleShape{{{20, 20}, {60, 80}}}}}}});
        const ExportDrawing drawing = made(job);
        QCOMPARE(drawing.document.objects().size(), std::size_t(1));
        QVERIFY(!drawing.document.objects()[0].style().fill);
        QCOMPARE(drawing.losses,
                 (QStringList{"1 area loses its fill", "1 transparent colour becomes opaque"}));
        QCOMPARE(drawing.options.dxf, DxfVersion::R12);
        QCOMPARE(drawing.options.wholePage, std::optional(sheet.page.rectangle()));
        // Of what the cut leaves alone.
        const Subpath away{{500, 10}, {{{550, 10}}, {{550, 50}}}, true};
        sheet.shapes.push_back(sheet.shapes.front());
        sheet.shapes.back().paths = {away};
        ExportJob apart = job;
        const ClipWindows windows = job.source.document.windows();
        apart.source.document = documentOf(sheet);
        apart.source.document.apply({.windows = windows});
        QCOMPARE(made(apart).losses, drawing.losses);
        job.choice.format = "geojson"; // areas are areas
        QCOMPARE(made(job).document.objects().size(), std::size_t(2));
        QCOMPARE(made(job).losses, QStringList());
    }
};

} // namespace export_export_drawing_test

TEST_CLASS(export_export_drawing_test::ExportDrawingTest, Core)
#include "tests/app/export/export_drawing_test.moc"
