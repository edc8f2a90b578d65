// SPDX-License-Identifier: GPL-3.0-or-later
// Whole numbers of thousands of bits against Boost's.
#ifndef Q_MOC_RUN // which stumbles over the concepts behind <compare>
#include "clipping/exact/integer.h"
#endif

#include <QTest>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "tests/test_class.h"

namespace exact_integer_test {

using boost::multiprecision::cpp_int;
using clipping::ExactInteger;

namespace {

/// One number as both write it.
struct Number {
    ExactInteger ours;
    cpp_int truth;
};

/// `whole * 2^shift`; a double holds `whole` exactly.
Number number(double whole, int shift)
{
    return {ExactInteger(std::ldexp(whole, shift), 0), cpp_int(whole) << shift};
}

/// Without its sign. (Boost's abs of a sum refers to temporaries, which clang's analyzer does not
/// like.)
cpp_int sizeOf(const cpp_int& truth) { return truth < 0 ? cpp_int(-truth) : truth; }

/// Ours, put together from the truth's digits.
ExactInteger fromDigits(cpp_int truth)
{
    const bool negative = truth < 0;
    ExactInteger all;
    truth = sizeOf(truth);
    for (int place = 0; truth != 0; ++place, truth >>= 32)
        all = all + (ExactInteger(double(truth & 0xffffffff), 0) << 32 * place);
    return negative ? -all : all;
}
bool same(const ExactInteger& ours, const cpp_int& truth)
{
    return (ours - fromDigits(truth)).sign() == 0 && ours.sign() == truth.sign();
}
int bitsOf(const cpp_int& truth) { return truth == 0 ? 0 : int(msb(sizeOf(truth))) + 1; }

std::vector<Number> numbers()
{
    std::vector<Number> all{{},
                            number(1, 0),
                            number(-1, 0),
                            number(4294967295.0, 0),
                            number(4294967296.0, 0),
                            number(-9007199254740991.0, 900)};
    std::mt19937_64 random(7);
    for (int i = 0; i < 40; ++i) {
        const double whole = double(std::int64_t(random()) >> (11 + i));
        const Number n = number(whole, int(random() % 500)), m = number(double(i - 20), 0);
        all.push_back(n);
        all.push_back({n.ours + m.ours, n.truth + m.truth}); // bits far apart
    }
    return all;
}

} // namespace

class IntegerTest : public QObject {
    Q_OBJECT

private slots:
    void countsItsBits()
    {
        for (const auto& [ours, truth] : numbers()) {
            QVERIFY(same(ours, truth));
            QVERIFY(same(-ours, -truth));
            QCOMPARE(ours.bits(), bitsOf(truth));
        }
    }

    void shifts()
    {
        for (const auto& [ours, truth] : numbers())
            for (const int count : {0, 1, 31, 32, 33, 300})
                QVERIFY(same(ours << count, truth << count));
    }

    void addsSubtractsMultiplies()
    {
        for (const Number& a : numbers())
            for (const Number& b : numbers()) {
                QVERIFY(same(a.ours + b.ours, a.truth + b.truth));
                QVERIFY(same(a.ours - b.ours, a.truth - b.truth));
                QVERIFY(same(a.ours * b.ours, a.truth * b.truth));
            }
    }

    void dividesMagnitudes()
    {
        for (const Number& a : numbers())
            for (const Number& b : numbers()) {
                if (b.truth == 0 || bitsOf(a.truth) - bitsOf(b.truth) > 61)
                    continue;
                const auto quotient = ExactInteger::divide(a.ours, b.ours);
                QCOMPARE(cpp_int(quotient.whole), cpp_int(sizeOf(a.truth) / sizeOf(b.truth)));
                QCOMPARE(quotient.remainder, sizeOf(a.truth) % sizeOf(b.truth) != 0);
            }
    }

    void knowsTheLowestBitOfADouble()
    {
        QCOMPARE(clipping::lowestBit(1), 0);
        QCOMPARE(clipping::lowestBit(-12), 2);
        QCOMPARE(clipping::lowestBit(0x1p-1074), -1074);
        QCOMPARE(clipping::lowestBit(1 + 0x1p-52), -52);
    }
};

} // namespace exact_integer_test

TEST_CLASS(exact_integer_test::IntegerTest, None)
#include "tests/clipping/exact/integer_test.moc"
