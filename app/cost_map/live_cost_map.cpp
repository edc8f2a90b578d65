// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cost_map/live_cost_map.h"

#include <QElapsedTimer>

#include <algorithm>

namespace app {

namespace {

constexpr std::size_t sliceCells = 256;
constexpr qint64 sliceMilliseconds = 8;

CostPlan coarse(CostPlan plan)
{
    plan.columns = std::max(1, plan.columns / LiveCostMap::coarseness);
    plan.rows = std::max(1, plan.rows / LiveCostMap::coarseness);
    return plan;
}

} // namespace

LiveCostMap::LiveCostMap(QObject* parent) : QObject(parent)
{
    connect(&work_, &QTimer::timeout, this, &LiveCostMap::work);
}

void LiveCostMap::ask(const std::optional<CostPlan>& plan)
{
    if (plan == asked_)
        return;
    asked_ = plan;
    growing_.reset();
    work_.stop();
    if (!plan) {
        map_.reset();
        emit changed();
        return;
    }
    growing_ = CostMap{coarse(*plan)};
    work_.start(0);
    work();
}

bool LiveCostMap::upToDate() const
{
    return !asked_ || (map_ && map_->complete() && map_->plan == *asked_);
}

void LiveCostMap::show(CostMap map)
{
    map_ = std::move(map);
    emit changed();
}

void LiveCostMap::work()
{
    QElapsedTimer clock;
    clock.start();
    while (!growing_->complete() && clock.elapsed() < sliceMilliseconds)
        growing_ = extended(std::move(*growing_), sliceCells);
    if (growing_->complete()) {
        CostMap whole = *std::exchange(growing_, std::nullopt);
        const bool fine = whole.plan == *asked_;
        if (fine)
            work_.stop();
        else
            growing_ = CostMap{*asked_};
        show(std::move(whole));
    }
}

void LiveCostMap::finish()
{
    while (!upToDate())
        work();
}

} // namespace app
