// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/comparing.h"
#include "app/view/pane_grid.h"
#include "ui/canvas/canvas_parts.h"

#include <QApplication>
#include <QPainter>
#include <QScopedValueRollback>

#include <algorithm>
#include <cmath>

// The panes of a canvas: their places, and which one is active. A single pane has rulers instead of
// a heading.

namespace ui {

std::optional<std::size_t> Canvas::Parts::place(std::size_t pane) const
{
    const auto found = std::ranges::find(shown, pane);
    return found == shown.end() ? std::nullopt : std::optional(std::size_t(found - shown.begin()));
}

const app::Panes& Canvas::panes() const { return parts_->panes; }

QWidget* Canvas::paneSurface(std::size_t pane) const
{
    const auto place = parts_->place(pane);
    return place ? &parts_->widgets[*place]->surface().widget() : nullptr;
}

void Canvas::setPanes(const app::Panes& panes)
{
    app::Session& session = parts_->controller.session();
    app::Panes shown = panes;
    followComparing(panes.size());
    if (!session.display().cuts)
        shown.choose(session.variant()); // a drawing that is seen once is seen as it is cut
    parts_->panes = shown;
    layOut();
    session.changeDisplay([&shown](app::Display& display) { display.variant = shown.chosen(); });
    emit panesChanged();
}

/// Several panes, and the microscope, are for looking at algorithms.
void Canvas::followComparing(std::size_t panes)
{
    app::Session& session = parts_->controller.session();
    app::setComparing(session, session.worksInCompare || panes > 1 || session.microscope.isOpen());
}

/// The last pane that is left is the one that the person keeps, and so the one that cuts.
void Canvas::keepPanes(const app::Panes& panes)
{
    app::Session& session = parts_->controller.session();
    if (panes.size() == 1 && !session.worksInCompare)
        app::useVariant(session, panes.chosen());
    setPanes(panes);
}

void Canvas::closePane(std::size_t pane)
{
    app::Panes panes = parts_->panes;
    panes.close(pane);
    keepPanes(panes);
}

void Canvas::activatePane(std::size_t pane)
{
    if (pane == parts_->panes.active())
        return;
    app::Panes panes = parts_->panes;
    panes.activate(pane);
    setPanes(panes);
}

/// The session's display has changed, perhaps its variant.
void Canvas::followChoice()
{
    update(); // beside the last pane, where dark paper is seen
    const app::Variant choice = parts_->controller.session().variant();
    if (choice == parts_->panes.chosen())
        return;
    parts_->panes.choose(choice);
    layOut();
    emit panesChanged();
}

void Canvas::addPane()
{
    Parts& parts = *parts_;
    parts.widgets.push_back(
        std::make_unique<PaneWidget>(parts.controller, parts.choice.backend, this));
    PaneWidget& widget = *parts.widgets.back();
    widget.surface().widget().installEventFilter(this);
    widget.surface().widget().setCursor(parts.controller.pointing().cursor());
    const auto change = [this, place = parts.widgets.size() - 1](auto edit) {
        if (place >= parts_->shown.size())
            return; // the menu's pane no longer exists
        app::Panes panes = parts_->panes;
        edit(panes, parts_->shown[place]);
        keepPanes(panes);
    };
    connect(&widget, &PaneWidget::frameShown, this, [this, &widget](const app::FrameTimes& times) {
        if (widget.pane().active)
            emit frameShown(times);
    });
    connect(&widget.heading(), &PaneHeading::pressed, this, [this, change] {
        change([](app::Panes& panes, std::size_t pane) { panes.activate(pane); });
        setFocus();
    });
    connect(&widget.heading(), &PaneHeading::chosen, this, [change](const app::Variant& choice) {
        change([&](app::Panes& panes, std::size_t pane) {
            panes.activate(pane);
            panes.choose(choice);
        });
    });
    connect(&widget.heading(), &PaneHeading::useWanted, this, [this, change] {
        change([](app::Panes& panes, std::size_t pane) { panes.activate(pane); });
        app::useVariant(parts_->controller.session(), parts_->panes.chosen());
    });
    connect(&widget.heading(), &PaneHeading::closeWanted, this, [this, change] {
        change([](app::Panes& panes, std::size_t pane) { panes.close(pane); });
        setFocus();
    });
    connect(&widget.heading(), &PaneHeading::aloneWanted, this, [this, change] {
        change([](app::Panes& panes, std::size_t pane) {
            panes.activate(pane);
            panes.show(1);
        });
        setFocus();
    });
}

static double breadthOf(const app::Page& page)
{
    const double width = std::abs(page.size.x), height = std::abs(page.size.y);
    return width > 0 && height > 0 ? std::clamp(width / height, 0.5, 2.0) : 1;
}

QPoint Canvas::drawingCorner() const
{
    return parts_->widgets.front()->surface().widget().mapTo(this, QPoint());
}

void Canvas::keepCorner() { parts_->cornerKeptIn = window()->size(); }

/// There were `before` panes: what is seen is seen in more or fewer ones now. One pane shows again
/// what it showed when it was left, unless the view has moved. True: its corner stays.
bool Canvas::changeCount(std::size_t before)
{
    Navigation& navigation = parts_->controller.navigation();
    if (before == 1)
        navigation.remember();
    if (parts_->shown.size() == 1 && navigation.release())
        return !navigation.isFitted();
    navigation.hold();
    return false;
}

void Canvas::layOut()
{
    const QScopedValueRollback quiet(parts_->layingOut, true);
    Parts& parts = *parts_;
    const bool alone = parts.panes.size() == 1;
    const int edge = alone ? rulerWidth : 0;
    const QRect area = rect().adjusted(edge, edge, 0, 0);
    const auto count = std::exchange(parts.shown, {}).size();
    const double breadth = breadthOf(parts.controller.session().now().page());
    parts.shown = parts.panes.shown(
        std::size_t(app::panesWithRoom(area.size(), int(parts.panes.size()), breadth)));
    bool cornerStays = parts.cornerKeptIn == window()->size();
    if (count != 0 && count != parts.shown.size()) {
        parts.controller.endGesture();
        cornerStays = changeCount(count) || cornerStays;
    }
    while (parts.widgets.size() < parts.shown.size())
        addPane();
    const bool focused = std::ranges::any_of(
        parts.widgets, [](const auto& widget) { return widget->surface().widget().hasFocus(); });
    const auto cells = app::paneCells(area.size(), int(parts.shown.size()), breadth);
    for (std::size_t i = 0; i < parts.shown.size(); ++i) {
        const std::size_t pane = parts.shown[i];
        parts.widgets[i]->setGeometry(cells[i].translated(area.topLeft()));
        parts.widgets[i]->show(
            {parts.panes.choices()[pane], pane == parts.panes.active(), int(parts.shown.size())},
            alone ? PaneWidget::Heading::None : PaneWidget::Heading::Shown);
    }
    QWidget& drawing = parts.activeWidget().surface().widget();
    setFocusProxy(&drawing);
    parts.readout.setSurface(&drawing);
    parts.text.setSurface(&drawing);
    if (focused)
        drawing.setFocus();
    for (std::size_t i = parts.shown.size(); i < parts.widgets.size(); ++i)
        parts.widgets[i]->rest();
    for (QWidget* ruler : {static_cast<QWidget*>(&parts.corner), static_cast<QWidget*>(&parts.top),
                           static_cast<QWidget*>(&parts.left)})
        ruler->setVisible(alone);
    parts.corner.setGeometry(0, 0, rulerWidth, rulerWidth);
    parts.top.setGeometry(rulerWidth, 0, area.width(), rulerWidth);
    parts.left.setGeometry(0, rulerWidth, rulerWidth, area.height());
    parts.controller.navigation().resize(
        {std::max(1, drawing.width()), std::max(1, drawing.height())},
        cornerStays ? Navigation::Keep::Corner : Navigation::Keep::Fit);
    constexpr int narrow = 640;
    auto form = alone && drawing.width() >= narrow ? Capsule::Form::Whole : Capsule::Form::Compact;
    if (parts.capsuleHome == app::CapsuleHome::InBar)
        form = parts.capsuleForm; // the bar decides
    for (Capsule* capsule : parts.capsules)
        capsule->setSurface(&drawing, form);
    if (std::exchange(parts.capsuleForm, form) != form)
        emit capsuleSwitched();
    update();
}

void Canvas::settle()
{
    for (Capsule* capsule : parts_->capsules)
        capsule->settle();
    for (const auto& widget : parts_->widgets)
        if (!widget->isHidden())
            widget->settle();
    for (const auto& widget : parts_->widgets) // one may paint the others, too
        if (!widget->isHidden())
            widget->surface().widget().repaint();
}

void Canvas::resizeEvent(QResizeEvent*) { layOut(); }

// Paints the gaps between panes and the area beside the last one.
void Canvas::paintEvent(QPaintEvent*)
{
    const Look& look = parts_->controller.look();
    QPainter painter(this);
    painter.fillRect(rect(), look.rule);
    const QRect last = parts_->widgets[parts_->shown.size() - 1]->geometry();
    painter.fillRect(QRect(last.topRight() + QPoint(1 + app::paneGap, 0), rect().bottomRight()),
                     parts_->controller.paperLook().canvas);
}

// The events that give a pane the focus also activate it.
bool Canvas::activates(const QEvent& event) const
{
    if (event.type() == QEvent::MouseButtonPress || event.type() == QEvent::MouseButtonDblClick)
        return true;
    if (event.type() != QEvent::FocusIn || parts_->layingOut)
        return false;
    const auto reason = static_cast<const QFocusEvent&>(event).reason();
    return reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason;
}

void Canvas::setCarrier(std::function<bool(const Carried&)> carrier)
{
    parts_->carrier = std::move(carrier);
}

/// Whether dragged objects were dropped where something else takes them.
bool Canvas::carriesAway(const QEvent& event)
{
    const bool moves = event.type() == QEvent::MouseMove;
    if ((!moves && event.type() != QEvent::MouseButtonRelease) || !parts_->carrier
        || !parts_->controller.tool().as<Transforms>().movesSelection())
        return false;
    const auto& mouse = static_cast<const QMouseEvent&>(event);
    const bool dropped = !moves && mouse.button() == Qt::LeftButton;
    const Carried carried{mouse.globalPosition().toPoint(), mouse.modifiers(), dropped};
    if (!parts_->carrier(carried) || !dropped)
        return false;
    parts_->controller.held().cancel();
    return true;
}

bool Canvas::eventFilter(QObject* watched, QEvent* event)
{
    const auto shows = [](const QObject* object) {
        return [object](const auto& widget) { return &widget->surface().widget() == object; };
    };
    const auto& widgets = parts_->widgets;
    const auto place = std::size_t(std::ranges::find_if(widgets, shows(watched)) - widgets.begin());
    if (place < parts_->shown.size() && activates(*event))
        activatePane(parts_->shown[place]);
    // If the focus moves to another pane, it stays in the drawing: Space is still held down.
    if (event->type() == QEvent::FocusOut
        && std::ranges::any_of(widgets, shows(QApplication::focusWidget())))
        return QWidget::eventFilter(watched, event);
    if (carriesAway(*event))
        return true;
    return parts_->controller.handle(*event) || QWidget::eventFilter(watched, event);
}

} // namespace ui
