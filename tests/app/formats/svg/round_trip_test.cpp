// SPDX-License-Identifier: GPL-3.0-or-later
// What is written reads back as the same drawing, bit for bit.
#include <QDir>
#include <QTest>

#include "tests/app/document/random_documents.h"
#include "tests/app/formats/svg/canonical.h"
#include "tests/app/formats/svg/text.h"
#include "tests/not_empty.h"
#include "tests/test_class.h"

namespace formats_svg_round_trip_test {

class RoundTripTest : public QObject {
    Q_OBJECT

private slots:
    void dataFiles_data()
    {
        QTest::addColumn<QString>("path");
        for (const char* place :
             {"/tests/app/formats/data", "/tests/app/formats/data/css", "/resources/samples"}) {
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

    void randomDocuments()
    {
        RandomDocuments documents(1);
        std::size_t groups = 0;
        for (std::size_t i = 0; i < 2000; ++i) {
            const app::Document document = Canonical(documents.document(i % 40)).document();
            const QByteArray text = textOf(document);
            groups += std::size_t(text.count("clearcut:group"));
            const auto again = readText(text);
            QVERIFY2(again, qPrintable(again.error));
            QVERIFY2(again.value->report.empty(), text);
            QCOMPARE(textOf(again.value->document), text);
            QVERIFY2(again.value->document == document, text);
        }
        QVERIFY(groups > 100);
    }
};

} // namespace formats_svg_round_trip_test

TEST_CLASS(formats_svg_round_trip_test::RoundTripTest, None)
#include "tests/app/formats/svg/round_trip_test.moc"
