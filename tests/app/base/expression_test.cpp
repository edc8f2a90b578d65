// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/expression.h"

#include <QTest>

#include <cmath>
#include <random>

#include "tests/test_class.h"

namespace base_expression_test {

using namespace app;

class ExpressionTest : public QObject {
    Q_OBJECT

private slots:
    void valuesAreThoseOfArithmetic_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<Unit>("unit");
        QTest::addColumn<double>("value");
        const auto row = [](const char* text, Unit unit, double value) {
            QTest::addRow("%s", text) << QString(text) << unit << value;
        };
        row("25", Unit::Mm, 25);
        row("-3.5", Unit::Mm, -3.5);
        row("+7", Unit::Mm, 7);
        row(" .5 ", Unit::Mm, 0.5);
        row("10+5", Unit::Mm, 15);
        row("10 - 5 - 2", Unit::Mm, 3);
        row("2+3*4", Unit::Mm, 14);
        row("(2+3)*4", Unit::Mm, 20);
        row("100/8/2", Unit::Mm, 6.25);
        row("10--5", Unit::Mm, 15);
        row("-(1+2)*-3", Unit::Mm, 9);
        row("1in", Unit::Mm, 25.4);
        row("2 in", Unit::Inch, 2);
        row("3*25mm", Unit::Mm, 75);
        row("25mm*3", Unit::Cm, 7.5);
        row("1in+5", Unit::Mm, 30.4); // the 5 is in the unit of the field
        row("5+1in", Unit::Mm, 30.4);
        row("1in-1in", Unit::Mm, 0);
        row("(10+5mm)*2", Unit::Mm, 30);
        row("2*(1cm+1mm)", Unit::Mm, 22);
        row("30mm/10mm", Unit::Mm, 3);
        row("10cm/4", Unit::Mm, 25);
        row("1/2in", Unit::Inch, 0.5);
        row("1/2in", Unit::Mm, 12.7);
        row("1e2", Unit::Mm, 100);
        row("96px", Unit::Inch, 1);
        row("72pt", Unit::Mm, 25.4);
        row("5mm", Unit::User, 2.5); // of 2 mm each
    }
    void valuesAreThoseOfArithmetic()
    {
        QFETCH(QString, text);
        QFETCH(Unit, unit);
        QFETCH(double, value);
        const auto result = evaluated(text.toStdString(), {unit, 2});
        QVERIFY2(result, qPrintable(result.error));
        QVERIFY2(std::abs(*result.value - value) <= 1e-14 * std::abs(value),
                 qPrintable(QString::number(*result.value, 'g', 17)));
    }
    void wholeNumbersAndTheOwnUnitStayExact()
    {
        for (const UnitInfo& unit : units())
            if (unit.millimetres > 0)
                for (const double value : {0.1, 1.0 / 3, 25.4, 1e7}) {
                    const std::string text =
                        QString::number(value, 'g', 17).toStdString() + std::string(unit.suffix);
                    QCOMPARE(*evaluated(text, {unit.unit, 1}).value, value);
                }
    }
    void whatIsWrongIsSaid_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("why");
        const auto row = [](const char* text, const char* why) {
            QTest::addRow("%s", text) << QString::fromUtf8(text) << QString::fromUtf8(why);
        };
        row("", "the sum ends without a number");
        row("10+", "the sum ends without a number");
        row("(10+5", "a “)” is missing");
        row("10+5)", "“)” is not expected there");
        row("10 5", "“5” is not a unit of length here");
        row("ten", "“ten” is not a number");
        row("10*/5", "“/” is not a number");
        row("5parsec", "“parsec” is not a unit of length here");
        row("50%", "“%” is not a unit of length here");
        row("2mm*3mm", "a length times a length is an area");
        row("1/0", "division by zero");
        row("1/(2-2)", "division by zero");
        row("1e999", "a number is too large");
        row("1e300*1e300", "its result is too large");
        row("1ü", "“ü” is not a unit of length here");
        row("nan", "“nan” is not a number");
        row("inf", "“inf” is not a number");
        row("-", "the sum ends without a number");
    }
    void whatIsWrongIsSaid()
    {
        QFETCH(QString, text);
        QFETCH(QString, why);
        const auto result = evaluated(text.toStdString(), {Unit::Mm, 1});
        QVERIFY(!result);
        QCOMPARE(result.error, why);
    }
    void noTextHarms()
    {
        QVERIFY(!evaluated(std::string(100'000, '('), {Unit::Mm, 1}));
        QVERIFY(!evaluated(std::string(199, '-'), {Unit::Mm, 1}));
        std::mt19937 random(1);
        const std::string_view signs = "0123456789.+-*/() mincpxte%\xc3\xbc";
        for (int i = 0; i < 20'000; ++i) {
            std::string text(random() % 30, ' ');
            for (char& c : text)
                c = signs[random() % signs.size()];
            const auto result = evaluated(text, {Unit::Mm, 1});
            QVERIFY2(result ? std::isfinite(*result.value) : !result.error.isEmpty(), text.c_str());
        }
    }
};

} // namespace base_expression_test

TEST_CLASS(base_expression_test::ExpressionTest, Gui)
#include "tests/app/base/expression_test.moc"
