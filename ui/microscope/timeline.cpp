// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/timeline.h"

#include "app/base/numbers.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/microscope/answer_cover.h"
#include "ui/widgets/spoken_role.h"

#include <QCoreApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <array>
#include <cmath>

namespace ui {

namespace {

constexpr double side = 14, railY = 28; // pixels
constexpr double crowded = 9; // pixels between marks; if closer, comparisons are painted as dashes
constexpr int notch = 120;
constexpr double coveredSpacing = 40, leastCover = 200; // pixels

bool context(app::Mark mark) { return mark != app::Mark::Look && mark != app::Mark::Compare; }

} // namespace

Timeline::Timeline(app::Microscope& microscope, QWidget* parent)
    : QWidget(parent), microscope_(microscope)
{
    setSpokenRole(*this, QAccessible::Slider);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(Text::tr("Timeline"));
    setFont(captionFont(font()));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&microscope, &app::Microscope::stepChanged, this, &Timeline::follow);
    connect(&microscope, &app::Microscope::tracedLineChanged, this, &Timeline::follow);
    follow();
}

void Timeline::follow()
{
    const auto& narration = microscope_.narration();
    QString words;
    if (microscope_.isCovered())
        words = Text::tr("The later steps are covered until you answer.");
    else if (!narration.steps.empty())
        words = Text::tr("Step %1 of %2: %3")
                    .arg(microscope_.step() + 1)
                    .arg(narration.steps.size())
                    .arg(markWord(microscope_.narrated()->mark));
    setAccessibleDescription(words);
    update();
}

QSize Timeline::minimumSizeHint() const
{
    return {120, int(railY) + 16 + fontMetrics().height() + 4};
}
QSize Timeline::sizeHint() const { return {480, minimumSizeHint().height()}; }

double Timeline::spacing() const
{
    const auto count = microscope_.narration().steps.size();
    // Covered steps have fixed spacing, so that it does not reveal their number.
    if (microscope_.isCovered())
        return std::min(coveredSpacing,
                        (width() - 2 * side - leastCover) / std::max(1.0, double(count)));
    return count < 2 ? 0 : std::min((width() - 2 * side) / double(count - 1), 96.0);
}

/// The area that covers all later steps, extended to the right end so that it does not reveal their
/// number.
QRect Timeline::answerCover() const
{
    constexpr int high = 22;
    const int count = int(microscope_.narration().steps.size());
    const int left =
        int(count == 0 ? side : placeOf(std::size_t(count - 1)).x() + coveredSpacing / 2);
    return {left, int(railY) - high / 2, width() - int(side) - left, high};
}

QPointF Timeline::placeOf(std::size_t step) const
{
    return {side + spacing() * double(step), railY};
}

std::size_t Timeline::stepAt(double x) const
{
    return spacing() > 0 ? std::size_t(std::max(0L, std::lround((x - side) / spacing()))) : 0;
}

/// Numbers every 1st, 5th, 10th, 50th … step, so that no two numbers touch.
std::size_t Timeline::numberEvery() const
{
    const auto count = microscope_.narration().steps.size();
    const double widest =
        QFontMetrics(semiBold(font())).horizontalAdvance(QString::number(count)) + 8;
    for (std::size_t every = 1; every < count; every *= 10)
        for (const std::size_t times : {1U, 2U, 5U})
            if (spacing() * double(every * times) >= widest)
                return every * times;
    return std::max<std::size_t>(count, 1);
}

void Timeline::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!microscope_.narration().steps.empty()) {
        paintRail(painter);
        paintMarks(painter);
        paintNumbers(painter);
        paintNow(painter);
    }
    if (microscope_.isCovered())
        paintAnswerCover(painter, answerCover(), palette());
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(lookOf(palette()).selection, 2));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), space::radius,
                                space::radius);
    }
}

void Timeline::paintRail(QPainter& painter) const
{
    const Look& look = lookOf(palette());
    const auto& steps = microscope_.narration().steps;
    const QPointF from = placeOf(0), now = placeOf(microscope_.step()),
                  to = placeOf(steps.size() - 1);
    painter.setPen(QPen(look.border, 2));
    painter.drawLine(now, to);
    painter.setPen(QPen(look.text, 2));
    painter.drawLine(from, now);
}

void Timeline::paintMarks(QPainter& painter) const
{
    const Look& look = lookOf(palette());
    const auto& steps = microscope_.narration().steps;
    // Decisive steps are painted last, so that comparisons never cover them.
    for (const bool important : {false, true})
        for (std::size_t i = 0; i < steps.size(); ++i) {
            if (context(steps[i].mark) != important || i == microscope_.step())
                continue;
            const QColor colour = i > microscope_.step() ? look.muted : look.text;
            if (!important && spacing() < crowded) {
                painter.setPen(QPen(colour, 1));
                painter.drawLine(placeOf(i) - QPointF(0, 3), placeOf(i) + QPointF(0, 3));
            } else {
                paintMark(painter, placeOf(i), steps[i].mark, colour, look.panel);
            }
        }
}

void Timeline::paintNumbers(QPainter& painter) const
{
    const Look& look = lookOf(palette());
    const std::size_t count = microscope_.narration().steps.size(), every = numberEvery(),
                      now = microscope_.step();
    const QFontMetrics bold(semiBold(font()));
    const double y = railY + 14, height = bold.height();
    const auto half = [&](std::size_t i) {
        return bold.horizontalAdvance(QString::number(i + 1)) / 2.0 + 4;
    };
    const auto paint = [&](std::size_t i) {
        const QPointF place = placeOf(i);
        painter.drawText(QRectF(place.x() - 40, y, 80, height), Qt::AlignCenter,
                         QString::number(i + 1));
    };
    painter.setFont(font());
    painter.setPen(look.muted);
    for (std::size_t i = 0; i < count; ++i)
        if ((i == 0 || (i + 1) % every == 0)
            && std::abs(placeOf(i).x() - placeOf(now).x()) > half(i) + half(now) - 8
            && (i == 0 || placeOf(i).x() - placeOf(0).x() > half(i) + half(0) - 8))
            paint(i);
    painter.setFont(semiBold(font()));
    painter.setPen(look.selection);
    paint(now);
}

void Timeline::paintNow(QPainter& painter) const
{
    const Look& look = lookOf(palette());
    const QPointF c = placeOf(microscope_.step());
    painter.setPen(QPen(look.selection, 2));
    painter.drawLine(c - QPointF(0, 18), c - QPointF(0, 8));
    painter.drawLine(c + QPointF(0, 8), c + QPointF(0, 14));
    painter.setBrush(look.selection);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(c - QPointF(0, 20), 4.5, 4.5);
    paintMark(painter, c, microscope_.narrated()->mark, look.selection, look.panel);
}

void Timeline::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        microscope_.goTo(stepAt(event->position().x()));
}

void Timeline::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() & Qt::LeftButton)
        microscope_.goTo(stepAt(event->position().x()));
}

void Timeline::wheelEvent(QWheelEvent* event)
{
    wheel_ += event->angleDelta().y() + event->angleDelta().x();
    for (; wheel_ >= notch; wheel_ -= notch)
        microscope_.previous();
    for (; wheel_ <= -notch; wheel_ += notch)
        microscope_.next();
    event->accept();
}

void Timeline::keyPressEvent(QKeyEvent* event)
{
    constexpr std::size_t last = -1;
    constexpr std::size_t page = 10;
    const std::size_t now = microscope_.step();
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
        return microscope_.previous();
    case Qt::Key_Right:
    case Qt::Key_Up:
        return microscope_.next();
    case Qt::Key_PageUp:
        return microscope_.goTo(now + page);
    case Qt::Key_PageDown:
        return microscope_.goTo(now - std::min(now, page));
    case Qt::Key_Home:
        return microscope_.goTo(0);
    case Qt::Key_End:
        return microscope_.goTo(last);
    default:
        QWidget::keyPressEvent(event);
    }
}

bool Timeline::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto& steps = microscope_.narration().steps;
        if (const std::size_t step = stepAt(help->pos().x()); step < steps.size())
            QToolTip::showText(help->globalPos(),
                               Text::tr("%1. %2").arg(step + 1).arg(steps[step].sentence), this);
        return true;
    }
    return QWidget::event(event);
}

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

#include "moc_timeline.cpp"
