// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/canvas.h"

#include "app/document/object_in_hand.h"
#include "app/lettering/lettering.h"
#include "ui/canvas/canvas_parts.h"
#include "ui/canvas/view_commands.h"
#include "ui/canvas/window_tags.h"

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
    const QCursor cursor = controller.pointing().cursor();
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
    Controller& controller = parts_->controller;
    connect(&controller, &Controller::changed, this, [this] { parts_->repaint(); });
    connect(&controller.navigation(), &Navigation::moved, this, &Canvas::viewChanged);
    connect(&controller, &Controller::pointerMoved, this, &Canvas::pointerMoved);
    connect(&controller.held(), &HeldTool::chosen, this, &Canvas::toolChanged);
    connect(&controller.steps(), &GestureSteps::changed, this, &Canvas::stepsChanged);
    connect(&controller, &Controller::hintChanged, this, [this] { emit hint(toolHint()); });
    connect(&controller.held(), &HeldTool::snappingChanged, this, &Canvas::snappingChanged);
    connect(&parts_->ofWindow, &Capsule::menuWanted, this, &Canvas::windowMenuWanted);
    connect(&parts_->ofObjects, &Capsule::menuWanted, this, &Canvas::objectMenuWanted);
    for (const Capsule* capsule : parts_->capsules) {
        connect(capsule, &Capsule::refused, this, &Canvas::refused);
        connect(capsule, &Capsule::taken, this, &Canvas::taken);
        connect(capsule, &Capsule::barOutdated, this, &Canvas::capsuleBarOutdated);
    }
    connect(&session, &app::Session::displayChanged, this, &Canvas::followChoice);
    connect(&session.microscope, &app::Microscope::openChanged, this,
            [this] { followComparing(parts_->panes.size()); });
    connect(&session, &app::Session::loaded, this, [this] {
        parts_->cornerKeptIn = {}; // another drawing is fitted
        layOut();
    });
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
double Canvas::zoom() const
{
    return zoomOf(parts_->controller.session(), parts_->controller.navigation());
}
void Canvas::setTool(std::string_view key) { parts_->controller.held().choose(key); }
std::string_view Canvas::tool() const { return parts_->controller.toolInfo().key; }
QString Canvas::toolHint() const
{
    return parts_->hintOfFrame.isEmpty() ? parts_->controller.held().hint() : parts_->hintOfFrame;
}
void Canvas::cancelGesture() { parts_->controller.held().cancel(); }
app::PastedText Canvas::textAt(const QPointF& point) const
{
    const auto kept = keptNumbers("text");
    return {{},
            keptFont(),
            kept ? (*kept)[0] : app::usualTextSize,
            view().toDrawing({point.x(), point.y()})};
}
void Canvas::setHint(const QString& hint)
{
    parts_->hintOfFrame = hint;
    emit this->hint(toolHint());
}
app::DigitUse Canvas::digitUse() const { return parts_->controller.digitUse(); }
bool Canvas::digitsChoose() const { return parts_->controller.digitsChoose(); }
bool Canvas::canUndo() const { return parts_->controller.steps().canUndo(); }
bool Canvas::canRedo() const { return parts_->controller.steps().canRedo(); }
void Canvas::undo() { parts_->controller.steps().undo(); }
void Canvas::redo() { parts_->controller.steps().redo(); }
void Canvas::goToStep(int index) { parts_->controller.steps().goTo(index); }
QString Canvas::undoText() const { return parts_->controller.steps().undoText(); }
QString Canvas::redoText() const { return parts_->controller.steps().redoText(); }
void Canvas::endGesture() { parts_->controller.endGesture(); }
std::optional<app::ObjectInHand> Canvas::pendingObject() const
{
    return parts_->controller.unfinished();
}
void Canvas::transform(const app::Transformation& kind) { parts_->controller.transform(kind); }
app::SnapTo Canvas::snapping() const { return parts_->controller.held().snapping(); }
void Canvas::setSnapping(app::SnapTo to) { parts_->controller.held().setSnapping(to, snaps()); }
bool Canvas::snaps() const { return parts_->controller.held().snaps(); }
void Canvas::switchSnapping(bool on) { parts_->controller.held().setSnapping(snapping(), on); }
bool Canvas::actsOnWindow() const { return parts_->controller.actsOnWindow(); }
void Canvas::leaveKeysToCommands(const QHash<QString, QList<QKeySequence>>& own)
{
    parts_->controller.leaveKeysToCommands(own);
}

app::CapsuleHome Canvas::capsuleHome() const { return parts_->capsuleHome; }
std::optional<app::Numbers> Canvas::keptNumbers(std::string_view tool) const
{
    const auto& kept = parts_->controller.bench().kept;
    const auto found = kept.find(tool);
    return found == kept.end() ? std::nullopt : std::optional(found->second);
}
void Canvas::keepNumbers(std::string_view tool, const app::Numbers& numbers)
{
    parts_->controller.held().use([&](Tool&, Workbench& bench) { bench.kept[tool] = numbers; });
}
QString Canvas::keptFont() const { return fontOfNext(parts_->controller.bench()); }
void Canvas::keepFont(const QString& font)
{
    parts_->controller.held().use([&](Tool&, Workbench& bench) { bench.keptFont = font; });
}
bool Canvas::hasWholeCapsule() const
{
    return capsuleHome() == app::CapsuleHome::InBar
           || (capsuleHome() == app::CapsuleHome::AtObject
               && parts_->capsuleForm == Capsule::Form::Whole);
}
void Canvas::setCapsuleHome(app::CapsuleHome home)
{
    parts_->capsuleHome = home;
    QWidget* bar = home == app::CapsuleHome::InBar ? parts_->capsuleBar : nullptr;
    for (Capsule* capsule : parts_->capsules)
        capsule->setHome(home, bar);
    layOut(); // its form may be another one
    emit capsuleSwitched();
}
void Canvas::setCapsuleBar(QWidget& bar)
{
    parts_->capsuleBar = &bar;
    connect(&bar, &QObject::destroyed, this, [this] { // it would destroy them, too
        parts_->capsuleBar = nullptr;
        for (Capsule* capsule : parts_->capsules) {
            const QSignalBlocker quiet(capsule); // the bar is no longer whole
            capsule->setHome(app::CapsuleHome::Off, nullptr);
        }
    });
}
void Canvas::narrowCapsuleInBar(bool narrow)
{
    if (capsuleHome() != app::CapsuleHome::InBar)
        return;
    const auto form = narrow ? Capsule::Form::Compact : Capsule::Form::Whole;
    if (std::exchange(parts_->capsuleForm, form) == form)
        return;
    for (Capsule* capsule : parts_->capsules) {
        capsule->setForm(form);
        capsule->settle();
    }
}
bool Canvas::hasCapsuleInBar() const
{
    const QObject* shown = parts_->controller.capsule();
    return capsuleHome() == app::CapsuleHome::InBar && shown;
}
void Canvas::setStyleControls(QWidget& style, std::function<void()> follow)
{
    parts_->ofObjects.setStyle(style, std::move(follow));
}
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
    Controller& controller = parts_->controller;
    const auto at = onDrawing(position);
    if (at)
        controller.endGesture();
    return at && controller.pointing().selectAt(*at);
}
bool Canvas::chooseWindowAt(const QPoint& position)
{
    const auto at = onDrawing(position);
    if (at)
        parts_->controller.endGesture();
    return at && ui::chooseWindowAt(*at, parts_->controller.held());
}

void Canvas::fitDrawing()
{
    ui::fitDrawing(parts_->controller.session(), parts_->controller.navigation());
}
void Canvas::fitPage()
{
    ui::fitPage(parts_->controller.session(), parts_->controller.navigation());
}
void Canvas::fitSelection()
{
    ui::fitSelection(parts_->controller.session(), parts_->controller.navigation());
}
void Canvas::fitWindow()
{
    ui::fitWindow(parts_->controller.session(), parts_->controller.navigation());
}
void Canvas::go(const app::View& view) { parts_->controller.navigation().go(view); }
void Canvas::setZoom(double zoom)
{
    ui::setZoom(zoom, parts_->controller.session(), parts_->controller.navigation());
}
void Canvas::previousView() { parts_->controller.navigation().back(); }
void Canvas::nextView() { parts_->controller.navigation().forth(); }
void Canvas::zoomBy(double factor) { ui::zoomBy(factor, parts_->controller.navigation()); }

void Canvas::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange)
        parts_->controller.setLook(lookOf(palette()));
    QWidget::changeEvent(event);
}

} // namespace ui

#include "moc_canvas.cpp"
