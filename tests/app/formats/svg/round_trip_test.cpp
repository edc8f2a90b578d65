// SPDX-License-Identifier: GPL-3.0-or-later
// What is written reads back as the same drawing, bit for bit.
#include <QDir>
#include <QTest>

#include "tests/app/document/random_sheets.h"
#include "tests/app/formats/svg/text.h"
#include "tests/not_empty.h"

class RoundTripTest : public QObject {
    Q_OBJECT

private slots:
    void dataFiles_data()
    {
        QTest::addColumn<QString>("path");
        for (const char* place : {"/tests/app/formats/data", "/resources/samples"}) {
            const QDir folder(SOURCE_DIR + QString(place));
            for (const QString& name : notEmpty(folder.entryList({"*.svg"})))
                QTest::newRow(qPrintable(name)) << folder.filePath(name);
        }
    }
    void dataFiles()
    {
        QFETCH(QString, path);
        const auto first = readText(contentOf(path));
        QVERIFY2(first, qPrintable(first.error));
        const QByteArray text = textOf(first.value->document);
        const auto second = readText(text);
        QVERIFY2(second, qPrintable(second.error));
        QVERIFY(second.value->document == first.value->document);
        QVERIFY(second.value->report.empty());
        QCOMPARE(textOf(second.value->document), text);
    }

    void randomSheets()
    {
        RandomSheets sheets(1);
        for (int i = 0; i < 2000; ++i) {
            const app::Sheet sheet = sheets.sheet();
            const QByteArray text = textOf(sheet);
            const auto again = readText(text);
            QVERIFY2(again, qPrintable(again.error));
            QCOMPARE(textOf(again.value->document), text);
            QVERIFY2(canonical(sheet) == app::sheetOf(again.value->document), text);
        }
    }

private:
    // A line without length is read as a point, and what has no area has no fill.
    static app::Sheet canonical(app::Sheet sheet)
    {
        for (app::Shape& shape : sheet.shapes) {
            bool area = false;
            for (app::Subpath& path : shape.paths) {
                const std::size_t size = path.segments.size();
                area = area || size > 1 || (size == 1 && path.segments[0].curved);
                if (!path.closed && size == 1 && path.segments[0] == app::PathSegment{path.start})
                    path.segments.clear();
            }
            if (!area)
                shape.style.fill.reset();
        }
        return sheet;
    }
};

QTEST_APPLESS_MAIN(RoundTripTest)
#include "round_trip_test.moc"
