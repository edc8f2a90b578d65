// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/variant.h"
#include "app/document/document_builder.h"
#include "app/document/flatten.h"
#include "app/tiles/marks.h"
#include "app/tiles/sheets.h"

#include <QDir>
#include <QTest>

#include <glm/geometric.hpp>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace tiles_sheets_test {

using namespace app;

namespace {

const Page page{{0, 0}, {400, 200}, {400, Unit::Mm}, {200, Unit::Mm}, {}};

/// A zigzag and a filled circle-like shape over the whole page.
Document drawing()
{
    DocumentBuilder builder;
    builder.open({.name = "Drawing"});
    Subpath zigzag{{0, 0}, {}, false};
    for (int i = 1; i <= 80; ++i)
        zigzag.segments.push_back({{i * 5.0, i % 2 == 0 ? 0.0 : 200.0}});
    builder.add(Object{.path = Path({&zigzag, 1}), .style = {.stroke = Colour{}, .width = 0.5}});
    builder.close();
    return builder.take(page);
}

Sheets sheets(const TilePlan& plan)
{
    return {drawing(),
            plan,
            *tilingOf(page, plan).value,
            {.clipAll = usualAlgorithm().corrected.clipAll},
            QStringLiteral("plan")};
}

double lengthOf(const Document& document)
{
    double length = 0;
    document.objects().forEach(0, document.objects().size(), [&](auto, const ObjectView& object) {
        std::vector<clipping::Segment> segments;
        appendSegments(object.path(), 0.1, segments);
        for (const auto& [a, b] : segments)
            length += glm::distance(a, b);
    });
    return length;
}

Point centreOfRing(const Object& mark)
{
    Point sum(0);
    int points = 0;
    const auto ring = mark.path.subpaths().front();
    for (const PathSegment& segment : ring.segments) {
        sum += segment.to;
        ++points;
    }
    return sum / double(points);
}

} // namespace

class SheetsTest : public QObject {
    Q_OBJECT

private slots:
    void allSheetsTogetherAreTheDrawing()
    {
        const Sheets all = sheets({.columns = 3, .rows = 2, .margin = 0});
        double length = 0;
        for (std::size_t i = 0; i < all.count(); ++i)
            length += lengthOf(all.sheet(all.tiling.tiles[i]));
        const double whole = lengthOf(all.drawing);
        QVERIFY2(std::abs(length - whole) < 1e-9 * whole, qPrintable(QString::number(length)));
    }

    void aSheetIsAPageWithMargins()
    {
        const Sheets all = sheets({.sheet = {210, 297}, .margin = 10, .overlap = 4});
        const Document second = all.sheet(all.tiling.tiles[1]);
        QCOMPARE(second.page().width, (Length{210, Unit::Mm}));
        QCOMPARE(second.page().height, (Length{297, Unit::Mm}));
        QCOMPARE(second.page().min, Point(186 - 10, -10));
        QCOMPARE(second.page().millimetresPerUnit(), 1.0);
        QCOMPARE(second.objects().size(), 1u);
    }

    // Two sheets laid over each other: the same marks at the same points.
    void neighboursHaveTheSameRegistrationMarks()
    {
        const TilePlan plan{.columns = 2, .rows = 1, .margin = 10, .overlap = 6, .marks = allMarks};
        const Sheets all = sheets(plan);
        std::vector<Point> crosses[2];
        for (const std::size_t i : {0, 1})
            for (const Object& mark : marksOf(all.tiling, all.tiling.tiles[i], plan, "plan"))
                if (mark.path.subpathCount() == 3 && !mark.path.straight())
                    crosses[i].push_back(centreOfRing(mark));
        QCOMPARE(crosses[0].size(), 2u);
        QCOMPARE(crosses[0], crosses[1]);
        QCOMPARE(crosses[0][0], Point(200, -5)); // the middle of the strip in common
        QCOMPARE(crosses[0][1], Point(200, 205));
    }

    void marksStayInTheMargins()
    {
        const TilePlan plan{.sheet = {150, 120}, .margin = 8, .overlap = 5, .marks = allMarks};
        const Sheets all = sheets(plan);
        for (std::size_t i = 0; i < all.count(); ++i) {
            const Document sheet = all.sheet(all.tiling.tiles[i]);
            const auto& [min, max] = all.tiling.tiles[i].window;
            const auto paper = sheet.page().rectangle();
            const auto layer = sheet.containers().childrenOf(0).back();
            const auto range = sheet.containers().rangeOf(layer);
            QVERIFY(range.end > range.first);
            sheet.objects().forEach(range.first, range.size(), [&](auto, const ObjectView& mark) {
                std::vector<clipping::Segment> lines;
                appendSegments(mark.path(), 0.01, lines);
                for (const auto& line : lines)
                    for (const Point& p : {line.a, line.b}) {
                        QVERIFY(p.x > paper.min.x && p.y > paper.min.y && p.x < paper.max.x
                                && p.y < paper.max.y);
                        QVERIFY(!(p.x > min.x && p.x < max.x && p.y > min.y && p.y < max.y));
                    }
            });
        }
    }

    void namesOfFiles()
    {
        const Tiling tiling = sheets({.columns = 3, .rows = 2, .margin = 0}).tiling;
        QCOMPARE(sheetName("a-{row}-{column}-{n}.svg", tiling, tiling.tiles[4]), "a-2-2-5.svg");
        QCOMPARE(gridText(tiling), QStringLiteral("3 columns × 2 rows"));
        QCOMPARE(gridText({{}, 1, 1}), QStringLiteral("1 column × 1 row"));
        QVERIFY(namesEverySheet("{n}", tiling));
        QVERIFY(namesEverySheet("{row}{column}", tiling));
        QVERIFY(!namesEverySheet("{row}", tiling));
        QVERIFY(namesEverySheet("{row}", sheets({.columns = 1, .rows = 2, .margin = 0}).tiling));
    }

    void aFileForEachSheet()
    {
        const QTemporaryDir folder;
        const QString input = folder.filePath("poster.svg");
        QVERIFY(!writeFile(drawing(), input));
        const auto run = clearcut({"clip", input, "--tiles", "3x2", "--overlap", "5mm", "--marks",
                                   "-o", folder.filePath("sheet-{row}-{column}.svg")});
        QVERIFY2(run.code == 0, run.err.constData());
        QVERIFY2(run.err.contains("Sheets: 3 columns × 2 rows"), run.err.constData());
        const QStringList names =
            QDir(folder.path()).entryList({"sheet-*.svg"}, QDir::Files, QDir::Name);
        QCOMPARE(names, (QStringList{"sheet-1-1.svg", "sheet-1-2.svg", "sheet-1-3.svg",
                                     "sheet-2-1.svg", "sheet-2-2.svg", "sheet-2-3.svg"}));
        for (const QString& name : names)
            QVERIFY(readFile(folder.filePath(name)));
    }

    void aPageForEachSheet()
    {
        const QTemporaryDir folder;
        const QString input = folder.filePath("poster.svg"), output = folder.filePath("all.pdf");
        QVERIFY(!writeFile(drawing(), input));
        const auto run = clearcut({"clip", input, "--tiles", "a4-landscape", "--overlap", "5mm",
                                   "--marks", "-o", output});
        QVERIFY2(run.code == 0, run.err.constData());
        const auto info = runProgram("pdfinfo", {output});
        QCOMPARE(info.code, 0);
        QVERIFY2(info.out.contains("Pages:           4"), info.out.constData());
        QVERIFY2(info.out.contains("841.89 x 595.276 pts"), info.out.constData());
    }

    // A window that reaches beyond the page: what is drawn there has sheets of its own.
    void whatLiesBeyondThePageIsWritten()
    {
        const QTemporaryDir folder;
        const QString input = folder.filePath("plan.svg");
        writeText(input, "<svg xmlns='http://www.w3.org/2000/svg' width='90mm' height='96mm' "
                         "viewBox='0 0 90 96'><path d='M-30 10H80' stroke='#000'/></svg>");
        const auto files = [&](const QString& window) {
            const QTemporaryDir out;
            const auto run = clearcut({"clip", input, "-w", window, "--tiles", "45mmx48mm", "-o",
                                       out.filePath("{row}-{column}.svg")});
            return QDir(out.path()).entryList(QDir::Files, QDir::Name).join(u' ')
                   + (run.err.contains("Beyond the page: 1 column on the left.") ? " beyond" : "");
        };
        QCOMPARE(files("0,0,90,96"), "1-1.svg 1-2.svg");
        QCOMPARE(files("-100,0,90,96"), "1-1.svg 1-2.svg 1-3.svg beyond");
        writeText(input, "<svg xmlns='http://www.w3.org/2000/svg' width='90mm' height='96mm' "
                         "viewBox='0 0 90 96'><path d='M-30000 10H80' stroke='#000'/></svg>");
        const auto run = clearcut({"clip", input, "-w", "-40000,0,90,96", "--tiles", "45mmx48mm",
                                   "-o", folder.filePath("{n}.svg")});
        QVERIFY(run.code != 0);
        QVERIFY2(run.err.contains("What lies beyond the page needs more than 1000 sheets."),
                 run.err.constData());
    }

    // Sheets of a size that no paper has; they have no margin unless it is asked for.
    void sheetsOfAnySize()
    {
        const QTemporaryDir folder;
        const QString input = folder.filePath("plan.svg");
        writeText(input,
                  "<svg xmlns='http://www.w3.org/2000/svg' width='90mm' height='96mm' "
                  "viewBox='0 0 90 96'><path d='M0 0L90 96M90 0L0 96' stroke='#000'/></svg>");
        const auto sheets = [&](const QString& tiles, const QStringList& more = {}) {
            const auto run = clearcut(
                QStringList{"clip", input, "--tiles", tiles, "-o", folder.filePath("{n}.svg")}
                + more);
            return run.code == 0 ? run.err.left(run.err.indexOf(": " + folder.path().toUtf8()))
                                 : run.err;
        };
        const QByteArray four = "Sheets: 2 columns × 2 rows of 45.0 × 48.0 mm";
        for (const char* size : {"45mmx48mm", "45x48mm", "4.5cmx4.8cm", "45mm×4.8cm"})
            QCOMPARE(sheets(size), four);
        QVERIFY(contentOf(folder.filePath("4.svg"))
                    .contains("width=\"45mm\" height=\"48mm\" viewBox=\"45 48 45 48\""));
        QCOMPARE(sheets("120pxx1in"), "Sheets: 3 columns × 4 rows of 31.8 × 25.4 mm");
        QCOMPARE(sheets("65mmx68mm", {"--sheet-margin", "10mm"}),
                 "Sheets: 2 columns × 2 rows of 65.0 × 68.0 mm");
        QCOMPARE(sheets("65mmx68mm", {"--marks"}), "Sheets: 2 columns × 2 rows of 65.0 × 68.0 mm");
        for (const char* wrong :
             {"45mmx48", "0mmx48mm", "-1mmx48mm", "45%x48%", "x48mm", "4.5x4.8"})
            QVERIFY(sheets(wrong).contains("a size such as 45mmx48mm"));
    }

    void whatIsWrongIsSaid_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("sentence");
        const auto row = [](const QStringList& options, const char* sentence) {
            QTest::newRow(sentence) << options << QByteArray(sentence);
        };
        row({"--tiles", "3by2", "-o", "x.pdf"}, "--tiles 3by2: give columns and rows such as 3x2");
        row({"--tiles", "0x2", "-o", "x.pdf"}, "give columns and rows");
        row({"--tiles", "3x2", "-o", "x.svg"}, "is one name for 6 sheets. Put {row} and {column}");
        row({"--tiles", "3x2", "-o", "-", "--to", "pdf"}, "--tiles writes files");
        row({"--overlap", "3mm", "-o", "x.svg"}, "--overlap needs --tiles.");
        row({"--tiles", "a4", "--overlap", "30cm", "-o", "x.pdf"}, "Overlap must be less than");
        row({"--tiles", "100x11", "-o", "x.pdf"}, "needs more than 1000 sheets");
    }
    void whatIsWrongIsSaid()
    {
        QFETCH(QStringList, options);
        QFETCH(QByteArray, sentence);
        const QTemporaryDir folder;
        const QString input = folder.filePath("poster.svg");
        QVERIFY(!writeFile(drawing(), input));
        options.replaceInStrings("x.", folder.filePath("x."));
        const auto run = clearcut(QStringList{"clip", input} + options);
        QVERIFY(run.code == 1 || run.code == 2);
        QVERIFY2(run.err.contains(sentence), run.err.constData());
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    }
};

} // namespace tiles_sheets_test

TEST_CLASS(tiles_sheets_test::SheetsTest, Core)
#include "tests/app/tiles/sheets_test.moc"
