// SPDX-License-Identifier: GPL-3.0-or-later
// Measures what the panels of Learn compute: cost maps, coarse as while an end is dragged and fine,
// and the exactness of 100,000 lines of the paper's scene. Processor time, the median of 5.
#include "app/base/clock.h"
#include "app/cost_map/live_cost_map.h"
#include "app/exactness/exactness.h"
#include "app/experiment/paper_scene.h"

#include <QTextStream>

#include <algorithm>
#include <vector>

namespace {

template <class Work>
double milliseconds(const Work& work)
{
    static const app::Clock clock = app::processorClock();
    std::vector<double> times;
    for (int i = 0; i < 5; ++i) {
        const double before = clock.nanoseconds();
        work();
        times.push_back((clock.nanoseconds() - before) / 1e6);
    }
    std::ranges::sort(times);
    return times[times.size() / 2];
}

app::CostPlan planOf(const std::optional<app::Variant>& shown, int cells)
{
    app::CostPlan plan = app::usualCostPlan(app::paperWindow);
    plan.shown = shown;
    plan.columns = 4 * cells;
    plan.rows = 3 * cells;
    return plan;
}

} // namespace

int main()
{
    QTextStream out(stdout);
    constexpr int fine = 60, coarse = fine / app::LiveCostMap::coarseness;
    const auto row = [&](const QString& name, const std::optional<app::Variant>& shown) {
        out << name.leftJustified(24) << Qt::fixed << qSetRealNumberPrecision(2)
            << milliseconds([&] { app::costMap(planOf(shown, coarse)); }) << " ms coarse, "
            << milliseconds([&] { app::costMap(planOf(shown, fine)); }) << " ms fine (240 x 180)\n";
        out.flush();
    };
    for (const app::Variant& variant : app::costVariants(clipping::Form::Corrected))
        row(app::nameOf(variant), variant);
    row(QStringLiteral("which is cheapest"), std::nullopt);

    std::vector<clipping::Segment> lines(100'000);
    app::PaperScene(1).fill(lines);
    for (const char* key : {"exact", "md", "lb:published"}) {
        const double time = milliseconds([&] {
            app::extended({app::paperWindow}, *app::findVariant(QString::fromLatin1(key)), lines);
        });
        out << key << ": judged 100,000 lines in " << time << " ms\n";
    }
}
