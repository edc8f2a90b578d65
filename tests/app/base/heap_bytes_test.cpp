// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/memory.h"

#include <QTest>

#include "tests/test_class.h"

namespace base_heap_bytes_test {

class HeapBytesTest : public QObject {
    Q_OBJECT

private slots:
    void ofAnAllocation()
    {
        QCOMPARE(app::heapBlock(0), std::size_t(0));
        QCOMPARE(app::heapBlock(1), std::size_t(32));
        QCOMPARE(app::heapBlock(56), std::size_t(64));
        QCOMPARE(app::heapBlock(57), std::size_t(80));
    }
    void ofTexts()
    {
        QCOMPARE(app::heapBytes(QString()), std::size_t(0));
        QCOMPARE(app::heapBytes(QStringLiteral("of the program")), std::size_t(0));
        QVERIFY(app::heapBytes(QString(100, u'x')) >= 200);
        QVERIFY(app::heapBytes(QString(100, u'x')) < 300);
    }
    void ofLists()
    {
        QCOMPARE(app::heapBytes(std::vector<double>()), std::size_t(0));
        QCOMPARE(app::heapBytes(std::vector<double>(100)), app::heapBlock(800));
    }
};

} // namespace base_heap_bytes_test

TEST_CLASS(base_heap_bytes_test::HeapBytesTest, None)
#include "tests/app/base/heap_bytes_test.moc"
