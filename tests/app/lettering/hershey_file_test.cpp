// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/hershey_file.h"

#include <QDirIterator>
#include <QTest>

#include "tests/test_class.h"

namespace lettering_hershey_file_test {

using namespace app;

class HersheyFileTest : public QObject {
    Q_OBJECT

private slots:
    void readsAGlyph()
    {
        const auto read = readHershey("12345  6JZNFNM RVFVM\n12345  1JZ\n");
        QVERIFY(read && read.value->size() == 2);
        const HersheyGlyph& glyph = read.value->front();
        QCOMPARE(glyph.left, -8.0);
        QCOMPARE(glyph.right, 8.0);
        const std::vector<std::vector<Point>> strokes{{{-4, -21}, {-4, -14}}, {{4, -21}, {4, -14}}};
        QVERIFY(glyph.strokes == strokes);
        QVERIFY(read.value->back().strokes.empty());
    }
    void readsABrokenRow()
    {
        const auto whole = readHershey("12345  6JZNFNM RVFVM\n");
        const auto broken = readHershey("12345  6JZNF\nNM RV\r\nFVM\n");
        QVERIFY(whole && broken && broken.value->size() == 1);
        QVERIFY(broken.value->front().strokes == whole.value->front().strokes);
    }
    void everyFontOfThePackageIsRead()
    {
        int fonts = 0;
        for (QDirIterator it(":/hershey", {"*.jhf"}); it.hasNext(); ++fonts) {
            QFile file(it.next());
            QVERIFY(file.open(QIODevice::ReadOnly));
            const auto read = readHershey(file.readAll());
            QVERIFY2(read && read.value->size() >= 96, qPrintable(file.fileName()));
            for (const HersheyGlyph& glyph : *read.value) {
                QVERIFY(glyph.left <= glyph.right);
                for (const auto& stroke : glyph.strokes)
                    QVERIFY(!stroke.empty());
            }
        }
        QVERIFY2(fonts > 25, "install the package hershey-fonts-data and configure again");
    }
    void garbageIsRefused_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("word") << QByteArray("garbage");
        QTest::newRow("no count") << QByteArray("12345 abJZ");
        QTest::newRow("negative") << QByteArray("12345 -1JZ");
        QTest::newRow("zero") << QByteArray("12345  0");
        QTest::newRow("too short") << QByteArray("12345  6JZNF");
        QTest::newRow("a good one before") << QByteArray("12345  1JZ\n12345999JZ");
        QTest::newRow("too many") << QByteArray("12345  1JZ").repeated(20'000);
    }
    void garbageIsRefused()
    {
        QFETCH(QByteArray, bytes);
        const auto read = readHershey(bytes);
        QVERIFY(!read && !read.error.isEmpty());
    }
    void anyBytesAreHandled()
    {
        const QByteArray good = QByteArray("12345  6JZNFNM RVFVM\n").repeated(20);
        for (int i = 0; i < good.size(); ++i)
            for (const char c : {'\0', '\xff', ' ', '9', 'R', '\n'}) {
                QByteArray bytes = good;
                bytes[i] = c;
                (void)readHershey(bytes);
                (void)readHershey(bytes.left(i));
            }
    }
};

} // namespace lettering_hershey_file_test

TEST_CLASS(lettering_hershey_file_test::HersheyFileTest, Core)
#include "tests/app/lettering/hershey_file_test.moc"
