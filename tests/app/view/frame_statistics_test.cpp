// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/frame_times.h"

#include <QTest>

#include "tests/test_class.h"

namespace view_frame_statistics_test {

using app::FrameStatistics;

namespace {

/// Notes frames, each of which was clipped once.
class Frames {
public:
    FrameStatistics statistics;
    void note(double milliseconds, std::uint64_t subject = 1)
    {
        statistics.note({.clipMs = milliseconds, .clipping = ++clippings_, .subject = subject});
    }
    void noteAgain(double milliseconds, std::uint64_t subject = 1)
    {
        statistics.note({.clipMs = milliseconds, .clipping = clippings_, .subject = subject});
    }

private:
    std::uint64_t clippings_ = 0;
};

} // namespace

class FrameStatisticsTest : public QObject {
    Q_OBJECT

private slots:
    void medianOfFew()
    {
        Frames frames;
        QCOMPARE(frames.statistics.median(), 0.0);
        frames.note(3);
        QCOMPARE(frames.statistics.median(), 3.0);
        frames.note(1);
        QCOMPARE(frames.statistics.median(), 2.0);
        frames.note(100);
        QCOMPARE(frames.statistics.median(), 3.0);
    }
    void onlyTheLastSixtyCount()
    {
        Frames frames;
        for (int i = 0; i < 1000; ++i)
            frames.note(1000);
        for (int i = 1; i <= 60; ++i)
            frames.note(i);
        QCOMPARE(frames.statistics.median(), 30.5);
        frames.note(61); // pushes the 1 out
        QCOMPARE(frames.statistics.median(), 31.5);
    }
    void anotherSubjectBeginsAnew()
    {
        Frames frames;
        for (int i = 0; i < 60; ++i)
            frames.note(0.01);
        frames.note(2.06, 2);
        QCOMPARE(frames.statistics.median(), 2.06);
        frames.note(7, 1);
        QCOMPARE(frames.statistics.median(), 7.0);
    }
    // The numbers of a frame are reported again when its picture is finished.
    void aClippingCountsOnce()
    {
        Frames frames;
        frames.note(2);
        frames.note(4);
        for (int i = 0; i < 9; ++i)
            frames.noteAgain(4);
        QCOMPARE(frames.statistics.median(), 3.0);
    }
    void forgets()
    {
        Frames frames;
        frames.note(5);
        frames.statistics.forget();
        QCOMPARE(frames.statistics.median(), 0.0);
        frames.noteAgain(6);
        QCOMPARE(frames.statistics.median(), 6.0);
    }
};

} // namespace view_frame_statistics_test

TEST_CLASS(view_frame_statistics_test::FrameStatisticsTest, None)
#include "tests/app/view/frame_statistics_test.moc"
