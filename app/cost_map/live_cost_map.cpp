// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cost_map/live_cost_map.h"

#include <algorithm>

namespace app {

namespace {

constexpr std::size_t sliceCells = 256; // between two readings of the stop token
constexpr std::chrono::milliseconds atOnce{8};

CostPlan coarse(CostPlan plan)
{
    plan.columns = std::max(1, plan.columns / LiveCostMap::coarseness);
    plan.rows = std::max(1, plan.rows / LiveCostMap::coarseness);
    return plan;
}

} // namespace

LiveCostMap::LiveCostMap(QObject* parent) : QObject(parent) {}

void LiveCostMap::ask(const std::optional<CostPlan>& plan)
{
    if (plan == asked_)
        return;
    asked_ = plan;
    background_.cancel();
    if (!plan) {
        map_.reset();
        emit changed();
        return;
    }
    compute(coarse(*plan));
    background_.waitFor(atOnce);
}

bool LiveCostMap::upToDate() const
{
    return !asked_ || (map_ && map_->complete() && map_->plan == *asked_);
}

void LiveCostMap::compute(const CostPlan& plan)
{
    background_.start(
        [map = CostMap{plan}](const Follower& follower) mutable {
            while (!map.complete() && !follower.stop.stop_requested())
                map = extended(std::move(map), sliceCells);
            return std::move(map);
        },
        [this](CostMap whole) { show(std::move(whole)); });
}

void LiveCostMap::show(CostMap map)
{
    map_ = std::move(map);
    if (!upToDate())
        compute(*asked_);
    emit changed();
}

void LiveCostMap::finish()
{
    while (!upToDate())
        background_.wait();
}

} // namespace app

#include "moc_live_cost_map.cpp"
