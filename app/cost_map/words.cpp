// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cost_map/words.h"

#include "app/base/numbers.h"
#include "app/base/text.h"

namespace app {

namespace {

/// Without the measure's name, which the text has already.
QString bareCost(const CostMeasure& measure, double cost)
{
    return measure.isTime() ? costText(measure, cost) : countText(std::size_t(cost));
}

QString endName(FixedEnd end)
{
    return end == FixedEnd::End1 ? Text::tr("End 1") : Text::tr("End 2");
}

FixedEnd other(FixedEnd end) { return end == FixedEnd::End1 ? FixedEnd::End2 : FixedEnd::End1; }

QString coordinatesText(const Point& point)
{
    return Text::tr("%1; %2", "coordinates").arg(shortText(point.x), shortText(point.y));
}

} // namespace

QString namesOf(const CostPlan& plan, std::uint32_t cheapest)
{
    QStringList names;
    for (std::size_t i = 0; i < plan.variants.size(); ++i)
        if (cheapest >> i & 1)
            names << nameOf(plan.variants[i]);
    return names.join(QStringLiteral(" = "));
}

QString titleOf(const CostPlan& plan)
{
    const QString moving = endName(other(plan.end)), measure = plan.measure->name;
    return plan.shown ? Text::tr("%1: %2 for each position of %3")
                            .arg(nameOf(*plan.shown), measure.toLower(), moving)
                      : Text::tr("Cheapest algorithm for each position of %2, by %1")
                            .arg(measure.toLower(), moving);
}

QString costWords(const CostPlan& plan, const Point& end)
{
    const clipping::Segment line = plan.lineTo(end);
    const Cheapest best = cheapestOf(plan, line);
    const QString winner = Text::tr("%1 %2", "algorithm and its cost")
                               .arg(namesOf(plan, best.which), bareCost(*plan.measure, best.cost));
    if (plan.shown)
        return Text::tr("%1 here; cheapest: %2")
            .arg(costText(*plan.measure, costOf(*plan.shown, *plan.measure, line, plan.window)),
                 winner);
    return Text::tr("Cheapest here: %1").arg(winner);
}

QString placesOf(const CostPlan& plan)
{
    return Text::tr("%1 is fixed at %2; the clip window is (%3) to (%4).")
        .arg(endName(plan.end), coordinatesText(plan.fixed), coordinatesText(plan.window.min),
             coordinatesText(plan.window.max));
}

QString noteOf(const CostMeasure& measure)
{
    if (measure.isTime())
        return Text::tr(
            "The median processor time of 5 rounds, each of which clips the same line 64 times. It "
            "is noisy, and shorter than among other lines, because the processor predicts the "
            "branches. Differences within 10 % count as ties.");
    if (&measure == &costMeasures().front())
        return Text::tr("Operations: comparisons, additions and subtractions, "
                        "multiplications, divisions.");
    return {};
}

} // namespace app
