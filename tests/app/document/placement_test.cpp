// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/affine_map.h"

#include <QTest>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "tests/clipping/random.h"
#include "tests/test_class.h"

namespace document_placement_test {

using namespace app;

namespace {

std::array<std::uint64_t, 2> bitsOf(const Point& p)
{
    return std::bit_cast<std::array<std::uint64_t, 2>>(std::array{p.x, p.y});
}

Placement of(Random& r, auto number) { return {{number(r), number(r)}, {number(r), number(r)}}; }

} // namespace

class PlacementTest : public QObject {
    Q_OBJECT

private slots:
    void theIdentityChangesNoBit()
    {
        Random r(1);
        for (int i = 0; i < 100'000; ++i) {
            const Point p{anyNumber(r), anyNumber(r)};
            QCOMPARE(bitsOf(Placement{}(p)), bitsOf(p));
        }
        for (const double x : {-0.0, 0.0, double(INFINITY), -double(INFINITY)})
            QCOMPARE(bitsOf(Placement{}(Point(x))), bitsOf(Point(x)));
        QVERIFY(Placement{}.isIdentity());
        QVERIFY(!(Placement{{1, 1}, {0, -0.0}}).isIdentity()); // makes 0 of -0
        QVERIFY(!(Placement{{1, 2}, {-0.0, -0.0}}).isIdentity());
    }
    void numbersAreCompared()
    {
        QVERIFY((Placement{{1, 1}, {0, 0}} == Placement{}));
        QVERIFY(!(Placement{{1, 1}, {NAN, 0}} == Placement{{1, 1}, {NAN, 0}}));
        QVERIFY(!(Placement{{1, 1}, {0, 0x1p-1074}} == Placement{}));
    }
    // What two steps give may be lost in one.
    void scalesUnderflowAndOverflow()
    {
        const Placement small{{1e-200, 1e-200}, {-0.0, -0.0}}, large{{1e200, 1e200}, {-0.0, -0.0}};
        const Point far{1e300, -1e300}, near{1e-300, -1e-300};
        QVERIFY(small(small(far)).x > 0 && small.then(small)(far) == Point(0));
        QVERIFY(std::isfinite(large(large(near)).x) && std::isinf(large.then(large)(near).x));
        QCOMPARE(small.then(small).then(large).then(large)(far), Point(0));
    }
    // Scale 1 moves only: one rounding, as an addition has. -0 moves nothing: one rounding, too.
    void oneOfTheTwoRoundsOnce()
    {
        Random r(2);
        for (int i = 0; i < 100'000; ++i) {
            const Point p{anyNumber(r), anyNumber(r)}, q{anyNumber(r), anyNumber(r)};
            QCOMPARE(bitsOf(Placement{{1, 1}, q}(p)), bitsOf(p + q));
            QCOMPARE(bitsOf(Placement{q, {-0.0, -0.0}}(p)), bitsOf(p * q));
        }
    }
    void theyComposeExactlyWhereNothingIsRounded()
    {
        Random r(3);
        const auto whole = [](Random& random) { return double(random.whole(-8, 8)); };
        for (int i = 0; i < 100'000; ++i) {
            const Placement a = of(r, whole), b = of(r, whole);
            const Point p{whole(r), whole(r)};
            QCOMPARE(a.then(b)(p), b(a(p)));
        }
    }
    void theyComposeWithinAFewRoundings()
    {
        Random r(4);
        const auto real = [](Random& random) { return random.between(-8, 8); };
        for (int i = 0; i < 100'000; ++i) {
            const Placement a = of(r, real), b = of(r, real);
            const Point p{real(r), real(r)};
            const Point once = a.then(b)(p), twice = b(a(p));
            for (const int k : {0, 1}) {
                const double size =
                    (std::abs(p[k] * a.scale[k]) + std::abs(a.offset[k])) * std::abs(b.scale[k])
                    + std::abs(b.offset[k]);
                QVERIFY(std::abs(once[k] - twice[k]) <= 3 * size * 0x1p-52);
            }
        }
    }
    void theUsualOneBeforeOrAfterIsNothing()
    {
        Random r(5);
        for (int i = 0; i < 1000; ++i) {
            const Placement some = of(r, [](Random& random) { return anyNumber(random); });
            for (const Placement& same : {some.then(Placement{}), Placement{}.then(some)}) {
                QCOMPARE(bitsOf(same.scale), bitsOf(some.scale));
                QCOMPARE(bitsOf(same.offset), bitsOf(some.offset));
            }
        }
    }
    void aScaleTurnedOverKeepsTheSignOfZero()
    {
        const Placement twice{{2, 2}, {-0.0, -0.0}}, flip{{-1, 1}, {-0.0, -0.0}};
        for (const double x : {0.0, -0.0})
            QCOMPARE(bitsOf(twice.then(flip)(Point(x))), bitsOf(flip(twice(Point(x)))));
    }
};

} // namespace document_placement_test

TEST_CLASS(document_placement_test::PlacementTest, None)
#include "tests/app/document/placement_test.moc"
