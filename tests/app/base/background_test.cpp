// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/background.h"

#include <QElapsedTimer>
#include <QSemaphore>
#include <QTest>
#include <QThread>
#include <QThreadPool>
#include <QUnhandledException>

#include <atomic>
#include <vector>

#include "tests/test_class.h"

namespace base_background_test {

using app::Background;
using app::Follower;
using namespace std::chrono_literals;

namespace {

/// Work that ends when the test opens it, or when it is stopped.
struct Gate {
    std::shared_ptr<QSemaphore> begun = std::make_shared<QSemaphore>();
    std::shared_ptr<QSemaphore> open = std::make_shared<QSemaphore>();

    auto work(int result) const
    {
        return [begun = begun, open = open, result](const Follower& follower) {
            begun->release();
            while (!open->tryAcquire(1, 1))
                if (follower.stop.stop_requested())
                    return -1;
            return result;
        };
    }
};

auto storedIn(std::vector<int>& results)
{
    return [&results](int result) { results.push_back(result); };
}

/// Waits until no work runs, so that everything that could be delivered late has been sent.
void settle()
{
    QTRY_COMPARE(app::backgroundThreads().activeThreadCount(), 0);
    QTest::qWait(20);
}

} // namespace

class BackgroundTest : public QObject {
    Q_OBJECT

private slots:
    void deliversInTheOwnersThread()
    {
        Background<Qt::HANDLE> background;
        Qt::HANDLE worker = nullptr, owner = nullptr;
        background.start([](const Follower&) { return QThread::currentThreadId(); },
                         [&](Qt::HANDLE result) {
                             worker = result;
                             owner = QThread::currentThreadId();
                         });
        QVERIFY(background.active() && !owner); // an event brings it
        QTRY_VERIFY(owner);
        QCOMPARE(owner, QThread::currentThreadId());
        QVERIFY(worker != owner);
        QVERIFY(!background.active());
    }

    void resultsNeedNotBeCopied()
    {
        Background<std::unique_ptr<int>> background;
        std::unique_ptr<int> result;
        background.start([](const Follower&) { return std::make_unique<int>(7); },
                         [&](std::unique_ptr<int> made) { result = std::move(made); });
        QTRY_VERIFY(result);
        QCOMPARE(*result, 7);
    }

    void tellsProgressInTheOwnersThread()
    {
        Background<int> background;
        std::vector<double> shares;
        bool here = true;
        const Gate gate;
        background.start(
            [gate](const Follower& follower) {
                for (int i = 1; i <= 10; ++i) {
                    follower.progress({i / 10.0, 10.0 - i});
                    QThread::msleep(20);
                }
                return gate.work(3)(follower);
            },
            [](int) {},
            [&](const app::Progress& progress) {
                here = here && QThread::currentThread() == thread();
                shares.push_back(progress.share);
                QCOMPARE(progress.secondsLeft, 10 - 10 * progress.share);
            });
        QVERIFY(gate.begun->tryAcquire(1, 10'000));
        QTRY_VERIFY(!shares.empty());
        QVERIFY(here && shares.size() <= 6); // not each of the ten
        QVERIFY(std::ranges::is_sorted(shares));
        gate.open->release();
        QTRY_VERIFY(!background.active());
    }

    void cancelStopsAndDeliversNothing()
    {
        Background<int> background;
        std::vector<int> results;
        const Gate gate;
        background.start(gate.work(1), storedIn(results));
        QVERIFY(gate.begun->tryAcquire(1, 10'000));
        background.cancel();
        QVERIFY(!background.active());
        settle();
        QVERIFY(results.empty());
    }

    /// The result is already among the events.
    void cancelAfterTheEndDeliversNothing()
    {
        Background<int> background;
        std::vector<int> results;
        background.start([](const Follower&) { return 1; }, storedIn(results));
        QVERIFY(app::backgroundThreads().waitForDone(10'000));
        background.cancel();
        settle();
        QVERIFY(results.empty());
    }

    void theDestructorNeitherWaitsNorDelivers()
    {
        std::vector<int> results;
        const Gate deaf;
        QElapsedTimer clock;
        {
            Background<int> background;
            background.start(
                [deaf](const Follower&) {
                    deaf.begun->release();
                    deaf.open->acquire(); // does not read its stop token
                    return 1;
                },
                storedIn(results));
            QVERIFY(deaf.begun->tryAcquire(1, 10'000));
            clock.start();
        }
        QVERIFY(clock.elapsed() < 5'000);
        QCOMPARE(app::backgroundThreads().activeThreadCount(), 1);
        deaf.open->release();
        settle();
        QVERIFY(results.empty());
    }

    void aNewWorkReplacesTheOldOneAndWaitsForItsEnd()
    {
        Background<int> background;
        std::vector<int> results;
        std::atomic<int> working = 0, most = 0;
        const auto counted = [&](auto work) {
            return [&, work](const Follower& follower) {
                most = std::max<int>(most, ++working);
                const int result = work(follower);
                QThread::msleep(20);
                --working;
                return result;
            };
        };
        const Gate gate;
        background.start(counted(gate.work(1)), storedIn(results));
        QVERIFY(gate.begun->tryAcquire(1, 10'000));
        for (int i = 2; i <= 9; ++i)
            background.start(counted([i](const Follower&) { return i; }), storedIn(results));
        QTRY_VERIFY(!background.active());
        settle();
        QCOMPARE(results, std::vector{9});
        QCOMPARE(most.load(), 1);
    }

    void waitingDeliversOnce()
    {
        Background<int> background;
        std::vector<int> results;
        const Gate gate;
        background.start(gate.work(1), storedIn(results));
        QVERIFY(!background.waitFor(10ms));
        QVERIFY(results.empty() && background.active());
        gate.open->release();
        QVERIFY(background.waitFor(10s));
        QCOMPARE(results, std::vector{1});
        settle();
        QCOMPARE(results, std::vector{1});
        background.start([](const Follower&) { return 2; }, storedIn(results));
        background.wait();
        QCOMPARE(results, (std::vector{1, 2}));
        background.wait(); // nothing to wait for
        QVERIFY(background.waitFor(0ms));
    }

    void aRequestToStopIsAnswered()
    {
        Background<int> background;
        std::vector<int> results;
        const Gate gate;
        background.requestStop(); // nobody is asked
        background.start(gate.work(1), storedIn(results));
        background.requestStop();
        QTRY_COMPARE(results, std::vector{-1});
    }

    void aDeliveryMayStartTheNextOrDestroyTheOwner()
    {
        auto background = std::make_unique<Background<int>>();
        std::vector<int> results;
        background->start([](const Follower&) { return 1; },
                          [&](int one) {
                              results.push_back(one);
                              background->start([](const Follower&) { return 2; },
                                                [&](int two) {
                                                    background.reset();
                                                    results.push_back(two);
                                                });
                          });
        QTRY_COMPARE(results, (std::vector{1, 2}));
        QVERIFY(!background);
    }

    void progressMayCancel()
    {
        Background<int> background;
        std::vector<int> results;
        int told = 0;
        const Gate gate;
        background.start(
            [gate](const Follower& follower) {
                follower.progress({0.5, 1});
                return gate.work(1)(follower);
            },
            storedIn(results),
            [&](const app::Progress&) {
                ++told;
                background.cancel();
            });
        QTRY_COMPARE(told, 1);
        settle();
        QVERIFY(results.empty());
    }

    void anExceptionArrivesWithTheResult()
    {
        Background<int> background;
        background.start([](const Follower&) -> int { throw std::bad_alloc(); }, [](int) {});
        QVERIFY_EXCEPTION_THROWN(background.wait(), QUnhandledException);
        QVERIFY(!background.active());
    }

    /// The canvas paints on threads of its own.
    void longWorkTakesNoThreadFromTheCanvas()
    {
        std::vector<std::unique_ptr<Background<int>>> many;
        std::vector<int> results;
        const Gate gate;
        for (int i = 0; i < QThread::idealThreadCount() + 3; ++i) {
            many.push_back(std::make_unique<Background<int>>());
            many.back()->start(gate.work(i), storedIn(results));
        }
        QVERIFY(gate.begun->tryAcquire(int(many.size()), 10'000)); // all at the same time
        QCOMPARE(app::paintingThreads().activeThreadCount(), 0);
        gate.open->release(int(many.size()));
        QTRY_COMPARE(results.size(), many.size());
    }
};

} // namespace base_background_test

TEST_CLASS(base_background_test::BackgroundTest, Core)
#include "tests/app/base/background_test.moc"
