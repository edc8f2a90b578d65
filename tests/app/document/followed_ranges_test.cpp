// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/object_ranges.h"

#include <QTest>

#include <random>

#include "tests/test_class.h"

namespace document_followed_ranges_test {

using namespace app;

class FollowedRangesTest : public QObject {
    Q_OBJECT

private slots:
    void areThoseOfOneSpliceAfterTheOther()
    {
        std::mt19937 random(3);
        const auto below = [&](std::size_t n) { return std::size_t(random() % n); };
        for (int round = 0; round < 20'000; ++round) {
            ObjectRanges objects;
            for (auto n = below(8); n > 0; --n) {
                const std::size_t first = below(60);
                objects.insert(ObjectRange{first, first + below(9)});
            }
            std::vector<Splice> splices;
            for (std::size_t at = below(10); at < 60; at += below(10)) {
                const Splice s{std::uint32_t(at), std::uint32_t(below(4)), std::uint32_t(below(4))};
                splices.push_back(s);
                at += s.removed;
            }
            ObjectRanges expected = objects;
            std::for_each(splices.rbegin(), splices.rend(), [&](const Splice& s) {
                if (s.removed != s.added)
                    expected = expected.shifted(s.first, s.removed, s.added);
            });
            QCOMPARE(followed(objects, splices), expected);
        }
    }
    // One after the other it would take hours.
    void manyAreNoTrouble()
    {
        ObjectRanges objects;
        std::vector<Splice> splices;
        for (std::uint32_t i = 0; i < 500'000; ++i) {
            objects.insert(ObjectRange{4 * i, 4 * i + 2});
            splices.push_back({4 * i, 1, 0});
        }
        const ObjectRanges left = followed(objects, splices);
        QCOMPARE(left.ranges().size(), std::size_t(500'000));
        QCOMPARE(left.ranges()[1], (ObjectRange{3, 4}));
    }
};

} // namespace document_followed_ranges_test

TEST_CLASS(document_followed_ranges_test::FollowedRangesTest, None)
#include "tests/app/document/followed_ranges_test.moc"
