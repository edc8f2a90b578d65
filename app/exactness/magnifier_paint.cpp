// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exactness/magnifier_paint.h"

#include "app/base/number.h"
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/exactness/error_class.h"

#include <QFontMetricsF>
#include <QPainter>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double roomy = 56;        // initial distance between two numbers in pixels
constexpr double leastDistance = 5; // pixels; closer numbers are not drawn separately
constexpr double mostPixelsPerUlp = 600, labelGap = 12;

double largestDistance(const glm::dvec2& p) { return std::max(std::abs(p.x), std::abs(p.y)); }

/// Limits the scale to a range in which something is visible.
double bounded(double pixelsPerUnit, const Magnified& seen)
{
    const double finest = std::max(std::min(seen.ulp.x, seen.ulp.y), 1e-290);
    const glm::dvec2 extent = seen.window.max - seen.window.min;
    const double coarsest = std::max({extent.x, extent.y, seen.largestUlp * 64, finest});
    return std::clamp(pixelsPerUnit, 40 / coarsest, mostPixelsPerUlp / finest);
}

/// Paints the parts of the picture at their places.
class Stage {
public:
    Stage(QPainter& painter, const QRectF& area, const Magnified& seen, const MagnifierView& view,
          const MagnifierLook& look)
        : painter_(painter), area_(area), seen_(seen), view_(view), look_(look),
          origin_(area.center() + view.middle)
    {
    }

    QPointF at(const glm::dvec2& offset) const
    {
        return origin_ + QPointF(offset.x, offset.y) * view_.pixelsPerUnit;
    }

    void paintGround()
    {
        painter_.fillRect(area_, look_.outside);
        const QRectF inside(at(bounds(seen_.window.min)), at(bounds(seen_.window.max)));
        painter_.fillRect(inside.intersected(area_), look_.chart.paper);
    }

    /// Returns whether the numbers of both coordinates are drawn separately.
    bool paintLattice()
    {
        const auto xs =
            numbers(seen_.centre.x, area_.left() - origin_.x(), area_.right() - origin_.x());
        const auto ys =
            numbers(seen_.centre.y, area_.top() - origin_.y(), area_.bottom() - origin_.y());
        painter_.setPen(QPen(look_.chart.rule, 1));
        for (const double x : xs)
            painter_.drawLine(QPointF(origin_.x() + x, area_.top()),
                              QPointF(origin_.x() + x, area_.bottom()));
        for (const double y : ys)
            painter_.drawLine(QPointF(area_.left(), origin_.y() + y),
                              QPointF(area_.right(), origin_.y() + y));
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(look_.chart.muted);
        for (const double x : xs)
            for (const double y : ys)
                painter_.drawEllipse(origin_ + QPointF(x, y), 1.6, 1.6);
        return !xs.empty() && !ys.empty();
    }

    void paintEdges()
    {
        const auto& [min, max] = seen_.window;
        edge({at(min).x(), area_.top()}, {at(min).x(), area_.bottom()}, Text::tr("left edge"));
        edge({at(max).x(), area_.top()}, {at(max).x(), area_.bottom()}, Text::tr("right edge"));
        edge({area_.left(), at(min).y()}, {area_.right(), at(min).y()}, Text::tr("top edge"));
        edge({area_.left(), at(max).y()}, {area_.right(), at(max).y()}, Text::tr("bottom edge"));
    }

    void paintLine()
    {
        const QPointF on = at(seen_.onLine), middle = area_.center();
        const double diagonal = std::hypot(area_.width(), area_.height());
        const QPointF away = on - middle;
        if (seen_.direction == glm::dvec2{} || std::hypot(away.x(), away.y()) > 4 * diagonal)
            return;
        const QPointF along = QPointF(seen_.direction.x, seen_.direction.y) * 5 * diagonal;
        painter_.setPen(QPen(look_.chart.text, 1.5));
        painter_.drawLine(on - along, on + along);
    }

    /// Paints the scale of the picture, as a bar of a number of ulps.
    void paintScale(bool latticeSeen)
    {
        const double ulp = std::max(seen_.ulp.x, seen_.ulp.y) * view_.pixelsPerUnit;
        const double times = std::pow(10, std::ceil(std::log10(40 / ulp)));
        const double ulps = std::max(1., std::isfinite(times) ? times : 1.);
        const double length = ulps * ulp;
        const QPointF left(area_.left() + 10, area_.top() + 14);
        const double shown = std::min(length, area_.width() - 20);
        painter_.setPen(QPen(look_.chart.text, 2));
        painter_.drawLine(left, left + QPointF(shown, 0));
        painter_.drawLine(left - QPointF(0, 4), left + QPointF(0, 4));
        painter_.drawLine(left + QPointF(shown, -4), left + QPointF(shown, 4));
        const QString size = shortText(std::max(seen_.ulp.x, seen_.ulp.y) * ulps, 3);
        QString text = Text::tr("%1 = %2").arg(errorText(ulps), size);
        if (!latticeSeen)
            text += view_.lattice == Lattice::Double
                        ? Text::tr("; doubles are too dense here to be drawn one by one")
                        : Text::tr("; floats are too dense or too sparse here to be drawn");
        painter_.setPen(look_.chart.text);
        painter_.drawText(left + QPointF(0, 20), text);
    }

    void paintEnds(const QString& name)
    {
        painter_.setBrush(Qt::NoBrush);
        if (seen_.exactness) {
            painter_.setPen(QPen(look_.chart.text, 1.5));
            const QPointF exactness = at(*seen_.exactness);
            painter_.drawEllipse(exactness, 6, 6);
            painter_.drawLine(exactness - QPointF(10, 0), exactness + QPointF(10, 0));
            painter_.drawLine(exactness - QPointF(0, 10), exactness + QPointF(0, 10));
            label(exactness + QPointF(labelGap, labelGap + 12), Text::tr("true end"),
                  look_.chart.text);
            if (seen_.nearest != glm::dvec2{} || !seen_.returned) {
                const QPointF nearest = at(seen_.nearest);
                painter_.setPen(QPen(look_.chart.muted, 1.5, Qt::DotLine));
                painter_.drawRect(QRectF(nearest - QPointF(7, 7), QSizeF(14, 14)));
                const QString text = Text::tr("nearest double");
                label(nearest + QPointF(-labelGap - width(text), labelGap + 12), text,
                      look_.chart.muted);
            }
        }
        if (seen_.returned)
            paintReturned(name);
    }

private:
    /// Offsets in pixels of the visible numbers; empty if they are too close to each other.
    std::vector<double> numbers(double centre, double from, double to) const
    {
        const double perUnit = view_.pixelsPerUnit;
        auto found = latticeBetween(centre, from / perUnit, to / perUnit, view_.lattice,
                                    std::size_t((to - from) / leastDistance));
        for (double& x : found)
            x *= perUnit;
        return found;
    }

    /// Limits a point so that QPainter gets no huge numbers.
    glm::dvec2 bounds(const glm::dvec2& p) const
    {
        const double most = 1e5 / view_.pixelsPerUnit;
        return {std::clamp(p.x, -most, most), std::clamp(p.y, -most, most)};
    }

    void edge(const QPointF& from, const QPointF& to, const QString& name)
    {
        const bool vertical = from.x() == to.x();
        const double place = vertical ? from.x() : from.y();
        if (place < (vertical ? area_.left() : area_.top())
            || place > (vertical ? area_.right() : area_.bottom()))
            return;
        painter_.setPen(QPen(look_.window, 2));
        painter_.drawLine(from, to);
        label(vertical ? QPointF(place + 5, area_.bottom() - 8)
                       : QPointF(area_.right() - 6 - width(name), place - 5),
              name, look_.window);
    }

    void paintReturned(const QString& name)
    {
        const glm::dvec2 least = seen_.window.min, most = seen_.window.max;
        const bool outside = least.x > 0 || least.y > 0 || most.x < 0 || most.y < 0;
        const QColor colour = outside || !seen_.exactness ? look_.differs : look_.chosen;
        const QPointF end = at({0, 0});
        painter_.setPen(QPen(look_.chart.paper, 1.5));
        painter_.setBrush(colour);
        painter_.drawPolygon(QPolygonF({end + QPointF(0, -7), end + QPointF(7, 0),
                                        end + QPointF(0, 7), end + QPointF(-7, 0)}));
        label(end + QPointF(labelGap, -labelGap), name, colour);
    }

    double width(const QString& text) const
    {
        return QFontMetricsF(look_.chart.font).horizontalAdvance(text);
    }

    /// Paints a text on a background that separates it from lines, inside the picture.
    void label(QPointF at, const QString& text, const QColor& colour)
    {
        if (!area_.adjusted(-width(text), -20, width(text), 20).contains(at))
            return;
        const QFontMetricsF metrics(look_.chart.font);
        at.setX(std::clamp(at.x(), area_.left() + 4, area_.right() - 4 - width(text)));
        at.setY(std::clamp(at.y(), area_.top() + metrics.ascent() + 2, area_.bottom() - 4));
        QColor ground = look_.chart.paper;
        ground.setAlpha(210);
        painter_.fillRect(
            QRectF(at.x() - 2, at.y() - metrics.ascent(), width(text) + 4, metrics.height()),
            ground);
        painter_.setPen(colour);
        painter_.drawText(at, text);
    }

    QPainter& painter_;
    QRectF area_;
    const Magnified& seen_;
    const MagnifierView& view_;
    const MagnifierLook& look_;
    QPointF origin_;
};

} // namespace

MagnifierView usualView(const Magnified& seen, const QSizeF& size)
{
    const double side = std::max(80., std::min(size.width(), size.height()));
    double pixels = roomy / std::max(std::max(seen.ulp.x, seen.ulp.y), 1e-290);
    QPointF middle;
    if (seen.exactness && *seen.exactness != glm::dvec2{}) {
        pixels = std::min(pixels, 0.4 * side / largestDistance(*seen.exactness));
        const glm::dvec2 half = *seen.exactness / 2.0 * pixels;
        middle = {-half.x, -half.y};
    }
    return {bounded(pixels, seen), middle};
}

MagnifierView zoomed(MagnifierView view, const Magnified& seen, double factor, const QPointF& about)
{
    const double pixels = bounded(view.pixelsPerUnit * factor, seen);
    view.middle = about + (view.middle - about) * (pixels / view.pixelsPerUnit);
    view.pixelsPerUnit = pixels;
    return view;
}

void paintMagnified(QPainter& painter, const QRectF& area, const NamedEnd& end,
                    const MagnifierView& view, const MagnifierLook& look)
{
    painter.save();
    painter.setClipRect(area);
    painter.setFont(look.chart.font);
    Stage stage(painter, area, end.seen, view, look);
    stage.paintGround();
    const bool latticeSeen = stage.paintLattice();
    painter.setRenderHint(QPainter::Antialiasing);
    stage.paintEdges();
    stage.paintLine();
    stage.paintEnds(end.name);
    stage.paintScale(latticeSeen);
    painter.restore();
}

QString magnifiedText(const Magnified& seen, const QString& name)
{
    const auto point = [](const glm::dvec2& p) {
        return Text::tr("%1; %2", "coordinates").arg(exactText(p.x), exactText(p.y));
    };
    if (!seen.exactness)
        return Text::tr("%1 ends at %2, but nothing of the line is visible.")
            .arg(name, point(seen.centre));
    if (!seen.returned)
        return Text::tr("%1 shows nothing; the double nearest to the true end is %2.")
            .arg(name, point(seen.centre));
    const glm::dvec2 off = glm::abs(*seen.exactness);
    return Text::
        tr("%1 ends at %2, off by %3 in x and %4 in y. The doubles nearest to the true end are %5.")
            .arg(name, point(seen.centre), errorText(off.x / seen.ulp.x),
                 errorText(off.y / seen.ulp.y), point(seen.centre + seen.nearest));
}

} // namespace app
