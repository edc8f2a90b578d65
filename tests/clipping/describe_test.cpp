// SPDX-License-Identifier: GPL-3.0-or-later
#include "clipping/describe.h"

#include <QTest>

#include "tests/test_class.h"

namespace describe_test {

using namespace clipping;

namespace {

/// A row of our own that does no more than look at its numbers.
struct Plain {
    static constexpr About about{"plain", "P", "Plain", 2026, "Look.", 1};
    static constexpr bool ours = true;

    static inline double largest = 0; ///< |coordinate| that it was given
    template <class T, class Step>
    static std::optional<BasicSegment<T>> corrected(const BasicSegment<T>& s, const BasicWindow<T>&,
                                                    Step&& step)
    {
        if constexpr (std::is_same_v<T, double>)
            largest = std::abs(s.b.x);
        return step.accept("accept", s);
    }
};

/// The same, for all numbers.
struct Unframed : Plain {
    static constexpr bool unframed = true;
};

} // namespace

class DescribeTest : public QObject {
    Q_OBJECT

private slots:
    void aRowOfOurOwnHasNoPublishedForm()
    {
        QVERIFY(!describe<Plain>().published);
        QVERIFY(!describe<Plain>().box);
    }

    // Else it would have to prevent overflow itself.
    void aRowOfOurOwnGetsOrdinaryNumbers()
    {
        const Segment huge{{0, 0}, {0x1p600, 1}};
        const Window window{{0, 0}, {1, 1}};
        describe<Plain>().corrected.clip(huge, window);
        QVERIFY(Plain::largest > 0 && Plain::largest <= ordinaryMost<double>);
        describe<Unframed>().corrected.clip(huge, window);
        QCOMPARE(Plain::largest, 0x1p600);
    }
};

} // namespace describe_test

TEST_CLASS(describe_test::DescribeTest, None)
#include "tests/clipping/describe_test.moc"
