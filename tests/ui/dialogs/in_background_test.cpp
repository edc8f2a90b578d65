// SPDX-License-Identifier: GPL-3.0-or-later
#include <QProgressBar>

#include "tests/test_class.h"
#include "tests/ui/dialogs/waiting_desk.h"

namespace dialogs_in_background_test {

class InBackgroundTest : public QObject {
    Q_OBJECT

private slots:
    void quickWorkShowsNothingAndAnEventBringsItsResult()
    {
        Desk desk;
        desk.background.run(
            "Working…", [](const app::Follower&) { return 42; }, desk.store(), Cancel::Drops);
        QVERIFY(desk.results.empty() && desk.background.busy());
        QTRY_VERIFY(!desk.background.busy());
        QCOMPARE(desk.results, Results{42});
        QVERIFY(!shownDialog());
    }
    void slowWorkShowsADialogUntilItEnds()
    {
        Desk desk;
        const Gate gate;
        desk.background.run(
            "Working…",
            [inner = gate.work(42)](const app::Follower& follower) {
                follower.progress({.share = 0.5, .secondsLeft = 1});
                QThread::msleep(700); // until there is a dialog; then it is told once more
                follower.progress({.share = 0.75, .secondsLeft = 1});
                return inner(follower);
            },
            desk.store(), Cancel::Drops);
        QTRY_VERIFY(shownDialog());
        QVERIFY(shownDialog()->isModal());
        const auto* bar = shownDialog()->findChild<QProgressBar*>();
        QTRY_COMPARE(bar->value(), bar->maximum() * 3 / 4);
        gate.open();
        QTRY_COMPARE(desk.results, Results{42});
        QVERIFY(!shownDialog());
    }
    void aDroppedJobHasNoResultAndDoesNotDelayTheNext()
    {
        Desk desk;
        const Gate gate;
        const auto ended = std::make_shared<std::atomic<int>>(0);
        desk.background.run("Working…", gate.deafWork(ended), desk.store(), Cancel::Drops);
        clickCancel();
        QCOMPARE(desk.results, Results{std::nullopt});
        QVERIFY(!shownDialog());
        QTRY_VERIFY(!desk.background.busy());
        QCOMPARE(int(*ended), 0);
        desk.background.run(
            "Working…", [](const app::Follower&) { return 42; }, desk.store(), Cancel::Drops);
        QTRY_COMPARE(desk.results, (Results{std::nullopt, 42}));
        gate.open();
        QTRY_COMPARE(int(*ended), 1); // it has run on
        QTest::qWait(20);
        QCOMPARE(desk.results.size(), std::size_t(2));
    }
    void aStoppedJobHasTheResultOfItsEnd()
    {
        Desk desk;
        const Gate gate;
        const auto ended = std::make_shared<std::atomic<int>>(0);
        desk.background.run("Working…", gate.deafWork(ended), desk.store(), Cancel::Stops);
        clickCancel();
        QVERIFY(shownDialog() && desk.results.empty());
        QTest::keyClick(shownDialog(), Qt::Key_Escape); // nor does it close so
        QVERIFY(shownDialog() && desk.results.empty() && desk.background.busy());
        gate.open();
        QTRY_COMPARE(desk.results, Results{1});
        desk.background.run("Working…", gate.work(42), desk.store(), Cancel::Stops);
        clickCancel();
        QTRY_COMPARE(desk.results, (Results{1, -1})); // this one reads the request
        QVERIFY(!shownDialog());
    }
    void turnsFollowEachOtherWithoutMixing()
    {
        Desk desk;
        QStringList done;
        const Gate gate;
        const auto turnOfTwoJobs = [&](const QString& name) {
            desk.background.inTurn([&, name](const InBackground::Turn& turn) {
                const auto second = [&, name, turn](std::optional<int>) {
                    const auto end = [&done, name, turn](std::optional<int>) {
                        done << name + "2";
                    };
                    done << name + "1";
                    desk.background.run("…", gate.work(2), end, Cancel::Drops);
                };
                desk.background.run("…", gate.work(1), second, Cancel::Drops);
            });
        };
        turnOfTwoJobs("a");
        turnOfTwoJobs("b");
        desk.background.whenIdle([&] { done << "idle"; });
        for (int i = 0; i < 4; ++i)
            gate.open();
        QTRY_VERIFY(!desk.background.busy());
        QCOMPARE(done, QStringList({"a1", "a2", "b1", "b2", "idle"}));
        desk.background.whenIdle([&] { done << "at once"; });
        QCOMPARE(done.last(), QString("at once"));
    }
    void waitingEndsWithTheResultOrAtTheDeadline()
    {
        Desk desk;
        const Gate gate;
        desk.background.run("Working…", gate.work(42), desk.store(), Cancel::Drops);
        desk.background.wait(QDeadlineTimer(20));
        QVERIFY(desk.background.busy() && desk.results.empty());
        gate.open();
        desk.background.wait();
        QCOMPARE(desk.results, Results{42});
        desk.type(Qt::Key_A); // and input is taken again
        QCOMPARE(desk.field.text(), QString("a"));
    }
    void nothingIsDeliveredToADestroyedOwner()
    {
        for (const Cancel cancel : {Cancel::Drops, Cancel::Stops}) {
            const Gate gate;
            const auto ended = std::make_shared<std::atomic<int>>(0);
            bool delivered = false;
            {
                InBackground background(nullptr);
                background.run(
                    "Working…", gate.deafWork(ended), [&](std::optional<int>) { delivered = true; },
                    cancel);
                background.whenIdle([&] { delivered = true; });
                QVERIFY(gate.begun());
                if (cancel == Cancel::Stops)
                    gate.open(); // the destructor waits for it
            }
            QCOMPARE(int(*ended), int(cancel == Cancel::Stops));
            gate.open();
            QTRY_COMPARE(int(*ended), 1);
            QTest::qWait(20);
            QVERIFY(!delivered);
        }
    }
    void theReceiverOfTheResultMayDestroyTheOwner()
    {
        auto background = std::make_unique<InBackground>(nullptr);
        background->run(
            "Working…", [](const app::Follower&) { return 42; },
            [&](std::optional<int>) { background.reset(); }, Cancel::Drops);
        QTRY_VERIFY(!background);
    }
};

} // namespace dialogs_in_background_test

TEST_CLASS(dialogs_in_background_test::InBackgroundTest, Widgets)
#include "tests/ui/dialogs/in_background_test.moc"
