// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/guide_drag.h"

#include "app/base/numbers.h"
#include "app/commands/set_page_parts.h"
#include "app/drawing/transformation.h"
#include "ui/look/text.h"
#include "ui/tools/shape_drawing.h"

#include <cmath>

namespace ui {
namespace {

constexpr double guideReach = 4; // pixels

const std::vector<app::Guide>& guidesOf(const Workbench& bench)
{
    return bench.session.now().page().guides.list;
}

void push(app::Guides guides, const QString& text, Workbench& bench)
{
    bench.session.history.push(new app::SetGuides(bench.session.document, std::move(guides), text));
}

} // namespace

std::optional<std::size_t> GuideDrag::guideAt(const app::Point& screen, const Workbench& bench)
{
    if (!bench.guides())
        return std::nullopt;
    std::optional<std::size_t> found;
    double nearest = guideReach;
    for (std::size_t i = 0; i < guidesOf(bench).size(); ++i) {
        const auto& [axis, at] = guidesOf(bench)[i];
        const double apart = std::abs(bench.view.toScreen(app::Point(at))[axis] - screen[axis]);
        if (apart <= nearest) {
            nearest = apart;
            found = i;
        }
    }
    return found;
}

const app::Guide* GuideDrag::chosen(const Workbench& bench)
{
    const auto guide = bench.session.guide;
    return bench.guides() && guide && *guide < guidesOf(bench).size() ? &guidesOf(bench)[*guide]
                                                                      : nullptr;
}

void GuideDrag::start(int axis)
{
    now_ = app::Guide{axis, std::nan("")}; // nowhere, until the pointer is over the drawing
    old_.reset();
    screen_ = app::Point(-1);
}

void GuideDrag::start(std::size_t guide, const Workbench& bench)
{
    now_ = guidesOf(bench)[guide];
    old_ = guide;
    screen_ = bench.view.toScreen(app::Point(now_->at));
}

void GuideDrag::proceed(const Pointer& pointer, Workbench&)
{
    now_->at = pointer.position[now_->axis];
    screen_ = pointer.screen;
}

bool GuideDrag::finish(const Pointer& pointer, Workbench& bench)
{
    proceed(pointer, bench);
    finish(bench);
    return true;
}

void GuideDrag::finish(Workbench& bench)
{
    const double at = screen_[now_->axis];
    if (at >= 0 && at <= bench.view.size[now_->axis])
        return put(now_->at, bench);
    now_.reset();
    if (old_)
        remove(*old_, bench);
}

void GuideDrag::put(double at, Workbench& bench)
{
    app::Guides guides{guidesOf(bench)};
    const int axis = now_->axis;
    now_.reset();
    if (old_ && *old_ >= guides.list.size())
        return; // removed meanwhile
    if (!old_ && guides.list.size() == app::Guides::most) {
        emit bench.session.refused(
            Text::tr("The page has 1,000 guides already. Remove some first."));
        return;
    }
    const std::size_t number = old_.value_or(guides.list.size());
    bench.session.guide = number;
    if (old_ && guides.list[*old_].at == at)
        return;
    if (old_)
        guides.list[*old_].at = at;
    else
        guides.list.push_back({axis, at});
    push(std::move(guides), old_ ? Text::tr("Move guide") : Text::tr("Add guide"), bench);
    bench.session.guide = number;
}

void GuideDrag::remove(std::size_t guide, Workbench& bench)
{
    app::Guides guides{guidesOf(bench)};
    if (guide >= guides.list.size())
        return;
    guides.list.erase(guides.list.begin() + std::ptrdiff_t(guide));
    bench.session.guide.reset();
    push(std::move(guides), Text::tr("Remove guide"), bench);
}

std::optional<app::Gauge> GuideDrag::gauge(const Workbench& bench) const
{
    const app::Guide* guide = now_ ? &*now_ : chosen(bench);
    if (!guide)
        return std::nullopt;
    const auto along = guide->axis == 0 ? app::Along::X : app::Along::Y;
    app::Gauge gauge = gaugeOfStart(bench);
    gauge.measure = &app::moveMeasure(along);
    if (!now_) {
        const app::Point at(guide->at);
        gauge.aim = app::GestureEnd{at, gauge.measure->values(gauge.start, at)};
    }
    return gauge;
}

QString GuideDrag::hint(const Workbench& bench) const
{
    const app::Guide* guide = now_ ? &*now_ : chosen(bench);
    if (!guide || std::isnan(guide->at))
        return {};
    const app::Gauge start = gaugeOfStart(bench);
    const QString place = (guide->axis == 0 ? QStringLiteral("x ") : QStringLiteral("y "))
                          + app::lengthText(guide->at - start.origin[guide->axis], start.scale.unit,
                                            start.scale.millimetresPerUnit);
    return Text::tr("Guide at %1. Drag it, or Enter and another position. Delete, or drag it out: "
                    "remove.")
        .arg(place);
}

void GuideDrag::accept(const app::GestureEnd& end, Workbench& bench)
{
    if (!now_) {
        if (!chosen(bench))
            return;
        start(*bench.session.guide, bench);
    }
    put(end.point[now_->axis], bench);
}

void GuideDrag::paint(QPainter& painter, const Workbench& bench) const
{
    if (const app::Guide* guide = now_ ? &*now_ : chosen(bench))
        paintGuide(painter, bench, *guide, 2);
}

void paintGuide(QPainter& painter, const Workbench& bench, const app::Guide& guide, double width)
{
    const double ratio = painter.device()->devicePixelRatioF();
    const double at =
        std::floor(bench.view.toScreen(app::Point(guide.at))[guide.axis] * ratio) / ratio;
    if (!(at >= -width && at <= bench.view.size[guide.axis]))
        return;
    const QRectF line = guide.axis == 0 ? QRectF(at, 0, width, bench.view.size.y)
                                        : QRectF(0, at, bench.view.size.x, width);
    painter.fillRect(line, bench.look.guide);
}

} // namespace ui
