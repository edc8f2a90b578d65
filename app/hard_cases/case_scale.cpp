// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hard_cases/case_scale.h"

#include "app/base/finite.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

namespace {

using Real = long double;
struct Place {
    Real x, y;
};

constexpr Real mostSpan = 12;       // the largest extent of a true scale, in windows
constexpr Real leastGap = 1 / 1e4L; // share of the extent: smaller gaps cannot be seen

Place placeOf(const glm::dvec2& p) { return {p.x, p.y}; }
/// One end may be infinitely far away; it then lies beyond all other numbers.
bool isAnywhere(const glm::dvec2& p) { return !std::isnan(p.x) && !std::isnan(p.y); }

/// Adds the points where a line that misses the window crosses the infinite lines of its edges, in
/// order.
void addCrossings(std::vector<Place>& way, const clipping::Segment& s, const clipping::Window& w)
{
    const Place a = placeOf(s.a), d{Real(s.b.x) - s.a.x, Real(s.b.y) - s.a.y};
    std::vector<std::pair<Real, Place>> crossings;
    const auto add = [&](Real t, Place place) {
        if (t > 0 && t < 1 && std::isfinite(place.x) && std::isfinite(place.y))
            crossings.emplace_back(t, place);
    };
    for (const Real x : {Real(w.min.x), Real(w.max.x)})
        if (d.x != 0)
            add((x - a.x) / d.x, {x, a.y + (x - a.x) / d.x * d.y});
    for (const Real y : {Real(w.min.y), Real(w.max.y)})
        if (d.y != 0)
            add((y - a.y) / d.y, {a.x + (y - a.y) / d.y * d.x, y});
    std::ranges::sort(crossings, {}, [](const auto& crossing) { return crossing.first; });
    for (const auto& [t, place] : crossings)
        way.push_back(place);
}

std::vector<Place> wayOf(const HardCase& hard)
{
    const auto& [a, b] = hard.line;
    if (!isAnywhere(a) || !isAnywhere(b))
        return {};
    std::vector<Place> way{placeOf(a)};
    if (hard.visible) {
        way.push_back(placeOf(hard.visible->a));
        way.push_back(placeOf(hard.visible->b));
    } else if (isFinite(a) && isFinite(b)) {
        addCrossings(way, hard.line, hard.window);
    }
    way.push_back(placeOf(b));
    return way;
}

} // namespace

CaseScale::CaseScale(const HardCase& hard, const CaseAnswer* answer)
{
    const std::vector<Place> way = wayOf(hard);
    std::vector<Place> all = way;
    for (const auto& p : {hard.window.min, hard.window.max, hard.line.a, hard.line.b})
        if (isAnywhere(p))
            all.push_back(placeOf(p));
    if (answer && answer->visible)
        for (const auto& p : {answer->visible->a, answer->visible->b})
            if (isFinite(p))
                all.push_back(placeOf(p));
    for (const Place& place : all) {
        x_.levels.push_back(place.x);
        y_.levels.push_back(place.y);
    }
    for (Axis* axis : {&x_, &y_}) {
        std::ranges::sort(axis->levels);
        axis->levels.erase(std::unique(axis->levels.begin(), axis->levels.end()),
                           axis->levels.end());
    }
    spread(hard);
    for (const Place& place : way)
        way_.emplace_back(x_.at(place.x), y_.at(place.y));
}

void CaseScale::spread(const HardCase& hard)
{
    if (x_.levels.empty())
        return;
    const auto& [min, max] = hard.window;
    const Real span =
        std::max(x_.levels.back() - x_.levels.front(), y_.levels.back() - y_.levels.front());
    const Real window = std::max(std::abs(Real(max.x) - min.x), std::abs(Real(max.y) - min.y));
    isToScale_ = std::isfinite(span) && !(span > mostSpan * window && window > 0);
    for (const Axis* axis : {&x_, &y_})
        for (std::size_t i = 1; i < axis->levels.size(); ++i)
            isToScale_ = isToScale_ && axis->levels[i] - axis->levels[i - 1] >= leastGap * span;
    if (!isToScale_) {
        rank(x_, min.x, max.x);
        rank(y_, min.y, max.y);
        return;
    }
    for (Axis* axis : {&x_, &y_}) {
        const Real middle = axis->levels.front() / 2 + axis->levels.back() / 2;
        for (const Real level : axis->levels)
            axis->shares.push_back(span > 0 ? 0.5 + double((level - middle) / span) : 0.5);
    }
}

/// Keeps only the order; the window takes a good part of the picture.
void CaseScale::rank(Axis& axis, double low, double high) const
{
    const auto inside = [&](std::size_t i) {
        return axis.levels[i - 1] >= low && axis.levels[i] <= high;
    };
    int within = 0;
    for (std::size_t i = 1; i < axis.levels.size(); ++i)
        within += inside(i) ? 1 : 0;
    double place = 0;
    axis.shares = {0};
    for (std::size_t i = 1; i < axis.levels.size(); ++i)
        axis.shares.push_back(place += inside(i) ? std::max(1.0, 2.0 / within) : 1);
    for (double& share : axis.shares)
        share = place > 0 ? share / place : 0.5;
}

double CaseScale::Axis::at(Real level) const
{
    const auto next = std::ranges::lower_bound(levels, level);
    if (next == levels.end())
        return shares.empty() ? 0.5 : shares.back();
    const auto i = std::size_t(next - levels.begin());
    if (i == 0 || *next == level)
        return shares[i];
    const Real part = (level - levels[i - 1]) / (levels[i] - levels[i - 1]);
    return shares[i - 1] + double(part) * (shares[i] - shares[i - 1]);
}

QRectF CaseScale::extent() const
{
    if (x_.shares.empty())
        return {0, 0, 1, 1};
    return QRectF(QPointF(x_.shares.front(), y_.shares.front()),
                  QPointF(x_.shares.back(), y_.shares.back()));
}

QPointF CaseScale::at(const glm::dvec2& point) const { return {x_.at(point.x), y_.at(point.y)}; }

} // namespace app
