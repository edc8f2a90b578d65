// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/format.h"

#include <QBuffer>
#include <QDir>
#include <QTest>

namespace {

app::Result<app::Imported> read(QByteArray text)
{
    QBuffer buffer(&text);
    buffer.open(QIODevice::ReadOnly);
    return app::findFormat(u"svg")->read(buffer);
}

QByteArray written(const app::Sheet& sheet, const app::WriteOptions& options = {})
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    const auto error = app::findFormat(u"svg")->write(sheet, buffer, options);
    return error ? QByteArray() : buffer.data();
}

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class RoundTripTest : public QObject {
    Q_OBJECT

private slots:
    void dataFilesComeBackBitForBit_data()
    {
        QTest::addColumn<QString>("path");
        const QDir folder(SOURCE_DIR "/tests/app/formats/data");
        for (const QString& name : folder.entryList({"*.svg"}))
            QTest::newRow(qPrintable(name)) << folder.filePath(name);
    }
    void dataFilesComeBackBitForBit()
    {
        QFETCH(QString, path);
        const auto first = read(contentOf(path));
        QVERIFY2(first, qPrintable(first.error));
        const QByteArray text = written(first.value->sheet);
        const auto second = read(text);
        QVERIFY2(second, qPrintable(second.error));
        QVERIFY(second.value->sheet == first.value->sheet);
        QVERIFY(!second.value->lossy());
        QCOMPARE(written(second.value->sheet), text);
    }
};

QTEST_GUILESS_MAIN(RoundTripTest)
#include "round_trip_test.moc"
