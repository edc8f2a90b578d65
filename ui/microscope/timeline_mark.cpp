// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/timeline_mark.h"

#include "ui/look/text.h"

#include <QCoreApplication>

#include <array>

namespace ui {

namespace {

void paintTick(QPainter& painter, const QPointF& c)
{
    painter.drawLine(c - QPointF(0, 5), c + QPointF(0, 5));
}

void paintDot(QPainter& painter, const QPointF& c)
{
    painter.setBrush(painter.pen().color());
    painter.drawEllipse(c, 1.5, 1.5);
}

void paintDivided(QPainter& painter, const QPointF& c)
{
    painter.drawEllipse(c, 5.5, 5.5);
    painter.drawLine(c - QPointF(2.5, 0), c + QPointF(2.5, 0));
}

void paintDiamond(QPainter& painter, const QPointF& c)
{
    painter.setBrush(painter.pen().color());
    painter.drawPolygon(
        QPolygonF{c + QPointF(0, -5), c + QPointF(5, 0), c + QPointF(0, 5), c + QPointF(-5, 0)});
}

void paintAccept(QPainter& painter, const QPointF& c)
{
    painter.drawEllipse(c, 6.25, 6.25);
    painter.drawPolyline(
        QPolygonF{c + QPointF(-2.7, 0.2), c + QPointF(-0.7, 2.2), c + QPointF(3, -2.2)});
}

void paintReject(QPainter& painter, const QPointF& c)
{
    painter.drawEllipse(c, 6.25, 6.25);
    painter.drawLine(c - QPointF(2.2, 2.2), c + QPointF(2.2, 2.2));
    painter.drawLine(c - QPointF(2.2, -2.2), c + QPointF(2.2, -2.2));
}

void paintGiveUp(QPainter& painter, const QPointF& c)
{
    painter.drawEllipse(c, 6.25, 6.25);
    painter.drawLine(c - QPointF(0, 3), c + QPointF(0, 0.5));
    painter.drawPoint(c + QPointF(0, 3));
}

struct Row {
    const char* word;
    void (*paint)(QPainter&, const QPointF&);
};

/// In the order of app::Mark.
constexpr std::array rows{Row{QT_TRANSLATE_NOOP("Text", "compute"), paintDot},
                          Row{QT_TRANSLATE_NOOP("Text", "compare"), paintTick},
                          Row{QT_TRANSLATE_NOOP("Text", "divide"), paintDivided},
                          Row{QT_TRANSLATE_NOOP("Text", "cut"), paintDiamond},
                          Row{QT_TRANSLATE_NOOP("Text", "accept"), paintAccept},
                          Row{QT_TRANSLATE_NOOP("Text", "reject"), paintReject},
                          Row{QT_TRANSLATE_NOOP("Text", "give up"), paintGiveUp}};
static_assert(rows.size() == std::size_t(app::Mark::GiveUp) + 1);

} // namespace

void paintMark(QPainter& painter, const QPointF& middle, app::Mark mark, const QColor& colour,
               const QColor& ground)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, mark == app::Mark::Compare ? 2 : 1.5, Qt::SolidLine, Qt::RoundCap,
                        Qt::RoundJoin));
    painter.setBrush(ground);
    rows[std::size_t(mark)].paint(painter, middle);
    painter.restore();
}

QString markWord(app::Mark mark) { return Text::tr(rows[std::size_t(mark)].word); }

} // namespace ui
