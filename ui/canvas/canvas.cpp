// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/canvas.h"

#include "app/document/object_in_hand.h"
#include "ui/canvas/canvas_parts.h"

#include <QEvent>

namespace ui {

Canvas::Parts::Parts(app::Session& session, Backend wish, Canvas& canvas)
    : controller(session),
      choice(chooseBackend(wish, wish == Backend::Raster ? GlProbe{} : probeGl())),
      corner(controller, &canvas), top(controller, Qt::Horizontal, &canvas),
      left(controller, Qt::Vertical, &canvas), panes(session.variant()),
      readout(controller, &canvas), text(controller, &canvas), ofWindow(controller, &canvas),
      ofObjects(controller, &canvas)
{
}

void Canvas::Parts::repaint()
{
    const QCursor cursor = controller.cursor();
    for (const auto& widget : widgets) {
        widget->surface().widget().update();
        widget->surface().widget().setCursor(cursor);
    }
    top.update();
    left.update();
    corner.update();
}

Canvas::Canvas(app::Session& session, Backend backend, QWidget* parent)
    : QWidget(parent), parts_(std::make_unique<Parts>(session, backend, *this))
{
    const Controller& controller = parts_->controller;
    connect(&controller, &Controller::changed, this, [this] { parts_->repaint(); });
    connect(&controller, &Controller::viewChanged, this, &Canvas::viewChanged);
    connect(&controller, &Controller::pointerMoved, this, &Canvas::pointerMoved);
    connect(&controller, &Controller::toolChanged, this, &Canvas::toolChanged);
    connect(&controller, &Controller::stepsChanged, this, &Canvas::stepsChanged);
    connect(&controller, &Controller::hintChanged, this,
            [this] { emit hint(parts_->controller.hint()); });
    connect(&parts_->ofWindow, &Capsule::menuWanted, this, &Canvas::windowMenuWanted);
    connect(&parts_->ofObjects, &Capsule::menuWanted, this, &Canvas::objectMenuWanted);
    for (const Capsule* capsule : parts_->capsules) {
        connect(capsule, &Capsule::refused, this, &Canvas::refused);
        connect(capsule, &Capsule::taken, this, &Canvas::taken);
    }
    connect(&session, &app::Session::displayChanged, this, &Canvas::followChoice);
    connect(&session, &app::Session::loaded, this, &Canvas::layOut);
    layOut();
}

Canvas::~Canvas()
{
    for (const auto& widget : parts_->widgets) // they send events while they are destroyed
        widget->surface().widget().removeEventFilter(this);
}

Backend Canvas::backend() const { return parts_->choice.backend; }
QString Canvas::backendReason() const { return parts_->choice.reason; }
const app::View& Canvas::view() const { return parts_->controller.view(); }
double Canvas::zoom() const { return parts_->controller.zoom(); }
void Canvas::setTool(std::string_view key) { parts_->controller.setTool(key); }
std::string_view Canvas::tool() const { return parts_->controller.toolInfo().key; }
QString Canvas::toolHint() const { return parts_->controller.hint(); }
app::DigitUse Canvas::digitUse() const { return parts_->controller.digitUse(); }
bool Canvas::digitsChoose() const { return parts_->controller.digitsChoose(); }
bool Canvas::canUndo() const { return parts_->controller.canUndo(); }
bool Canvas::canRedo() const { return parts_->controller.canRedo(); }
void Canvas::undo() { parts_->controller.undo(); }
void Canvas::redo() { parts_->controller.redo(); }
void Canvas::goToStep(int index) { parts_->controller.goToStep(index); }
QString Canvas::undoText() const { return parts_->controller.undoText(); }
QString Canvas::redoText() const { return parts_->controller.redoText(); }
void Canvas::endGesture() { parts_->controller.endGesture(); }
std::optional<app::ObjectInHand> Canvas::pendingObject() const
{
    return parts_->controller.pendingObject();
}
void Canvas::transform(const app::Transformation& kind) { parts_->controller.transform(kind); }
app::SnapTo Canvas::snapping() const { return parts_->controller.snapping(); }
void Canvas::setSnapping(app::SnapTo to)
{
    parts_->controller.setSnapping(to);
    emit snappingChanged();
}
bool Canvas::snaps() const { return parts_->controller.snaps(); }
void Canvas::switchSnapping(bool on)
{
    parts_->controller.switchSnapping(on);
    emit snappingChanged();
}
bool Canvas::actsOnWindow() const { return parts_->controller.actsOnWindow(); }
bool Canvas::showsCapsule() const { return parts_->ofWindow.isOn(); }
std::optional<app::Numbers> Canvas::keptNumbers(std::string_view tool) const
{
    const auto& kept = parts_->controller.bench().kept;
    const auto found = kept.find(tool);
    return found == kept.end() ? std::nullopt : std::optional(found->second);
}
void Canvas::keepNumbers(std::string_view tool, const app::Numbers& numbers)
{
    parts_->controller.keepNumbers(tool, numbers);
}
bool Canvas::hasWholeCapsule() const
{
    return showsCapsule() && parts_->capsuleForm == Capsule::Form::Whole;
}
void Canvas::switchCapsule(bool on)
{
    for (Capsule* capsule : parts_->capsules)
        capsule->switchOn(on);
    emit capsuleSwitched();
}
void Canvas::setStrokeControls(QWidget& stroke) { parts_->ofObjects.setStroke(stroke); }
std::optional<QPoint> Canvas::onDrawing(const QPoint& position) const
{
    for (const auto& pane : parts_->widgets) {
        const QWidget& drawing = pane->surface().widget();
        const QPoint at = drawing.mapFrom(this, position);
        if (drawing.isVisible() && drawing.rect().contains(at))
            return at;
    }
    return std::nullopt;
}
bool Canvas::selectAt(const QPoint& position)
{
    const auto at = onDrawing(position);
    return at && parts_->controller.selectAt(*at);
}
bool Canvas::chooseWindowAt(const QPoint& position)
{
    const auto at = onDrawing(position);
    return at && parts_->controller.chooseWindowAt(*at);
}

void Canvas::fitDrawing() { parts_->controller.fitDrawing(); }
void Canvas::fitPage() { parts_->controller.fitPage(); }
void Canvas::fitSelection() { parts_->controller.fitSelection(); }
void Canvas::fitWindow() { parts_->controller.fitWindow(); }
void Canvas::go(const app::View& view) { parts_->controller.navigation().go(view); }
void Canvas::setZoom(double zoom) { parts_->controller.setZoom(zoom); }
void Canvas::previousView() { parts_->controller.navigation().back(); }
void Canvas::nextView() { parts_->controller.navigation().forth(); }
void Canvas::zoomBy(double factor)
{
    const app::Point size = view().size;
    parts_->controller.navigation().zoomAt({size.x / 2, size.y / 2}, factor);
}

void Canvas::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange)
        parts_->controller.setLook(lookOf(palette()));
    QWidget::changeEvent(event);
}

} // namespace ui

#include "moc_canvas.cpp"
