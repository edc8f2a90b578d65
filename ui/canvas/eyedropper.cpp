// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/eyedropper.h"

#include "app/session/recent_colours.h"
#include "app/view/picking.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/widgets/swatch.h"

#include <QApplication>
#include <QMouseEvent>

#include <algorithm>
#include <array>
#include <utility>

namespace ui {
namespace {

constexpr int beside = 14, chipHeight = 26; // logical pixels
constexpr double near = 8;                  // as far as the pointer snaps

/// The colour under the pointer and its digits, in a small box.
class Chip : public QWidget {
public:
    explicit Chip(QWidget* parent) : QWidget(parent)
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        resize(fontMetrics().horizontalAdvance(QStringLiteral("#DDDDDDDD")) + 40, chipHeight);
    }
    void show(const app::Colour& colour)
    {
        colour_ = colour;
        update();
        QWidget::show();
        raise();
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        const Look& look = lookOf(palette());
        QPainter painter(this);
        painter.setPen(look.border);
        painter.setBrush(look.base);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
        paintSwatch(painter, {5, 5, 16, 16}, colour_, look);
        painter.setPen(look.text);
        painter.drawText(rect().adjusted(28, 0, -6, 0), Qt::AlignVCenter, app::hexText(colour_));
    }

private:
    app::Colour colour_;
};

QCursor dropper(const QPalette& palette)
{
    const QColor colour = lookOf(palette).text;
    return QCursor(tinted(icon("eyedropper"), {20, 20}, 1, colour), 3, 17);
}

} // namespace

void Eyedropper::start(Canvas& canvas, app::Session& session, Taken taken)
{
    delete canvas.findChild<Eyedropper*>();
    canvas.endGesture();
    new Eyedropper(canvas, session, std::move(taken)); // the canvas owns it
}

Eyedropper::Eyedropper(Canvas& canvas, app::Session& session, Taken taken)
    : QObject(&canvas), canvas_(canvas), session_(session),
      picking_(session.document, session.scene), taken_(std::move(taken)), chip_(new Chip(&canvas))
{
    // The last filter is asked first. Shortcuts are seen by the application's filter alone.
    qApp->installEventFilter(this);
    canvas.setFocus();
    connect(&canvas, &Canvas::toolChanged, this, &Eyedropper::end);
    emit canvas.hint(Text::tr("Click a line or an area to take its colour. Esc: cancel."));
}

Eyedropper::~Eyedropper()
{
    leave();
    delete chip_;
}

void Eyedropper::end()
{
    emit canvas_.hint(canvas_.toolHint());
    leave();
    qApp->removeEventFilter(this);
    deleteLater();
}

bool Eyedropper::eventFilter(QObject* watched, QEvent* event)
{
    const bool key = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (key && static_cast<const QKeyEvent&>(*event).key() == Qt::Key_Escape
        && qobject_cast<QWidget*>(watched)) {
        event->accept();
        if (event->type() == QEvent::KeyPress)
            end();
        return true;
    }
    // Other events come while panes are made and deleted, too.
    static constexpr std::array ofPointer{QEvent::Leave,
                                          QEvent::ContextMenu,
                                          QEvent::MouseMove,
                                          QEvent::MouseButtonPress,
                                          QEvent::MouseButtonRelease,
                                          QEvent::MouseButtonDblClick};
    if (std::ranges::find(ofPointer, event->type()) == ofPointer.end())
        return false;
    const auto* surface = qobject_cast<QWidget*>(watched);
    bool shows = false;
    for (std::size_t pane = 0; pane < canvas_.panes().size(); ++pane)
        shows |= surface && surface == canvas_.paneSurface(pane);
    if (!shows)
        return false;
    return pointerEvent(*surface, *event);
}

bool Eyedropper::pointerEvent(const QWidget& surface, const QEvent& event)
{
    if (event.type() == QEvent::Leave)
        leave();
    if (event.type() == QEvent::ContextMenu)
        return true; // the right button ends it
    const bool moves = event.type() == QEvent::MouseMove;
    const bool releases = event.type() == QEvent::MouseButtonRelease;
    const bool presses =
        event.type() == QEvent::MouseButtonPress || event.type() == QEvent::MouseButtonDblClick;
    if (!moves && !releases && !presses)
        return false;
    const auto& mouse = static_cast<const QMouseEvent&>(event);
    if (moves)
        showAt(surface, mouse.position());
    else if (presses)
        pressed_ = mouse.button() == Qt::LeftButton;
    else if (mouse.button() == Qt::RightButton)
        end();
    else if (mouse.button() == Qt::LeftButton && pressed_)
        take(mouse.position()); // not on the press: the tool in hand would get the release
    return true;
}

void Eyedropper::leave()
{
    if (std::exchange(over_, false))
        QApplication::restoreOverrideCursor();
    chip_->hide();
}

std::optional<app::Colour> Eyedropper::colourAt(const QPointF& place) const
{
    const app::View& view = canvas_.view();
    return app::colourAt(session_.now(), session_.scene, picking_,
                         view.toDrawing({place.x(), place.y()}), near / view.zoom);
}

void Eyedropper::showAt(const QWidget& surface, const QPointF& place)
{
    if (!over_)
        QApplication::setOverrideCursor(dropper(canvas_.palette()));
    over_ = true;
    const auto colour = colourAt(place);
    if (!colour)
        return chip_->hide();
    QPoint at = surface.mapTo(&canvas_, place.toPoint()) + QPoint(beside, beside);
    at.setX(std::min(at.x(), canvas_.width() - chip_->width()));
    at.setY(std::min(at.y(), canvas_.height() - chip_->height()));
    chip_->move(at);
    static_cast<Chip&>(*chip_).show(*colour);
}

void Eyedropper::take(const QPointF& place)
{
    const auto colour = colourAt(place);
    if (!colour) {
        emit canvas_.hint(Text::tr("There is no line here. Click a line or an area. Esc: cancel."));
        return;
    }
    const Taken taken = taken_;
    end();
    taken(*colour);
}

} // namespace ui

#include "moc_eyedropper.cpp"
