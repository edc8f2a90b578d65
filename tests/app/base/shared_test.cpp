// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/shared.h"

#include <QTest>

#include <thread>
#include <vector>

#include "tests/test_class.h"

namespace base_shared_test {

using app::Shared;

class SharedTest : public QObject {
    Q_OBJECT

private slots:
    void aCopyIsAnotherOwnerOfTheSameValue()
    {
        Shared<std::vector<int>> one({1, 2, 3});
        QVERIFY(!one.isShared());
        {
            const Shared<std::vector<int>> other = one;
            QVERIFY(one.isShared());
            QVERIFY(sameAddress(one, other));
            QCOMPARE(other->data(), one->data());
        }
        QVERIFY(!one.isShared());
        const int* const at = one->data();
        QCOMPARE(one.own().data(), at); // alone: no copy
    }
    void whatIsSharedIsNeverWritten()
    {
        Shared<std::vector<int>> one({1, 2, 3});
        const Shared<std::vector<int>> other = one;
        one.own().push_back(4);
        QCOMPARE(*other, (std::vector{1, 2, 3}));
        QCOMPARE(*one, (std::vector{1, 2, 3, 4}));
        QVERIFY(!one.isShared() && !other.isShared());
        QVERIFY(!sameAddress(one, other));
    }
    void valuesAreCompared()
    {
        const Shared<std::vector<int>> one({1, 2}), equal({1, 2}), other({1, 3});
        QVERIFY(one == equal);
        QVERIFY(one != other);
        QVERIFY(Shared<std::vector<int>>() == Shared(std::vector<int>()));
    }
    void movingAndAssigningKeepTheCount()
    {
        Shared<std::vector<int>> one({1}), other({2});
        const Shared<std::vector<int>> taken = std::move(one);
        QVERIFY(!taken.isShared());
        one = taken;
        QVERIFY(taken.isShared());
        one = other;
        QVERIFY(!taken.isShared());
        QVERIFY(other.isShared());
        auto& itself = one;
        one = itself;
        QCOMPARE(*one, std::vector{2});
    }
    // The thread sanitizer finds the write if `isShared` does not acquire what the readers
    // released.
    void theLastReadsOfOthersHappenBeforeAWrite()
    {
        Shared<std::vector<int>> value(std::vector<int>(100, 7));
        for (int round = 0; round < 50; ++round) {
            std::vector<std::jthread> readers;
            for (int i = 0; i < 4; ++i)
                readers.emplace_back([mine = value, round]() mutable {
                    for (const int number : *mine)
                        if (number != 7 + round)
                            qFatal("a reader saw a write");
                    Shared<std::vector<int>> copy = mine;
                    copy.own()[0] = -1;
                    mine = std::move(copy);
                });
            while (value.isShared())
                std::this_thread::yield();
            for (int& number : value.own())
                ++number;
        }
        QCOMPARE(*value, std::vector<int>(100, 57));
    }
};

} // namespace base_shared_test

TEST_CLASS(base_shared_test::SharedTest, None)
#include "tests/app/base/shared_test.moc"
