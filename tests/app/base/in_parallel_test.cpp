// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/in_parallel.h"

#include <QTest>
#include <QThreadPool>

#include <atomic>
#include <semaphore>
#include <thread>
#include <vector>

#include "tests/test_class.h"

namespace base_in_parallel_test {

class InParallelTest : public QObject {
    Q_OBJECT

private slots:
    void eachItemIsWorkedOnOnce()
    {
        QThreadPool pool;
        for (const int threads : {1, 2, 5}) {
            pool.setMaxThreadCount(threads);
            for (const std::size_t items : {0, 1, 2, 300}) {
                std::vector<std::atomic<int>> calls(items), busy(app::workersOf(pool));
                std::atomic<int> clashes = 0;
                app::inParallel(pool, app::workersOf(pool), items,
                                [&](std::size_t item, std::size_t worker) {
                                    clashes += busy[worker]++ != 0;
                                    ++calls[item];
                                    if (item % 3 == 0)
                                        std::this_thread::sleep_for(std::chrono::microseconds(50));
                                    --busy[worker];
                                });
                QCOMPARE(clashes.load(), 0);
                for (const auto& count : calls)
                    QCOMPARE(count.load(), 1);
            }
        }
    }

    void freeThreadsTakePart()
    {
        QThreadPool pool;
        pool.setMaxThreadCount(2);
        std::counting_semaphore<2> met(0);
        // Each of the two items waits for the other.
        app::inParallel(pool, 2, 2, [&](std::size_t item, std::size_t) {
            static std::binary_semaphore here[2]{std::binary_semaphore(0),
                                                 std::binary_semaphore(0)};
            here[item].release();
            QVERIFY(here[1 - item].try_acquire_for(std::chrono::seconds(60)));
            met.release();
        });
        QVERIFY(met.try_acquire() && met.try_acquire());
    }

    // All threads of the pool are busy, and wait for what is called here.
    void waitsForNoThreadThatHasNotBegun()
    {
        QThreadPool pool;
        pool.setMaxThreadCount(1);
        std::binary_semaphore done(0);
        pool.start([&] { done.acquire(); });
        int calls = 0;
        pool.setMaxThreadCount(2);
        pool.start([&] {
            app::inParallel(pool, 2, 100, [&](std::size_t, std::size_t) { ++calls; });
            done.release();
        });
        QVERIFY(pool.waitForDone(60'000));
        QCOMPARE(calls, 100);
    }

    void theFirstExceptionIsThrownAgain()
    {
        QThreadPool pool;
        pool.setMaxThreadCount(3);
        constexpr int items = 2000; // with the waits below: seconds
        std::atomic<int> calls = 0;
        std::atomic<bool> thrown = false;
        const auto work = [&](std::size_t item, std::size_t) {
            ++calls;
            if (item == 7) {
                thrown = true;
                throw std::bad_alloc();
            }
            while (item > 7 && !thrown)
                std::this_thread::yield();
            if (item > 7)
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
        };
        QVERIFY_EXCEPTION_THROWN(app::inParallel(pool, 3, items, work), std::bad_alloc);
        QVERIFY(calls < items);
        QVERIFY(pool.waitForDone(60'000));
    }
};

} // namespace base_in_parallel_test

TEST_CLASS(base_in_parallel_test::InParallelTest, Core)
#include "tests/app/base/in_parallel_test.moc"
