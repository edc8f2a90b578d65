// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/in_turn.h"

#include <QScopeGuard>
#include <QTest>

#include <chrono>
#include <semaphore>

#include "tests/test_class.h"

namespace base_in_turn_test {

class InTurnTest : public QObject {
    Q_OBJECT

    // Squares the numbers below `end`, on several threads; `give` sees them in order.
    static void squares(int threads, int end, const std::function<bool(int)>& give,
                        int failing = -1)
    {
        int next = 0;
        std::vector<int> shares(std::size_t(threads), 0);
        std::vector<app::TurnSteps> steps;
        for (int& share : shares)
            steps.push_back({[&] {
                                 share = next++;
                                 return share < end;
                             },
                             [&] {
                                 if (share % 3 == 0)
                                     std::this_thread::sleep_for(std::chrono::microseconds(50));
                                 if (share == failing)
                                     throw share;
                                 share *= share;
                             },
                             [&] { return give(share); }});
        app::InTurn().run(steps);
    }

private slots:
    void resultsAreGivenInOrder()
    {
        for (const int threads : {1, 2, 5}) {
            std::vector<int> given;
            squares(threads, 300, [&](int square) {
                given.push_back(square);
                return true;
            });
            QCOMPARE(given.size(), 300u);
            for (int i = 0; i < 300; ++i)
                QCOMPARE(given[std::size_t(i)], i * i);
        }
    }

    void whereNoThreadCanBeMadeTheCallingThreadWorksAlone()
    {
        pthread_attr_t usual, huge;
        QCOMPARE(pthread_getattr_default_np(&usual), 0);
        QCOMPARE(pthread_attr_init(&huge), 0);
        QCOMPARE(pthread_attr_setstacksize(&huge, std::size_t(1) << 60), 0); // no memory is left
        QCOMPARE(pthread_setattr_default_np(&huge), 0);
        const auto reset = qScopeGuard([&] { QCOMPARE(pthread_setattr_default_np(&usual), 0); });
        QVERIFY_EXCEPTION_THROWN(std::jthread([] {}), std::system_error);
        int given = 0;
        squares(4, 10, [&](int) { return ++given, true; });
        QCOMPARE(given, 10);
    }

    void whatIsBeforeAFailureIsGivenAndNothingAfterIt()
    {
        int given = 0;
        const auto count = [&](int) { return ++given, true; };
        QVERIFY_EXCEPTION_THROWN(squares(4, 300, count, 57), int);
        QCOMPARE(given, 57);
    }

    // The third share does not come before the input is stopped.
    void aWaitForInputEndsWithTheWork()
    {
        for (const bool fails : {false, true}) {
            std::binary_semaphore stop(0);
            int taken = 0;
            bool stopped = true;
            const auto take = [&] {
                if (++taken < 3)
                    return true;
                stopped = stop.try_acquire_for(std::chrono::seconds(20));
                return false;
            };
            const auto give = [&]() -> bool {
                if (fails)
                    throw 1;
                return false;
            };
            const std::vector<app::TurnSteps> threads(3, {take, [] {}, give});
            const auto run = [&] { app::InTurn().run(threads, [&] { stop.release(); }); };
            if (fails)
                QVERIFY_EXCEPTION_THROWN(run(), int);
            else
                run();
            QVERIFY(stopped);
        }
    }

    void nothingIsGivenOnceNoMoreIsWanted()
    {
        int given = 0;
        squares(4, 1'000'000, [&](int) { return ++given < 10; });
        QCOMPARE(given, 10);
    }
};

} // namespace base_in_turn_test

TEST_CLASS(base_in_turn_test::InTurnTest, Core)
#include "tests/app/base/in_turn_test.moc"
