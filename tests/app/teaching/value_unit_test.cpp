// SPDX-License-Identifier: GPL-3.0-or-later
// The unit of every number in a trace, checked by scaling and by moving the plane.
#include "app/teaching/teaching.h"
#include "app/teaching/value_unit.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "tests/test_class.h"

namespace teaching_value_unit_test {

namespace {

using app::Variant;
using Point = glm::dvec2;
using app::ValueUnit;

constexpr clipping::Window window{{-100, -75}, {100, 75}};

std::vector<clipping::Segment> lines()
{
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> anywhere(-250, 250);
    std::vector<clipping::Segment> all;
    while (all.size() < 400) {
        const Point a(anywhere(random), anywhere(random));
        all.push_back({a, {anywhere(random), anywhere(random)}});
    }
    return all;
}

// An algorithm without its own sentences and units shows its numbers without units.
std::vector<Variant> toldVariants()
{
    auto all = app::variants();
    std::erase_if(all, [](const Variant& variant) {
        const app::Teaching row = app::teachingOf(*variant.algorithm);
        return variant.misprint || (row.sentence == app::generalSentence && row.variables.empty());
    });
    return all;
}

std::vector<clipping::Step> stepsOf(const Variant& variant, const clipping::Segment& line,
                                    double size, const Point& by)
{
    const auto moved = [&](const Point& p) { return p * size + by; };
    return clipping::functionsOf(*variant.algorithm, variant.form)
        ->trace({moved(line.a), moved(line.b)}, {moved(window.min), moved(window.max)})
        .steps;
}

/// Calls of(name, number, the same number there) for each number that is told of a line.
void forEachNumber(const Variant& variant, const clipping::Segment& line, double size,
                   const Point& by, const auto& of)
{
    const auto here = stepsOf(variant, line, 1, {}), there = stepsOf(variant, line, size, by);
    for (std::size_t i = 0; i < std::min(here.size(), there.size()); ++i) {
        if (here[i].label != there[i].label || here[i].values.size() != there[i].values.size())
            return; // rounding has led it another way
        for (std::size_t k = 0; k < here[i].values.size(); ++k)
            if (const auto& value = here[i].values[k]; value.kind == clipping::ValueKind::Number)
                of(value.name, value.value, there[i].values[k].value);
    }
}

QByteArray said(const Variant& variant, std::string_view name, double here, double there)
{
    return QStringLiteral("%1 tells %2 = %3, and %4 there")
        .arg(app::keyOf(variant))
        .arg(QLatin1StringView(name.data(), qsizetype(name.size())))
        .arg(here, 0, 'g', 17)
        .arg(there, 0, 'g', 17)
        .toUtf8();
}

bool isAmong(std::optional<ValueUnit> unit, std::initializer_list<ValueUnit> units)
{
    return unit && std::ranges::find(units, *unit) != units.end();
}

} // namespace

class ValueUnitTest : public QObject {
    Q_OBJECT

private slots:
    void everyNumberInATraceHasAUnit()
    {
        for (const Variant& variant : toldVariants())
            for (const auto& line : lines())
                forEachNumber(variant, line, 1, {}, [&](auto name, double here, double there) {
                    QVERIFY2(app::unitOfValue(variant, name), said(variant, name, here, there));
                });
    }
    /// In a plane of four times the size a length is four times as long: exactly, for 4 is a power
    /// of two.
    void unitsAreThoseOfALargerPlane()
    {
        std::size_t lengths = 0, areas = 0;
        for (const Variant& variant : toldVariants())
            for (const auto& line : lines())
                forEachNumber(variant, line, 4, {}, [&](auto name, double here, double there) {
                    const auto unit = app::unitOfValue(variant, name);
                    const bool isArea = isAmong(unit, {ValueUnit::Area, ValueUnit::FixedArea});
                    const double scale = isArea ? 16 : isAmong(unit, {ValueUnit::Bare}) ? 1 : 4;
                    QVERIFY2(there == here * scale, said(variant, name, here, there));
                    lengths += scale == 4, areas += isArea;
                });
        QVERIFY(lengths > 10'000 && areas > 5'000);
    }
    /// In a plane that is moved, places move with it, and all else stays but for what is fixed.
    void placesMoveWithThePlane()
    {
        const Point by(3, -5);
        std::set<std::string_view> fixed;
        for (const Variant& variant : toldVariants())
            for (const auto& line : lines())
                forEachNumber(variant, line, 1, by, [&](auto name, double here, double there) {
                    const auto unit = app::unitOfValue(variant, name);
                    const double way = isAmong(unit, {ValueUnit::X})   ? by.x
                                       : isAmong(unit, {ValueUnit::Y}) ? by.y
                                                                       : 0;
                    const bool asSaid =
                        std::abs(there - here - way) <= 1e-6 * std::max(1.0, std::abs(here));
                    if (isAmong(unit, {ValueUnit::FixedLength, ValueUnit::FixedArea})) {
                        if (!asSaid)
                            fixed.insert(name);
                    } else if (!isAmong(unit, {ValueUnit::Turned}))
                        QVERIFY2(asSaid, said(variant, name, here, there));
                });
        QVERIFY(fixed == (std::set<std::string_view>{"c", "ew[n]", "pw", "x", "y"}));
    }
};

} // namespace teaching_value_unit_test

TEST_CLASS(teaching_value_unit_test::ValueUnitTest, None)
#include "tests/app/teaching/value_unit_test.moc"
