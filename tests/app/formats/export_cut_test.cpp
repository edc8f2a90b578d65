// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/export_cut.h"
#include "app/formats/format.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/app/document/sheet.h"
#include "tests/test_class.h"

namespace formats_export_cut_test {

using namespace app;

class ExportCutTest : public QObject {
    Q_OBJECT

    /// A line across the window, and a hidden one inside it.
    static Document drawing()
    {
        Sheet sheet;
        sheet.layers = {{QStringLiteral("Seen")}, {QStringLiteral("Hidden"), false}};
        sheet.shapes.push_back({{{{-10, 5}, {{{30, 5}}}, false}}, {.stroke = Colour{}}, {}, 0});
        sheet.shapes.push_back({{{{1, 1}, {{{2, 2}}}, false}}, {.stroke = Colour{}}, {}, 1});
        return documentOf(sheet);
    }
    static CutOptions options()
    {
        const auto* exact = clipping::findAlgorithm("exact");
        return {exact->corrected.clipAll,
                {{{{{0, 0}, {10, 10}}, WindowOperation::Add}}, Keep::Inside}};
    }
    QTemporaryDir folder_;

private slots:
    void onlyWhatIsKeptIsWritten()
    {
        const QString path = folder_.filePath("cut.svg");
        const CutExport made = exportCut(drawing(), options(), path, {});
        QVERIFY2(made.end == CutExport::End::Written, qPrintable(made.error));
        QCOMPARE(made.counts.segmentsBefore, std::size_t(2));
        const auto read = readFile(path);
        QVERIFY2(read.value.has_value(), qPrintable(read.error));
        const Document& cut = read.value->document;
        QCOMPARE(cut.objects().size(), std::size_t(2)); // hidden objects are kept in SVG
        QVERIFY(cut.windows().list.empty());
        const Sheet sheet = sheetOf(cut);
        QCOMPARE(sheet.shapes[0].paths[0].start, Point(0, 5));
        QCOMPARE(sheet.shapes[0].paths[0].segments[0].to, Point(10, 5));
    }
    void hiddenObjectsAreLeftOutWhereTheyCannotBeStored()
    {
        const QString path = folder_.filePath("cut.csv");
        QVERIFY(exportCut(drawing(), options(), path, {}).end == CutExport::End::Written);
        QCOMPARE(readFile(path).value->document.objects().size(), std::size_t(1));
    }
    void stoppedOrFailedExportLeavesTheFileAsItWas()
    {
        const QString path = folder_.filePath("old.svg");
        QFile old(path);
        QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
        old.close();
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(exportCut(drawing(), options(), path, {stop.get_token()}).end
                == CutExport::End::Stopped);
        QVERIFY(old.open(QIODevice::ReadOnly));
        QCOMPARE(old.readAll(), QByteArray("old"));
        const CutExport failed =
            exportCut(drawing(), options(), folder_.filePath("no folder/cut.svg"), {});
        QVERIFY(failed.end == CutExport::End::Failed);
        QVERIFY2(failed.error.contains("no folder/cut.svg") && failed.error.endsWith(u'.'),
                 qPrintable(failed.error));
    }
};

} // namespace formats_export_cut_test

TEST_CLASS(formats_export_cut_test::ExportCutTest, Core)
#include "tests/app/formats/export_cut_test.moc"
