// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/object_ranges.h"

#include <QTest>

#include <algorithm>
#include <random>
#include <set>

#include "tests/test_class.h"

namespace document_object_ranges_test {

namespace {

using Set = std::set<std::size_t>;

Set numbers(const app::ObjectRanges& ranges) { return {ranges.begin(), ranges.end()}; }

// What the class promises of its ranges, and that its count is right.
bool wellFormed(const app::ObjectRanges& ranges)
{
    const auto joins = [](const app::ObjectRange& a, const app::ObjectRange& b) {
        return b.first <= a.end;
    };
    std::size_t count = 0;
    for (const app::ObjectRange& range : ranges.ranges())
        count += range.size();
    return count == ranges.size() && ranges.empty() == (count == 0)
           && std::ranges::none_of(ranges.ranges(), &app::ObjectRange::empty)
           && std::ranges::adjacent_find(ranges.ranges(), joins) == ranges.ranges().end();
}

bool same(const app::ObjectRanges& ranges, const Set& set)
{
    return wellFormed(ranges) && numbers(ranges) == set;
}

constexpr std::size_t most = 60; // few, so that ranges meet often

} // namespace

class ObjectRangesTest : public QObject {
    Q_OBJECT

private slots:
    void insertsAndErasesAsASetDoes()
    {
        app::ObjectRanges ranges;
        Set set;
        for (int round = 0; round < 20'000; ++round) {
            const std::size_t first = random_() % most, end = first + random_() % 12;
            switch (random_() % 4) {
            case 0:
                QCOMPARE(ranges.insert(first), set.insert(first).second);
                break;
            case 1:
                QCOMPARE(ranges.erase(first), set.erase(first) == 1);
                break;
            case 2:
                ranges.insert(app::ObjectRange{first, end});
                for (std::size_t i = first; i < end; ++i)
                    set.insert(i);
                break;
            default:
                ranges.erase(app::ObjectRange{first, end});
                set.erase(set.lower_bound(first), set.lower_bound(end));
                break;
            }
            const auto in =
                std::ranges::count_if(set, [&](std::size_t i) { return first <= i && i < end; });
            QCOMPARE(ranges.contains({first, end}), std::size_t(in) == end - first);
            QCOMPARE(ranges.intersects({first, end}), in > 0);
            QVERIFY(same(ranges, set));
            QCOMPARE(ranges.contains(first), set.contains(first));
            QVERIFY(set.empty()
                    || (ranges.first() == *set.begin() && ranges.last() == *set.rbegin()));
        }
    }
    void equalMeansTheSameObjects()
    {
        for (int round = 0; round < 2000; ++round) {
            const Set set = some();
            app::ObjectRanges up, down;
            std::for_each(set.begin(), set.end(), [&](std::size_t i) { up.insert(i); });
            std::for_each(set.rbegin(), set.rend(), [&](std::size_t i) { down.insert(i); });
            QVERIFY(same(up, set) && up == down);
            down.insert(most);
            QVERIFY(up != down);
        }
    }
    void unionsAndIntersectionsAreThoseOfSets()
    {
        for (int round = 0; round < 2000; ++round) {
            const Set a = some(), b = some();
            const app::ObjectRanges left = ranges(a), right = ranges(b);
            Set both, either = a, leftOnly;
            either.insert(b.begin(), b.end());
            std::ranges::set_intersection(a, b, std::inserter(both, both.end()));
            std::ranges::set_difference(a, b, std::inserter(leftOnly, leftOnly.end()));
            QVERIFY(same(united(left, right), either));
            QVERIFY(same(common(left, right), both));
            QVERIFY(same(without(left, right), leftOnly));
        }
    }
    void followsWhatIsReplaced()
    {
        for (int round = 0; round < 2000; ++round) {
            const Set before = some();
            const std::size_t first = random_() % most, removed = random_() % 20,
                              added = random_() % 20;
            Set after;
            for (const std::size_t object : before)
                if (object < first)
                    after.insert(object);
                else if (object >= first + removed)
                    after.insert(object - removed + added);
            QVERIFY(same(ranges(before).shifted(first, removed, added), after));
        }
    }
    void neighboursAreOneRange()
    {
        app::ObjectRanges ranges{3, 1};
        QCOMPARE(ranges.ranges().size(), std::size_t(2));
        ranges.insert(2);
        QCOMPARE(ranges.ranges().size(), std::size_t(1));
        QCOMPARE(ranges.ranges().front(), (app::ObjectRange{1, 4}));
        ranges.insert(app::ObjectRange{4, 4}); // empty
        QCOMPARE(ranges, (app::ObjectRanges{1, 2, 3}));
        ranges.erase(app::ObjectRange{9, 2}); // empty
        QCOMPARE(ranges.size(), std::size_t(3));
    }
    void allOfAMillionIsOneRange()
    {
        constexpr std::size_t million = 1'000'000;
        const app::ObjectRanges all(app::ObjectRange{0, million});
        QCOMPARE(all.ranges().size(), std::size_t(1));
        QCOMPARE(all.size(), million);
        QVERIFY(all.contains(0) && all.contains(million - 1) && !all.contains(million));
        QCOMPARE(all.shifted(10, 5, 5).ranges().size(), std::size_t(2));
        QCOMPARE(all.shifted(0, 0, 7).ranges().front(), (app::ObjectRange{7, million + 7}));
        app::ObjectRanges one;
        for (std::size_t i = 0; i < million; ++i)
            one.insert(i);
        QCOMPARE(one, all);
    }

private:
    Set some()
    {
        Set set;
        const auto share = random_() % 8;
        for (std::size_t i = 0; i < most; ++i)
            if (random_() % 8 <= share)
                set.insert(i);
        return set;
    }
    static app::ObjectRanges ranges(const Set& set)
    {
        app::ObjectRanges all;
        for (const std::size_t object : set)
            all.insert(object);
        return all;
    }

    std::mt19937_64 random_{13};
};

} // namespace document_object_ranges_test

TEST_CLASS(document_object_ranges_test::ObjectRangesTest, None)
#include "tests/app/document/object_ranges_test.moc"
