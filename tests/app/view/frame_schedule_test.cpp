// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/frame_schedule.h"

#include <QTest>

#include <random>

#include "tests/test_class.h"
#include "tests/verify.h"

namespace view_frame_schedule_test {

using app::FrameKey;
using app::FrameSchedule;
using Step = FrameSchedule::Step;

namespace {

FrameKey frame(std::uint64_t look, std::uint64_t lines = 1)
{
    return {.lines = lines, .look = look};
}

/// Paints the frames of a schedule. Each takes the same number of ticks; an event comes at most
/// once a tick.
class Painter {
public:
    static constexpr int rest = 20; ///< ticks

    explicit Painter(int duration) : duration_(duration) {}

    void want(const FrameKey& key)
    {
        if (key != wanted_)
            quiet_ = 0;
        wanted_ = key;
        follow(schedule.want(key));
    }
    void tick()
    {
        if (left_ > 0 && --left_ == 0) {
            finished.push_back(*schedule.painting());
            const bool rough = finished.size() % 3 == 0 && !schedule.paintsFinely();
            follow(schedule.finished(rough));
            if (schedule.isRough())
                quiet_ = 0;
        }
        if (++quiet_ == rest)
            follow(schedule.rested());
    }

    FrameSchedule schedule;
    std::vector<FrameKey> finished;
    int begun = 0;

private:
    void follow(Step step)
    {
        QVERIFY(step != Step::Start || left_ == 0);
        QVERIFY((step != Step::Replace && step != Step::Cancel) || left_ > 0);
        if (step == Step::Cancel)
            left_ = 0;
        if (step == Step::Start || step == Step::Replace) {
            QVERIFY(schedule.painting() == wanted_);
            left_ = duration_;
            ++begun;
        }
    }

    int duration_, left_ = 0, quiet_ = 0;
    FrameKey wanted_;
};

} // namespace

class FrameScheduleTest : public QObject {
    Q_OBJECT

private slots:
    void aFrameIsPaintedOnce()
    {
        FrameSchedule schedule;
        QVERIFY(schedule.want(frame(1)) == Step::Start);
        QVERIFY(!schedule.isCurrent());
        QVERIFY(schedule.want(frame(1)) == Step::Nothing);
        QVERIFY(schedule.finished(false) == Step::Nothing);
        QVERIFY(schedule.isCurrent());
        QVERIFY(schedule.want(frame(1)) == Step::Nothing);
    }
    void theNewestWaits()
    {
        FrameSchedule schedule;
        schedule.want(frame(1));
        QVERIFY(schedule.want(frame(2)) == Step::Nothing);
        QVERIFY(schedule.want(frame(3)) == Step::Nothing);
        QVERIFY(schedule.isLate());
        QVERIFY(schedule.finished(false) == Step::Start);
        QVERIFY(schedule.shown() == frame(1));
        QVERIFY(schedule.painting() == frame(3));
    }
    // Changes of the drawing that come all the time would otherwise starve the picture.
    void anotherDrawingCancelsButNotTwice()
    {
        FrameSchedule schedule;
        schedule.want(frame(1, 1));
        QVERIFY(schedule.want(frame(1, 2)) == Step::Replace);
        QVERIFY(schedule.want(frame(1, 3)) == Step::Nothing);
        QVERIFY(schedule.painting() == frame(1, 2));
        QVERIFY(schedule.finished(false) == Step::Start);
        QVERIFY(schedule.want(frame(1, 4)) == Step::Replace);
    }
    void anotherSizeCancels()
    {
        FrameSchedule schedule;
        FrameKey larger = frame(1);
        larger.pixels = {300, 200};
        schedule.want(frame(1));
        QVERIFY(schedule.want(larger) == Step::Replace);
    }
    void atRestWhatIsOutOfDateIsCancelled()
    {
        FrameSchedule schedule;
        schedule.want(frame(1));
        QVERIFY(schedule.rested() == Step::Nothing);
        schedule.want(frame(2));
        QVERIFY(schedule.rested() == Step::Replace);
        QVERIFY(schedule.painting() == frame(2));
    }
    void backToTheShownFrameNothingIsPainted()
    {
        FrameSchedule schedule;
        schedule.want(frame(1));
        schedule.finished(false);
        schedule.want(frame(2));
        QVERIFY(schedule.want(frame(1)) == Step::Cancel);
        QVERIFY(schedule.isCurrent() && !schedule.painting());
    }
    void aRoughFrameIsPaintedFinelyAtRest()
    {
        FrameSchedule schedule;
        schedule.want(frame(1));
        QVERIFY(!schedule.paintsFinely());
        QVERIFY(schedule.finished(true) == Step::Nothing);
        QVERIFY(schedule.isCurrent() && schedule.isRough());
        QVERIFY(schedule.want(frame(1)) == Step::Nothing);
        QVERIFY(schedule.rested() == Step::Start);
        QVERIFY(schedule.painting() == frame(1) && schedule.paintsFinely());
        QVERIFY(schedule.want(frame(1)) == Step::Nothing); // it goes on
        QVERIFY(schedule.rested() == Step::Nothing);
        QVERIFY(schedule.finished(false) == Step::Nothing);
        QVERIFY(schedule.isCurrent() && !schedule.isRough() && !schedule.paintsFinely());
        QVERIFY(schedule.rested() == Step::Nothing);
    }
    void finePaintingWaitsForNoOtherFrame()
    {
        FrameSchedule schedule;
        schedule.want(frame(1));
        schedule.finished(true);
        schedule.rested();
        QVERIFY(schedule.want(frame(2)) == Step::Replace);
        QVERIFY(!schedule.paintsFinely());
        QVERIFY(schedule.want(frame(3)) == Step::Nothing); // this one may be finished first
        QVERIFY(schedule.want(frame(1)) == Step::Cancel);  // back to the rough one
        QVERIFY(schedule.isRough());
        QVERIFY(schedule.rested() == Step::Start);
    }
    void whatWasForgottenIsPaintedAgain()
    {
        FrameSchedule schedule;
        schedule.want(frame(1));
        schedule.finished(false);
        schedule.forget();
        QVERIFY(schedule.want(frame(1)) == Step::Start);
    }
    void eventsFasterThanFramesStarveNoPicture_data()
    {
        QTest::addColumn<int>("duration");
        QTest::addColumn<int>("drawings"); // one of so many is another drawing
        for (const int duration : {2, 7, 60})
            for (const int drawings : {1, 5, 1'000'000})
                QTest::addRow("%d ticks, 1 of %d", duration, drawings) << duration << drawings;
    }
    void eventsFasterThanFramesStarveNoPicture()
    {
        QFETCH(const int, duration);
        QFETCH(const int, drawings);
        Painter painter(duration);
        std::mt19937 random(5);
        std::uint64_t lines = 1;
        constexpr int ticks = 3000;
        for (int i = 0; i < ticks; ++i) {
            lines += random() % unsigned(drawings) == 0;
            painter.want(frame(std::uint64_t(i), lines));
            painter.tick();
        }
        QVERIFY2(int(painter.finished.size()) >= ticks / (2 * duration) - 1,
                 qPrintable(QString::number(painter.finished.size())));
    }
    void inTheEndTheWantedFrameIsShown()
    {
        std::mt19937 random(8);
        for (int round = 0; round < 300; ++round) {
            const int duration = 1 + int(random() % 60);
            Painter painter(duration);
            for (int i = 0; i < 200; ++i) {
                if (random() % 3 != 0)
                    painter.want(frame(random() % 6, random() % 2));
                painter.tick();
            }
            const FrameKey last = frame(9, 9);
            painter.want(last);
            for (int i = 0; i < 2 * (Painter::rest + duration); ++i)
                painter.tick();
            VERIFY_OR_SAY(painter.schedule.isCurrent() && !painter.schedule.painting()
                              && painter.schedule.shown() == last && !painter.schedule.isRough(),
                          qPrintable(QString::number(round)));
            VERIFY_OR_SAY(painter.begun >= int(painter.finished.size()),
                          qPrintable(QString::number(round)));
        }
    }
};

} // namespace view_frame_schedule_test

TEST_CLASS(view_frame_schedule_test::FrameScheduleTest, None)
#include "tests/app/view/frame_schedule_test.moc"
