// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/answer_discs.h"

#include "app/practice/stage.h"
#include "ui/look/look.h"
#include "ui/microscope/line_drag.h"
#include "ui/microscope/microscope_view.h"

#include <QMouseEvent>
#include <QPainter>

#include <utility>

namespace ui {

namespace {

constexpr double litWidth = 5; // pixels

/// The colour of an answer's disc and part; for an open one that is not hovered, of its outline.
QColor colourOf(app::StageAnswer::State state, bool lit, const Look& look)
{
    using enum app::StageAnswer::State;
    return state == Right   ? look.good
           : state == Wrong ? errorColour(look)
           : lit            ? look.selection
                            : look.control;
}

/// A tick or a cross in the middle of a disc, so that colour alone does not tell.
void paintSign(QPainter& painter, const QPointF& c, double unit, bool right)
{
    if (right) {
        painter.drawPolyline(QPolygonF{c + QPointF(-6, 0.5) * unit, c + QPointF(-1.5, 5) * unit,
                                       c + QPointF(6.5, -5) * unit});
        return;
    }
    painter.drawLine(c + QPointF(-4.5, -4.5) * unit, c + QPointF(4.5, 4.5) * unit);
    painter.drawLine(c + QPointF(-4.5, 4.5) * unit, c + QPointF(4.5, -4.5) * unit);
}

} // namespace

AnswerDiscs::AnswerDiscs(app::Course& course, app::Practice& practice, MicroscopeView& view)
    : QWidget(&view), course_(course), practice_(practice), view_(view)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    view.installEventFilter(this);
    connect(&course, &app::Course::changed, this, &AnswerDiscs::follow);
    connect(&practice, &app::Practice::changed, this, &AnswerDiscs::follow);
    connect(&view, &MicroscopeView::framed, this, &AnswerDiscs::follow);
    connect(&view, &MicroscopeView::reframed, this, &AnswerDiscs::follow);
    follow();
}

void AnswerDiscs::follow()
{
    setGeometry(view_.rect());
    answers_ = practice_.isOn() ? app::edgesToPick(practice_, view_.frame())
                                : app::stageAnswers(course_, view_.frame());
    if (answers_.empty() || !asks())
        hover({});
    std::vector<QRectF> boxes;
    for (const app::StageAnswer& answer : answers_)
        boxes.push_back(app::boxOfDisc(answer.disc, view_.frame()));
    view_.leaveFree(std::move(boxes));
    setVisible(!answers_.empty());
    update();
}

bool AnswerDiscs::asks() const { return practice_.isOn() ? practice_.asks() : course_.asks(); }

void AnswerDiscs::choose(int choice)
{
    practice_.isOn() ? void(practice_.useDigit(choice + 1)) : course_.choose(choice);
}

void AnswerDiscs::hover(std::optional<int> choice)
{
    if (std::exchange(hovered_, choice) == choice)
        return;
    view_.setCursor(choice ? Qt::PointingHandCursor : Qt::ArrowCursor);
    update();
}

/// What a click would answer. An end of the line is dragged instead.
std::optional<int> AnswerDiscs::choiceAt(const QMouseEvent& event) const
{
    const app::TracedLine& asked = practice_.isOn() ? practice_.tracedLine() : course_.asked();
    if (!asks() || view_.drags() || endAt(view_.frame(), asked.line, event.position()))
        return std::nullopt;
    const auto choice = app::answerAt(answers_, event.position(), view_.frame());
    const bool open =
        choice && answers_[std::size_t(*choice)].state == app::StageAnswer::State::Open;
    return open ? choice : std::nullopt;
}

bool AnswerDiscs::eventFilter(QObject* watched, QEvent* event)
{
    const auto* mouse = dynamic_cast<QMouseEvent*>(event);
    switch (event->type()) {
    case QEvent::Resize:
    case QEvent::FontChange:
        follow();
        break;
    case QEvent::Leave:
        hover({});
        break;
    case QEvent::MouseMove:
        hover(choiceAt(*mouse));
        return pressed_.has_value();
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseButtonPress:
        pressed_ = mouse->button() == Qt::LeftButton ? choiceAt(*mouse) : std::nullopt;
        return pressed_.has_value();
    case QEvent::MouseButtonRelease:
        if (const auto pressed = std::exchange(pressed_, std::nullopt)) {
            if (choiceAt(*mouse) == pressed) {
                choose(*pressed);
                emit answered();
            }
            return true;
        }
        break;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

void AnswerDiscs::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const app::StageAnswer& answer : answers_)
        paint(painter, answer);
}

void AnswerDiscs::paint(QPainter& painter, const app::StageAnswer& answer) const
{
    using enum app::StageAnswer::State;
    const Look& look = lookOf(palette());
    const double unit = view_.frame().unit();
    const QRectF box = app::boxOfDisc(answer.disc, view_.frame());
    const bool lit = hovered_ == answer.choice, filled = lit || answer.state != Open;
    const QColor colour = colourOf(answer.state, lit, look);
    if (lit || answer.state == Right) {
        painter.setPen(QPen(colour, litWidth * unit, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(answer.part);
    }
    painter.setPen(QPen(colour, 1.5 * unit));
    painter.setBrush(filled ? colour : look.base);
    painter.drawEllipse(box.adjusted(unit, unit, -unit, -unit));
    painter.setPen(
        QPen(filled ? look.base : look.text, 2 * unit, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (answer.state != Open)
        return paintSign(painter, answer.disc, unit, answer.state == Right);
    painter.setFont(semiBold(view_.frame().font));
    painter.drawText(box, Qt::AlignCenter, QString::number(answer.choice + 1));
}

} // namespace ui

#include "moc_answer_discs.cpp"
