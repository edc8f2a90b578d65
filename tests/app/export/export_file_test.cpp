// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/variant.h"
#include "app/export/export_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include "tests/app/document/sheet.h"
#include "tests/content_of.h"
#include "tests/test_class.h"

namespace export_export_file_test {

using namespace app;

namespace {

/// A filled square in the middle of the window, with a line out of it.
ExportJob job(const char* format, std::optional<Colour> background = {})
{
    Sheet sheet;
    sheet.window = {{0, 0}, {20, 20}};
    sheet.shapes = {
        {{{{5, 5}, {{{15, 5}}, {{15, 15}}, {{5, 15}}}, true}}, {.fill = Colour{200, 0, 0}}, {}, 0},
        {{{{10, 10}, {{{90, 10}}}, false}}, {.stroke = Colour{}, .width = 1}, {}, 0}};
    return {{documentOf(sheet), {}, usualAlgorithm().corrected.clipAll, {}},
            {.format = format, .dpi = 254, .background = background}};
}

void write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

} // namespace

class ExportFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void theDryRunHasAsManyBytesAsTheFile()
    {
        for (const Format* format : exportFormats()) {
            const QString path = folder_.filePath(QStringLiteral("a.") + format->key.data());
            const ExportJob made = job(format->key.data());
            const ExportResult end = exportFile(made, path);
            QVERIFY2(end.end == WriteResult::End::Written, qPrintable(end.error));
            QVERIFY(end.cut);
            const auto bytes = exportedBytes(*exportDrawing(made).value, *format);
            QVERIFY2(bytes, qPrintable(bytes.error));
            QCOMPARE(*bytes.value, QFileInfo(path).size());
        }
    }
    void aPictureIsWhiteOrTransparentOrColoured_data()
    {
        QTest::addColumn<std::optional<Colour>>("background");
        QTest::addColumn<QColor>("seen");
        using Ground = std::optional<Colour>;
        QTest::newRow("usual") << Ground() << QColor(Qt::white);
        QTest::newRow("transparent") << Ground(Colour{255, 255, 255, 0}) << QColor(0, 0, 0, 0);
        QTest::newRow("coloured") << Ground(Colour{1, 2, 3}) << QColor(1, 2, 3);
    }
    void aPictureIsWhiteOrTransparentOrColoured()
    {
        QFETCH(std::optional<Colour>, background);
        QFETCH(QColor, seen);
        const QString path = folder_.filePath("a.png");
        QVERIFY(exportFile(job("png", background), path).end == WriteResult::End::Written);
        const QImage image(path);
        QCOMPARE(image.size(), QSize(200, 200)); // 20 mm at 10 pixels a millimetre
        QCOMPARE(image.pixelColor(2, 2), seen);
        QCOMPARE(image.pixelColor(100, 60), QColor(200, 0, 0));
        QCOMPARE(image.pixelColor(199, 100), QColor(Qt::black)); // the line, up to the edge
    }
    void impossibleResolutionsAreRefusedInASentence()
    {
        for (const double dpi : {0.0, -1.0, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
            ExportJob bad = job("png");
            bad.choice.dpi = dpi;
            const QString path = folder_.filePath("bad.png");
            write(path, "old");
            const ExportResult end = exportFile(bad, path);
            QVERIFY(end.end == WriteResult::End::Failed);
            QVERIFY2(end.error.endsWith(u'.') && end.error.contains("dpi"), qPrintable(end.error));
            QCOMPARE(contentOf(path), QByteArray("old"));
            QVERIFY(!exportedBytes(*exportDrawing(bad).value, formatOf(bad.choice)));
        }
    }
    void aStoppedOrFailedExportLeavesTheDiskAsItWas()
    {
        const QString path = folder_.filePath("old.svg");
        write(path, "old");
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(exportFile(job("svg"), path, {stop.get_token()}).end == WriteResult::End::Stopped);
        QCOMPARE(contentOf(path), QByteArray("old"));
        const ExportResult failed = exportFile(job("svg"), folder_.filePath("no folder/a.svg"));
        QVERIFY(failed.end == WriteResult::End::Failed);
        QVERIFY2(failed.error.contains("no folder/a.svg") && failed.error.endsWith(u'.'),
                 qPrintable(failed.error));
        QVERIFY(!QFileInfo::exists(folder_.filePath("no folder")));
    }
    // Hidden objects are in an SVG file, hidden; a table has no place for them.
    void hiddenObjectsAreLeftOutWhereTheyCannotBeStored()
    {
        Sheet sheet;
        sheet.layers = {{QStringLiteral("Seen")}, {QStringLiteral("Hidden"), false}};
        sheet.shapes = {{{{{-10, 5}, {{{30, 5}}}, false}}, {.stroke = Colour{}}, {}, 0},
                        {{{{1, 1}, {{{2, 2}}}, false}}, {.stroke = Colour{}}, {}, 1}};
        for (const auto& [format, objects] : {std::pair("svg", 2), std::pair("csv", 1)}) {
            ExportJob made = job(format);
            made.source.document = documentOf(sheet);
            const QString path = folder_.filePath(QStringLiteral("hidden.") + format);
            QVERIFY(exportFile(made, path).end == WriteResult::End::Written);
            QCOMPARE(int(readFile(path).value->document.objects().size()), objects);
        }
    }
};

} // namespace export_export_file_test

TEST_CLASS(export_export_file_test::ExportFileTest, Core)
#include "tests/app/export/export_file_test.moc"
