// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/variant.h"
#include "app/document/document_builder.h"
#include "app/tiles/sheet_export.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "tests/test_class.h"

namespace tiles_sheet_export_test {

using namespace app;

namespace {

const Page page{{0, 0}, {400, 200}, {400, Unit::Mm}, {200, Unit::Mm}, {}};

/// A wave across the page, and a hidden line.
Document drawing()
{
    DocumentBuilder builder;
    builder.open({.name = "Drawing"});
    const Subpath wave{{0, 100}, {{{400, 100}, {100, 0}, {300, 200}, true}}, false};
    const Subpath hidden{{0, 50}, {{{400, 50}}}, false};
    const Style style{.stroke = Colour{}, .width = 0.5};
    builder.add(Object{.path = Path({&wave, 1}), .style = style});
    builder.add(Object{.path = Path({&hidden, 1}), .style = style, .hidden = true});
    builder.close();
    return builder.take(page);
}

Sheets sheets(const TilePlan& plan)
{
    return {drawing(),
            plan,
            *tilingOf(page, plan).value,
            {.clipAll = usualAlgorithm().corrected.clipAll},
            QStringLiteral("wave")};
}

} // namespace

class SheetExportTest : public QObject {
    Q_OBJECT

private slots:
    void progressIsToldAfterEachSheet()
    {
        const QTemporaryDir folder;
        std::vector<double> shares;
        const Follower follower{
            {}, [&](const Progress& progress) { shares.push_back(progress.share); }};
        const auto written =
            exportSheets(sheets({.columns = 4, .margin = 0}), folder.filePath("{n}.svg"), follower);
        QVERIFY(written.end == WriteResult::End::Written);
        QCOMPARE(shares, (std::vector<double>{0.25, 0.5, 0.75, 1}));
    }

    // The sheets before are complete, the one that was being written is not there.
    void aStopEndsBetweenSheets()
    {
        const QTemporaryDir folder;
        std::stop_source stop;
        const Follower follower{stop.get_token(), [&](const Progress& progress) {
                                    if (progress.share >= 0.5)
                                        stop.request_stop();
                                }};
        const auto written =
            exportSheets(sheets({.columns = 4, .margin = 0}), folder.filePath("{n}.svg"), follower);
        QVERIFY(written.end == WriteResult::End::Stopped);
        QCOMPARE(written.error, "The export was cancelled after 2 of 4 sheets.");
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), (QStringList{"1.svg", "2.svg"}));
    }

    void aStoppedPdfIsAsItWas()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("all.pdf");
        QFile before(path);
        QVERIFY(before.open(QIODevice::WriteOnly) && before.write("before") == 6);
        before.close();
        std::stop_source stop;
        const Follower follower{stop.get_token(), [&](const Progress&) { stop.request_stop(); }};
        const auto written = exportSheets(sheets({.columns = 4, .margin = 0}), path, follower);
        QVERIFY(written.end == WriteResult::End::Stopped);
        QVERIFY2(written.error.contains("is as it was before"), qPrintable(written.error));
        QCOMPARE(QFileInfo(path).size(), 6);
    }

    void linesOfATableStayOnTheirSheets()
    {
        const QTemporaryDir folder;
        const auto written =
            exportSheets(sheets({.columns = 2, .margin = 0}), folder.filePath("{n}.csv"), {});
        QVERIFY(written.end == WriteResult::End::Written);
        const auto second = readFile(folder.filePath("2.csv"));
        QVERIFY(second);
        const Document& rows = second.value->document;
        QVERIFY(rows.objects().size() > 4); // the wave in pieces, without the hidden line
        rows.objects().forEach(0, rows.objects().size(), [](auto, const ObjectView& row) {
            for (const Subpath& line : row.path().subpaths())
                QVERIFY(line.start.x >= 200 && line.segments.front().to.x >= 200);
        });
    }

    void sheetsThatAreLeftOutAreNotWritten()
    {
        const QTemporaryDir folder;
        const Sheets some = sheets({.columns = 4, .margin = 0, .leftOut = {2, 3}});
        QCOMPARE(some.count(), 2u);
        QVERIFY(exportSheets(some, folder.filePath("{n}.svg"), {}).end
                == WriteResult::End::Written);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), (QStringList{"1.svg", "4.svg"}));
    }

    void whatCannotBeWrittenIsSaid()
    {
        const auto written =
            exportSheets(sheets({.columns = 2, .margin = 0}), "/nowhere/{n}.svg", {});
        QVERIFY(written.end == WriteResult::End::Failed);
        QVERIFY2(written.error.contains("/nowhere/1.svg"), qPrintable(written.error));
    }
};

} // namespace tiles_sheet_export_test

TEST_CLASS(tiles_sheet_export_test::SheetExportTest, Core)
#include "tests/app/tiles/sheet_export_test.moc"
