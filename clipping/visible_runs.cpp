// SPDX-License-Identifier: MIT
#include "clipping/visible_runs.h"

#include "clipping/gradual_underflow.h"
#include "clipping/ieee_numbers.h"
#include "clipping/limits.h"
#include "clipping/polyline_runs.h"

#include <memory>

namespace clipping {

template <class T>
BasicVisibleRuns<T>::BasicVisibleRuns(const BasicPolyline<T>& polyline,
                                      const BasicWindow<T>& window)
{
    requireRoom(polyline.points.size(), polyline.points.size());
    const GradualUnderflow here;
    auto found = std::make_unique<BasicPolylineRuns<T>>();
    findRuns(polyline.points, polyline.closed, window, *found);
    runs_ = found.release();
}

template <class T>
BasicVisibleRuns<T>::~BasicVisibleRuns()
{
    delete runs_;
}

template <class T>
std::size_t BasicVisibleRuns<T>::size() const noexcept
{
    return runs_ ? runs_->runs.size() : 0;
}

template <class T>
auto BasicVisibleRuns<T>::operator[](std::size_t i) const noexcept -> std::span<const Point>
{
    const VisibleRun& run = runs_->runs[i];
    return {runs_->points.data() + run.first, run.count};
}

template <class T>
const VisibleRun& BasicVisibleRuns<T>::run(std::size_t i) const noexcept
{
    return runs_->runs[i];
}

template class BasicVisibleRuns<double>;
template class BasicVisibleRuns<float>;

} // namespace clipping
