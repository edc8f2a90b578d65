// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/read_strings.h"

#include "tests/test_class.h"

namespace base_read_strings_test {

// Strings in data that may be damaged.
class ReadStringsTest : public QObject {
    Q_OBJECT

    static QByteArray dataOf(const QStringList& strings)
    {
        QByteArray data;
        QDataStream stream(&data, QIODevice::WriteOnly);
        stream << strings;
        return data;
    }

private slots:
    void whatWasWrittenIsRead()
    {
        for (const QStringList& strings : {QStringList(), QStringList{"a", "", "ä🙂"}}) {
            const QByteArray data = dataOf(strings);
            QDataStream stream(data);
            QCOMPARE(app::readStrings(stream, 3), strings);
            QCOMPARE(stream.status(), QDataStream::Ok);
        }
    }
    void everyEndAndEveryLengthIsHarmless()
    {
        const QByteArray whole = dataOf({"one", "two"});
        for (qsizetype end = 0; end < whole.size(); ++end) {
            const QByteArray data = whole.left(end);
            QDataStream stream(data);
            QVERIFY(app::readStrings(stream, 10).empty());
            QVERIFY(stream.status() != QDataStream::Ok);
        }
        for (const quint32 claimed : {3U, 11U, 0x7fffffffU, 0xffffffffU}) {
            QByteArray data;
            QDataStream out(&data, QIODevice::WriteOnly);
            out << claimed << QString("one");
            QDataStream stream(data);
            QVERIFY(app::readStrings(stream, 10).empty());
            QCOMPARE(stream.status(),
                     claimed > 10 ? QDataStream::ReadCorruptData : QDataStream::ReadPastEnd);
        }
    }
};

} // namespace base_read_strings_test

TEST_CLASS(base_read_strings_test::ReadStringsTest, Core)
#include "tests/app/base/read_strings_test.moc"
