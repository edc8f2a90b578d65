// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/frame_statistics.h"

#include <QTest>

class FrameStatisticsTest : public QObject {
    Q_OBJECT

private slots:
    void medianOfFew()
    {
        app::FrameStatistics times;
        QCOMPARE(times.median(), 0.0);
        times.add(3);
        QCOMPARE(times.median(), 3.0);
        times.add(1);
        QCOMPARE(times.median(), 2.0);
        times.add(100);
        QCOMPARE(times.median(), 3.0);
    }
    void onlyTheLastSixtyCount()
    {
        app::FrameStatistics times;
        for (int i = 0; i < 1000; ++i)
            times.add(1000);
        for (int i = 1; i <= 60; ++i)
            times.add(i);
        QCOMPARE(times.median(), 30.5);
        times.add(61); // pushes the 1 out
        QCOMPARE(times.median(), 31.5);
    }
    void forgets()
    {
        app::FrameStatistics times;
        times.add(5);
        times.forget();
        QCOMPARE(times.median(), 0.0);
    }
};

QTEST_APPLESS_MAIN(FrameStatisticsTest)
#include "frame_statistics_test.moc"
