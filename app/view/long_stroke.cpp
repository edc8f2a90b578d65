// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/long_stroke.h"

#include "app/view/caps.h"

#include <QPainterPathStroker>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr std::size_t pieceLength = 64; // points
constexpr double longEnough = 2;        // in stroke widths: such segments are divided invisibly
constexpr double finerJoins = 2;        // Qt flattens joins this much finer for QPainter

class Outliner {
public:
    Outliner(const StrokeStyle& strokeStyle, const QTransform& toDevice, const VisitContour& visit)
        : least_(longEnough * strokeStyle.width),
          toFiner_(toDevice * QTransform::fromScale(finerJoins, finerJoins)), visit_(visit)
    {
        stroker_.setWidth(strokeStyle.width);
        stroker_.setMiterLimit(strokeStyle.miterLimit);
        stroker_.setCapStyle(Qt::FlatCap);
        stroker_.setJoinStyle(strokeStyle.join == Join::Miter   ? Qt::SvgMiterJoin
                              : strokeStyle.join == Join::Round ? Qt::RoundJoin
                                                                : Qt::BevelJoin);
    }

    // Divides an open stroke into pieces that meet in the middle of a segment, where there is no
    // join.
    void open(std::span<const QPointF> points, const Cancelled& cancelled)
    {
        QPolygonF piece;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (std::size_t(piece.size()) > pieceLength && isLong(points[i - 1], points[i])) {
                piece << middle(points[i - 1], points[i]);
                outline(piece, false);
                if (cancelled())
                    return;
                piece = {piece.back()};
            }
            piece << points[i];
        }
        outline(piece, false);
    }

    // A closed stroke that begins and ends in the middle of a long segment can be drawn like an
    // open one.
    void closed(std::span<const QPointF> points, const Cancelled& cancelled)
    {
        std::size_t i = 1;
        while (i < points.size() && !isLong(points[i - 1], points[i]))
            ++i;
        if (i == points.size())
            return outline(QPolygonF(QList<QPointF>(points.begin(), points.end() - 1)), true);
        const QPointF start = middle(points[i - 1], points[i]);
        std::vector<QPointF> round{start};
        round.insert(round.end(), points.begin() + std::ptrdiff_t(i), points.end());
        round.insert(round.end(), points.begin() + 1, points.begin() + std::ptrdiff_t(i));
        round.push_back(start);
        open(round, cancelled);
    }

    // Adds the cap as a contour with the orientation of the stroker's contours, so that the areas
    // add up.
    void cap(const QPointF& at, const QPointF& away, const StrokeStyle& strokeStyle)
    {
        visitAll(capAt(at, away, strokeStyle, 0), [](QPolygonF& contour) {
            double area = 0;
            for (qsizetype i = 0; i < contour.size(); ++i) {
                const QPointF &a = contour[i], &b = contour[i + 1 == contour.size() ? 0 : i + 1];
                area += a.x() * b.y() - b.x() * a.y();
            }
            if (area < 0)
                std::ranges::reverse(contour);
        });
    }

private:
    bool isLong(const QPointF& a, const QPointF& b) const
    {
        return std::hypot(b.x() - a.x(), b.y() - a.y()) >= least_;
    }
    static QPointF middle(const QPointF& a, const QPointF& b) { return (a + b) / 2; }

    void outline(const QPolygonF& points, bool closed)
    {
        QPainterPath path;
        path.addPolygon(points);
        if (closed)
            path.closeSubpath();
        visitAll(stroker_.createStroke(path), [](QPolygonF&) {});
    }

    template <class Prepare>
    void visitAll(const QPainterPath& path, Prepare prepare)
    {
        for (QPolygonF& contour : path.toSubpathPolygons(toFiner_)) {
            prepare(contour);
            for (QPointF& p : contour)
                p /= finerJoins;
            visit_(contour);
        }
    }

    QPainterPathStroker stroker_;
    double least_;
    QTransform toFiner_;
    const VisitContour& visit_;
};

} // namespace

void visitContours(const LongStroke& stroke, const QTransform& toDevice, const Cancelled& cancelled,
                   const VisitContour& visit)
{
    const auto& [points, polyline, strokeStyle] = stroke;
    Outliner outliner(strokeStyle, toDevice, visit);
    if (polyline.closed)
        return outliner.closed(points, cancelled);
    outliner.open(points, cancelled);
    if (polyline.capAtStart && strokeStyle.cap != Cap::Butt)
        outliner.cap(points[0], points[0] - points[1], strokeStyle);
    if (polyline.capAtEnd && strokeStyle.cap != Cap::Butt)
        outliner.cap(points.back(), points.back() - points[points.size() - 2], strokeStyle);
}

} // namespace app
