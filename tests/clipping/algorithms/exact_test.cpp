// SPDX-License-Identifier: GPL-3.0-or-later
#include "clipping/algorithm.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/clipping/rational.h"
#include "tests/clipping/same_bits.h"
#include "tests/clipping/scenes.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace algorithms_exact_test {

using namespace clipping;

namespace {

/// The exact result: Liang and Barsky's intervals in rational numbers.
struct Truth {
    bool visible = false;
    Rational ax, ay, bx, by;
};

template <class T>
Truth truth(const BasicSegment<T>& s, const BasicWindow<T>& w)
{
    const Rational ax = rational(s.a.x), ay = rational(s.a.y);
    const Rational dx = rational(s.b.x) - ax, dy = rational(s.b.y) - ay;
    const Rational zero(0);
    Rational from(0), to(1);
    const auto within = [&](const Rational& start, const Rational& d, T low, T high) {
        if (d == zero)
            return start >= rational(low) && start <= rational(high);
        const Rational first = (rational(d > zero ? low : high) - start) / d;
        const Rational last = (rational(d > zero ? high : low) - start) / d;
        from = std::max(from, first);
        to = std::min(to, last);
        return from <= to;
    };
    if (!within(ax, dx, w.min.x, w.max.x) || !within(ay, dy, w.min.y, w.max.y))
        return {};
    return {true, ax + from * dx, ay + from * dy, ax + to * dx, ay + to * dy};
}

template <class T>
bool evenMantissa(T x)
{
    if constexpr (sizeof(T) == 8)
        return (std::bit_cast<std::uint64_t>(x) & 1) == 0;
    else
        return (std::bit_cast<std::uint32_t>(x) & 1) == 0;
}

/// Whether x is the T nearest to the exact value, the even one in a tie.
template <class T>
bool nearest(T x, const Rational& exact)
{
    const Rational value = rational(x);
    if (value == exact)
        return true;
    constexpr T infinity = std::numeric_limits<T>::infinity();
    const T neighbour = std::nextafter(x, exact > value ? infinity : -infinity);
    if (!std::isfinite(neighbour))
        return true;
    const Rational own = abs(exact - value), others = abs(exact - rational(neighbour));
    return own < others || (own == others && evenMantissa(x));
}

template <class S>
bool sameBits(const std::optional<S>& p, const std::optional<S>& q)
{
    return p.has_value() == q.has_value() && (!p || ::sameBits(*p, *q));
}

template <class S>
std::string described(const S& s)
{
    char text[200];
    std::snprintf(text, sizeof text, "(%a, %a) -> (%a, %a)", double(s.a.x), double(s.a.y),
                  double(s.b.x), double(s.b.y));
    return text;
}

template <class T>
void compareWithTruth(const Functions<BasicSegment<T>, BasicWindow<T>>& exact)
{
    for (const auto& [name, window, segments] : hardScenes<T>(3000)) {
        std::size_t visible = 0;
        for (const auto& s : segments) {
            const std::string input = name + ": " + described(s);
            const auto expected = truth(s, window);
            const auto piece = exact.clip(s, window);
            QVERIFY2(piece.has_value() == expected.visible, input.c_str());
            if (!piece)
                continue;
            ++visible;
            const std::string output = input + " gives " + described(*piece);
            QVERIFY2(nearest(piece->a.x, expected.ax) && nearest(piece->a.y, expected.ay)
                         && nearest(piece->b.x, expected.bx) && nearest(piece->b.y, expected.by),
                     output.c_str());
        }
        QVERIFY2(visible > 0 && visible < segments.size(), name.c_str());
    }
}

template <class T>
void compareWithReversed(const Functions<BasicSegment<T>, BasicWindow<T>>& exact)
{
    for (const auto& [name, window, segments] : hardScenes<T>(30000))
        for (const auto& s : segments) {
            auto backwards = exact.clip({s.b, s.a}, window);
            if (backwards)
                std::swap(backwards->a, backwards->b);
            VERIFY_OR_SAY(sameBits(exact.clip(s, window), backwards),
                          (name + ": " + described(s)).c_str());
        }
}

template <class T>
void compareEnds(const Functions<BasicSegment<T>, BasicWindow<T>>& exact)
{
    const auto inside = [](const glm::vec<2, T>& p, const BasicWindow<T>& w) {
        return p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y;
    };
    for (const auto& [name, window, segments] : hardScenes<T>(30000))
        for (const auto& s : segments) {
            const auto piece = exact.clip(s, window);
            if (!piece)
                continue;
            const std::string input = name + ": " + described(s);
            QVERIFY2(inside(piece->a, window) && inside(piece->b, window), input.c_str());
            QVERIFY2(!inside(s.a, window) || ::sameBits(s.a, piece->a), input.c_str());
            QVERIFY2(!inside(s.b, window) || ::sameBits(s.b, piece->b), input.c_str());
        }
}

} // namespace

class ExactTest : public QObject {
    Q_OBJECT

    const Algorithm& exact_ = exactAlgorithm();

private slots:
    void visibilityIsExactAndEndsAreRoundedOnce() { compareWithTruth(exact_.corrected); }
    void visibilityIsExactAndEndsAreRoundedOnceInFloat() { compareWithTruth(*exact_.floats); }
    void reversedSegmentsGiveTheSameBits() { compareWithReversed(exact_.corrected); }
    void reversedSegmentsGiveTheSameBitsInFloat() { compareWithReversed(*exact_.floats); }
    void endsStayInsideAndInnerEndsAreUnchanged() { compareEnds(exact_.corrected); }
    void endsStayInsideAndInnerEndsAreUnchangedInFloat() { compareEnds(*exact_.floats); }

    void emptyWindowsAndNonFiniteNumbersGiveNothing()
    {
        const auto clip = exact_.corrected.clip;
        const Segment across{{-3, 0}, {3, 1}};
        const Window window{{-1, -1}, {1, 1}};
        QVERIFY(clip(across, window));
        QVERIFY(!clip(across, {window.max, window.min}));
        for (const double bad : {double(NAN), double(INFINITY), -double(INFINITY)})
            for (std::size_t i = 0; i < 8; ++i) {
                double numbers[8] = {-3, 0, 3, 1, -1, -1, 1, 1};
                numbers[i] = bad;
                const auto& [ax, ay, bx, by, left, bottom, right, top] = numbers;
                QVERIFY(!clip({{ax, ay}, {bx, by}}, {{left, bottom}, {right, top}}));
            }
    }

    void visibilityIsDecidedToHalfAnUlp()
    {
        // The segment of algorithms.md X12: it misses the corner by half an ulp.
        const double u = std::numeric_limits<double>::epsilon();
        const Window unit{{0, 0}, {1, 1}};
        QVERIFY(!exact_.corrected.clip({{-1, 1 + 2 * u}, {3, 1 - u}}, unit));
        QVERIFY(exact_.corrected.clip({{-1, 1 + u}, {3, 1 - 3 * u}}, unit));
    }

    void hasNoPublishedForm() { QVERIFY(!exact_.published && exact_.floats); }
};

} // namespace algorithms_exact_test

TEST_CLASS(algorithms_exact_test::ExactTest, None)
#include "tests/clipping/algorithms/exact_test.moc"
