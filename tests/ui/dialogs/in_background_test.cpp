// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/in_background.h"

#include <QApplication>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSemaphore>
#include <QTest>

#include <vector>

using ui::InBackground;
using Cancel = InBackground::Cancel;

namespace {

ui::WaitingDialog* shownDialog()
{
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* dialog = qobject_cast<ui::WaitingDialog*>(widget); dialog && dialog->isVisible())
            return dialog;
    return nullptr;
}

void clickCancel()
{
    QTRY_VERIFY(shownDialog());
    QTest::mouseClick(shownDialog()->findChild<QPushButton*>(), Qt::LeftButton);
}

/// Work that ends when the test lets it, or when it reads a stop request.
class Gate {
public:
    auto work(int result) const
    {
        return [open = open_, result](const app::Follower& follower) {
            while (!open->tryAcquire(1, 1))
                if (follower.stop.stop_requested())
                    return -1;
            return result;
        };
    }
    /// Work that reads no stop request.
    auto deafWork(std::shared_ptr<std::atomic<int>> ended) const
    {
        return [begun = begun_, open = open_, ended](const app::Follower&) {
            begun->release();
            open->acquire();
            return ++*ended;
        };
    }
    void open() const { open_->release(); }
    bool begun() const { return begun_->tryAcquire(1, 5000); } ///< the deaf work

private:
    std::shared_ptr<QSemaphore> begun_ = std::make_shared<QSemaphore>();
    std::shared_ptr<QSemaphore> open_ = std::make_shared<QSemaphore>();
};

/// A window with a field, which gets the keys.
struct Desk {
    Desk()
    {
        window.show();
        window.activateWindow();
        field.setFocus();
    }
    auto store()
    {
        return [this](std::optional<int> result) { results.push_back(result); };
    }
    /// As the system sends it.
    void type(Qt::Key key) { QTest::keyClick(window.windowHandle(), key); }

    QWidget window;
    QLineEdit field{&window};
    InBackground background{&window};
    std::vector<std::optional<int>> results;
};

using Results = std::vector<std::optional<int>>;

} // namespace

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
    void inputWaitsUntilTheWorkHasEnded()
    {
        Desk desk;
        const Gate gate;
        desk.background.run("Working…", gate.work(42), desk.store(), Cancel::Drops);
        for (const Qt::Key key : {Qt::Key_A, Qt::Key_B, Qt::Key_C})
            desk.type(key);
        QTest::mouseClick(desk.window.windowHandle(), Qt::LeftButton);
        QCOMPARE(desk.field.text(), QString());
        gate.open();
        QTRY_COMPARE(desk.field.text(), QString("abc"));
        desk.type(Qt::Key_D);
        QCOMPARE(desk.field.text(), QString("abcd"));
    }
    void inputBeforeTheDialogIsForgotten()
    {
        Desk desk;
        const Gate gate;
        desk.background.run("Working…", gate.work(42), desk.store(), Cancel::Drops);
        desk.type(Qt::Key_A);
        QTRY_VERIFY(shownDialog());
        desk.type(Qt::Key_B);
        gate.open();
        QTRY_VERIFY(!desk.background.busy());
        desk.type(Qt::Key_C);
        QCOMPARE(desk.field.text(), QString("c"));
    }
    void inputThatBeginsTheNextJobWaitsInItsOrder()
    {
        Desk desk;
        const Gate first, second;
        connect(&desk.field, &QLineEdit::textEdited, this, [&](const QString& text) {
            if (text == "a")
                desk.background.run("Working…", second.work(2), desk.store(), Cancel::Drops);
        });
        desk.background.run("Working…", first.work(1), desk.store(), Cancel::Drops);
        desk.type(Qt::Key_A);
        desk.type(Qt::Key_B);
        first.open();
        QTRY_COMPARE(desk.field.text(), QString("a"));
        desk.type(Qt::Key_C);
        QTest::qWait(20);
        QCOMPARE(desk.field.text(), QString("a"));
        second.open();
        QTRY_COMPARE(desk.field.text(), QString("abc"));
        QCOMPARE(desk.results, (Results{1, 2}));
    }
    void aDroppedJobHasNoResultAndDoesNotDelayTheNext()
    {
        Desk desk;
        const Gate gate;
        const auto ended = std::make_shared<std::atomic<int>>(0);
        desk.background.run("Working…", gate.deafWork(ended), desk.store(), Cancel::Drops);
        clickCancel();
        QCOMPARE(desk.results, Results{std::nullopt});
        QVERIFY(!shownDialog() && !desk.background.busy() && *ended == 0);
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
    void waitingDeliversTheResult()
    {
        Desk desk;
        desk.background.run(
            "Working…", [](const app::Follower&) { return 42; }, desk.store(), Cancel::Drops);
        desk.background.wait();
        QCOMPARE(desk.results, Results{42});
        QVERIFY(!desk.background.busy());
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

QTEST_MAIN(InBackgroundTest)
#include "in_background_test.moc"
