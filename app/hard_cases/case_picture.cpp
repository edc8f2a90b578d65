// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hard_cases/case_picture.h"

#include "app/base/finite.h"
#include "app/hard_cases/case_scale.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double margin = 0.13; // share of the shorter side, for the ends' numbers

class CasePicturePainter {
public:
    CasePicturePainter(QPainter& painter, const QRectF& area, const HardCase& hard,
                       const CasePictureLook& look, const CaseAnswer* answer)
        : painter_(painter), hard_(hard), colours_(look.colours), unit_(look.unit), answer_(answer),
          scale_(hard, answer), picture_(area)
    {
        const double around = std::max(16 * unit_, margin * std::min(area.width(), area.height()));
        picture_ = area.adjusted(around, around, -around, -around);
        if (!scale_.isToScale())
            return;
        const QRectF used = scale_.extent();
        const double side = std::min(picture_.width() / std::max(used.width(), 1e-3),
                                     picture_.height() / std::max(used.height(), 1e-3));
        picture_ = QRectF(picture_.center() - QPointF(side, side) / 2, QSizeF(side, side));
    }

    void paint()
    {
        paintWindow();
        stroke(wayPath(), QPen(colours_.muted, 1.25 * unit_, Qt::DashLine, Qt::FlatCap));
        if (answer_ && answer_->visible && !answer_->good()) // wider, below the exact part
            paintPiece(*answer_->visible, colours_.differs, 5);
        if (hard_.visible)
            paintPiece(*hard_.visible, colours_.visible, 2.5);
        paintEnd(hard_.line.a, hard_.line.b, QStringLiteral("1"));
        if (!(hard_.line.a == hard_.line.b))
            paintEnd(hard_.line.b, hard_.line.a, QStringLiteral("2"));
    }

private:
    QPointF inPicture(const QPointF& share) const
    {
        return {picture_.left() + share.x() * picture_.width(),
                picture_.bottom() - share.y() * picture_.height()};
    }
    QPointF at(const glm::dvec2& p) const { return inPicture(scale_.at(p)); }

    static bool isNowhere(const glm::dvec2& p) { return std::isnan(p.x) || std::isnan(p.y); }

    QPainterPath wayPath() const
    {
        QPainterPath path;
        for (const QPointF& share : scale_.way())
            path.elementCount() == 0 ? path.moveTo(inPicture(share))
                                     : path.lineTo(inPicture(share));
        return path;
    }

    void stroke(const QPainterPath& path, const QPen& pen)
    {
        painter_.setPen(pen);
        painter_.setBrush(Qt::NoBrush);
        painter_.drawPath(path);
    }

    /// For an inverted window, which contains nothing, paints only the positions of its edges.
    void paintWindow()
    {
        const auto& [min, max] = hard_.window;
        QPen pen(colours_.window, 1.5 * unit_, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin);
        if (!(min.x <= max.x && min.y <= max.y))
            pen.setStyle(Qt::DotLine);
        if (isNowhere(min) || isNowhere(max))
            return paintHalfWindow(pen);
        QPainterPath path;
        path.addRect(QRectF(at(min), at(max)).normalized());
        if (min == max)
            path.addEllipse(at(min), 8 * unit_, 8 * unit_);
        else if (min.x == max.x || min.y == max.y) // visible around a line on it
            pen.setWidthF(7 * unit_);
        stroke(path, pen);
    }

    /// An edge that is NaN is left open.
    void paintHalfWindow(const QPen& pen)
    {
        const QRectF r = picture_;
        const QPointF low = isNowhere(hard_.window.min) ? r.bottomLeft() : at(hard_.window.min);
        QPainterPath path;
        path.moveTo(r.right(), r.top());
        path.lineTo(low.x(), r.top());
        path.lineTo(low);
        path.lineTo(r.right(), low.y());
        stroke(path, pen);
    }

    void paintPiece(const clipping::Segment& piece, const QColor& colour, double width)
    {
        if (!isFinite(piece))
            return;
        painter_.setPen(QPen(colour, width * unit_, Qt::SolidLine, Qt::RoundCap));
        painter_.drawLine(at(piece.a), at(piece.b));
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(colour);
        const double radius = (piece.a == piece.b ? 4.5 : width * 0.9) * unit_;
        painter_.drawEllipse(at(piece.a), radius, radius);
        painter_.drawEllipse(at(piece.b), radius, radius);
    }

    /// Paints a ring, and the end's number on the side away from the line.
    void paintEnd(const glm::dvec2& end, const glm::dvec2& other, const QString& number)
    {
        if (isNowhere(end))
            return;
        const QPointF place = at(end);
        painter_.setPen(QPen(colours_.text, 1.25 * unit_));
        painter_.setBrush(colours_.paper);
        painter_.drawEllipse(place, 3 * unit_, 3 * unit_);
        const QPointF away =
            isNowhere(other) || at(other) == place ? QPointF(1, -1) : place - at(other);
        const double length = std::hypot(away.x(), away.y());
        const QPointF middle = place + away * (10 * unit_ / length);
        painter_.drawText(QRectF(middle - QPointF(20, 20) * unit_, QSizeF(40, 40) * unit_),
                          Qt::AlignCenter, number);
    }

    QPainter& painter_;
    const HardCase& hard_;
    const CasePictureColours& colours_;
    double unit_;
    const CaseAnswer* answer_;
    CaseScale scale_;
    QRectF picture_;
};

} // namespace

void paintCasePicture(QPainter& painter, const QRectF& area, const HardCase& hard,
                      const CasePictureLook& look, const CaseAnswer* answer)
{
    painter.save();
    painter.setClipRect(area);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(area, look.colours.paper);
    CasePicturePainter(painter, area, hard, look, answer).paint();
    painter.restore();
}

bool isToScale(const HardCase& hard, const CaseAnswer* answer)
{
    return CaseScale(hard, answer).isToScale();
}

} // namespace app
