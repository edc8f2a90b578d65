// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/number.h"
#include "app/formats/coordinates.h"

#include <QTest>

#include <bit>
#include <cmath>
#include <random>

#include "tests/test_class.h"

namespace base_number_test {

namespace {

constexpr double all = std::numeric_limits<double>::infinity();

std::string text(double number)
{
    std::string result;
    app::appendNumber(result, number);
    return result;
}

std::string text(double number, int precision, double low = -all, double high = all)
{
    std::string result;
    app::appendNumber(result, number, precision, low, high);
    return result;
}

// strtod is not what the code under test uses.
double value(const std::string& decimals) { return std::strtod(decimals.c_str(), nullptr); }

} // namespace

class NumberTest : public QObject {
    Q_OBJECT

private slots:
    void aRectangleIsItsFourNumbers()
    {
        const auto rectangle = [](double xmin, double ymin, double xmax, double ymax) {
            return app::rectangleText({{xmin, ymin}, {xmax, ymax}});
        };
        QCOMPARE(rectangle(-100, -75, 100, 75), "-100,-75,100,75");
        QCOMPARE(rectangle(-0.0, 0.1, 1e21, 2.5), "0,0.1,1000000000000000000000,2.5");
    }
    void wholeTextOfANumber()
    {
        QCOMPARE(text(0.1), "0.1");
        QCOMPARE(text(-0.0), "0");
        QCOMPARE(text(1e21), "1000000000000000000000");
        QCOMPARE(text(-2.5e-7), "-0.00000025");
        QCOMPARE(text(1.0 / 3), "0.3333333333333333");
        QCOMPARE(text(-0.0004, 3), "0");
        QCOMPARE(text(1.2500001, 1), "1.3");
        QCOMPARE(text(100, 2), "100");
        QCOMPARE(text(7.999, 2), "8");
    }

    void everyNumberReadsBackBitForBit()
    {
        std::mt19937_64 random(1);
        for (int i = 0; i < 200'000; ++i) {
            const double number = std::bit_cast<double>(random());
            if (!std::isfinite(number))
                continue;
            const std::string decimals = text(number);
            QCOMPARE(std::bit_cast<quint64>(value(decimals)), std::bit_cast<quint64>(number));
            QVERIFY(decimals.find_first_of("eE+") == decimals.npos);
            QCOMPARE(app::parseNumber(decimals).value(), number);
        }
    }

    void roundedNumbersMoveInward()
    {
        QCOMPARE(text(9.99, 1, 0, 9.99), "9.9");
        QCOMPARE(text(1.5, 0, 0, 1.5), "1");
        QCOMPARE(text(-1.5, 0, -1.5, 0), "-1");
        QCOMPARE(text(2.5, 0, 2.5, 9), "3");
        QCOMPARE(text(0.04, 1, 0.04, 1), "0.1");
        QCOMPARE(text(0.25, 1, 0.24, 0.26), "0.2"); // thinner than a decimal: the nearest
        QCOMPARE(text(10, 2, 0, 10), "10");
    }

    // Against a search over all the decimals near the number.
    void roundedNumbersAreTheNearestInside()
    {
        std::mt19937_64 random(2);
        std::uniform_real_distribution<double> anywhere(-3, 3);
        for (int i = 0; i < 20'000; ++i) {
            const int precision = int(random() % 4);
            const double step = std::pow(10, -precision);
            double low = anywhere(random), high = anywhere(random);
            if (random() % 3 == 0)
                low = std::round(low / step) * step;
            if (random() % 3 == 0)
                high = (std::round(high / step) + 0.5) * step;
            if (low > high)
                std::swap(low, high);
            const double number = low + (high - low) * double(random() % 101) / 100;
            double nearest = all;
            for (long k = std::lround(number / step) - 3; k <= std::lround(number / step) + 3;
                 ++k) {
                const double candidate =
                    value(QByteArray::number(double(k) * step, 'f', precision).toStdString());
                if (candidate >= low && candidate <= high)
                    nearest = std::min(nearest, std::abs(candidate - number));
            }
            const double got = value(text(number, precision, low, high));
            const QByteArray input = QByteArray::number(number, 'g', 17) + " in "
                                     + QByteArray::number(low, 'g', 17) + ".."
                                     + QByteArray::number(high, 'g', 17) + " precision "
                                     + QByteArray::number(precision);
            if (nearest == all)
                continue; // none is inside
            QVERIFY2(got >= low && got <= high, input);
            QVERIFY2(std::abs(got - number) <= nearest + 1e-12, input);
        }
    }

    void extremesNeitherOverflowNorHang()
    {
        QCOMPARE(value(text(1e308, 400)), 1e308);
        QCOMPARE(value(text(5e-324, 5000)), 5e-324);
        QCOMPARE(value(text(-1.7e308, 3, -1.7e308, 0)), -1.7e308);
    }

    void parsesWholeFiniteTextsOnly()
    {
        QCOMPARE(app::parseNumber("+1.5e3").value(), 1500.0);
        for (const char* bad : {"", " 1", "1 ", "nan", "inf", "1e400", "1,5", "0x10", "--1", "+-1"})
            QVERIFY2(!app::parseNumber(bad), bad);
    }
};

} // namespace base_number_test

TEST_CLASS(base_number_test::NumberTest, None)
#include "tests/app/base/number_test.moc"
