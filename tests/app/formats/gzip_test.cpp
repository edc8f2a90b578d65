// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/format.h"
#include "app/formats/gzip.h"

#include <QBuffer>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace formats_gzip_test {

namespace {

std::optional<QByteArray> unzippedText(QByteArray data, std::size_t most = 1'000'000)
{
    QBuffer buffer(&data);
    buffer.open(QIODevice::ReadOnly);
    return app::unzipped(buffer, most);
}

} // namespace

class GzipTest : public QObject {
    Q_OBJECT
private slots:
    void thereAndBack()
    {
        for (const QByteArray& text :
             {QByteArray("a"), QByteArray(), QByteArray("line ").repeated(50'000)}) {
            const QByteArray data = app::zipped(text);
            QVERIFY(data.startsWith("\x1f\x8b"));
            QCOMPARE(unzippedText(data), std::optional(text));
            QCOMPARE(app::zipped(text), data);
        }
    }

    void damagedDataAreRefused()
    {
        const QByteArray data = app::zipped(QByteArray("line ").repeated(5'000));
        for (qsizetype size = 0; size < data.size(); ++size)
            QVERIFY(!unzippedText(data.first(size)));
        QByteArray wrong = data;
        wrong[wrong.size() / 2] = char(wrong[wrong.size() / 2] ^ 0x55);
        QVERIFY(!unzippedText(wrong));
        QVERIFY(!unzippedText(data, 24'999));
        QVERIFY(unzippedText(data, 25'000));
    }

    // Another program reads what is written, and writes what is read.
    void filesOfOtherPrograms()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.svgz");
        const auto drawn = readText(drawing("<path d='M1 2L3 4' stroke='red'/>"));
        QVERIFY(drawn);
        QVERIFY(!app::writeFile(drawn.value->document, path));
        QProcess gunzip;
        gunzip.start("gzip", {"-dc", path});
        QVERIFY(gunzip.waitForFinished());
        QCOMPARE(gunzip.readAllStandardOutput(), textOf(drawn.value->document));

        QVERIFY(QFile::remove(path));
        QFile plain(folder.filePath("a.svg"));
        QVERIFY(plain.open(QIODevice::WriteOnly));
        plain.write(drawing("<path d='M1 2L3 4' stroke='red'/>"));
        plain.close();
        QCOMPARE(QProcess::execute("gzip", {"-S", "z", plain.fileName()}), 0);
        const auto read = app::readFile(folder.filePath("a.svgz"));
        QVERIFY2(read, qPrintable(read.error));
        QVERIFY(read.value->document == drawn.value->document);
    }
};

} // namespace formats_gzip_test

TEST_CLASS(formats_gzip_test::GzipTest, None)
#include "tests/app/formats/gzip_test.moc"
