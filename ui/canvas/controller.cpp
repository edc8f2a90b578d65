// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/controller.h"

#include "app/scene/bounds.h"
#include "ui/canvas/window_offer.h"
#include "ui/editing/keeping.h"
#include "ui/tools/shape_drawing.h"

#include <QGuiApplication>
#include <QPalette>

#include <glm/common.hpp>

namespace ui {

constexpr double snapReach = 8; // pixels
constexpr int growthTold = 100; // milliseconds

static app::Colour colourOf(const QColor& c)
{
    return {std::uint8_t(c.red()), std::uint8_t(c.green()), std::uint8_t(c.blue())};
}

Controller::Controller(app::Session& session, QObject* parent)
    : QObject(parent), session_(session), picking_(session.document, session.scene),
      textBoxes_(session.scene), shown_(session.display()),
      look_(lookOf(QGuiApplication::palette())), bench_{session_, toolView_, picking_, look_}
{
    setTool(tools().front().key);
    growing_.setSingleShot(true);
    growing_.setInterval(growthTold);
    connect(&growing_, &QTimer::timeout, this, &Controller::stepsChanged);
    connect(&session.scene, &app::Scene::outdated, this, &Controller::outdate);
    connect(&session, &app::Session::displayChanged, this, &Controller::followDisplay);
    connect(&session, &app::Session::selectionChanged, this, &Controller::outdate);
    connect(&session, &app::Session::inspectedChanged, this, &Controller::changed);
    connect(&session, &app::Session::previewChanged, this, &Controller::changed);
    connect(&session.differences, &app::LiveDifferences::changed, this, &Controller::renew);
    connect(&session.exactness, &app::LiveExactness::changed, this, &Controller::renew);
    connect(&session, &app::Session::loaded, this, [this] {
        tool_->cancel(bench_);
        emit stepsChanged();
        fitDrawing();
    });
    connect(&session.history, &app::History::indexChanged, this, &Controller::stepsChanged);
    connect(&navigation_, &Navigation::moved, this, [this] {
        toolView_ = view();
        emit viewChanged();
        emit changed();
    });
    fitDrawing();
}

void Controller::outdate()
{
    snap_.reset(); // its target may no longer exist
    emit hintChanged();
    renew();
}

// The lines are unchanged but look different.
void Controller::renew()
{
    ++revision_;
    emit changed();
}

// The variant is part of a pane's key, so the other panes' pictures stay valid.
void Controller::followDisplay()
{
    const app::Display before = std::exchange(shown_, session_.display());
    app::Display now = shown_;
    now.variant = before.variant;
    if (now != before)
        outdate();
    else
        emit changed();
}

void Controller::setLook(const Look& look)
{
    look_ = look;
    outdate();
}

void Controller::setTool(std::string_view key)
{
    const ToolInfo* info = findTool(key);
    if (!info || info == toolInfo_)
        return;
    if (tool_)
        tool_->end(bench_);
    tool_ = info->make();
    toolInfo_ = info;
    snap_.reset();
    emit stepsChanged();
    emit toolChanged();
    emit hintChanged();
    emit changed();
}

// New objects must not be added to a locked or hidden layer.
bool Controller::mayDraw() const
{
    const app::Containers& containers = session_.now().containers();
    const app::ContainerId layer = session_.pen.layer;
    return !tool_->draws() || (containers.shown(layer) && !containers.locked(layer));
}

QString Controller::hint() const
{
    if (!mayDraw())
        return tr("The layer %1 is locked or hidden. Select another layer, or unlock and show this "
                  "one.")
            .arg(session_.now().containers()[session_.pen.layer].name);
    const QString now = tool_->hint(bench_);
    return now.isEmpty() ? toolInfo_->hint : now;
}

QCursor Controller::cursor() const
{
    if (panningFrom_)
        return Qt::ClosedHandCursor;
    if (space_)
        return Qt::OpenHandCursor;
    if (pointer_ && offeredHandle().contains(pointer_->screen.x, pointer_->screen.y))
        return Qt::PointingHandCursor;
    return mayDraw() ? tool_->cursor(bench_) : Qt::ForbiddenCursor;
}

QRectF Controller::offeredHandle() const
{
    if (clipWindow() || !tool_->showsHandles())
        return {};
    return offerPlace(session_.now().page().rectangle(), view());
}

QColor Controller::pageColour() const
{
    return session_.display().asPrinted ? QColor(Qt::white) : look_.paper;
}

double Controller::ghostOpacity() const { return session_.display().presenting ? 1 : look_.ghost; }

const app::Differences* Controller::differing(const Pane& pane) const
{
    return pane.fromExact ? pane.fromExact->at(window()) : nullptr;
}

/// Colours lines by their error class; wrong lines are marked like differing ones.
void Controller::addErrors(app::PictureOptions& options) const
{
    const auto pieces = session_.exactness.piecesAt(window());
    if (pieces.empty())
        return;
    const app::Ground ground =
        look_.dark && !session_.display().asPrinted ? app::Ground::Dark : app::Ground::Light;
    for (std::size_t row = 0; row + 1 < pieces.size(); ++row)
        options.graded.push_back(
            {pieces[row], colourOf(app::errorColour(row, ground, look_.differs))});
    if (options.differing.empty())
        options.differing = pieces.back();
}

app::Picture Controller::picture(const app::SceneFrame& frame, const Pane& pane,
                                 double pixelRatio) const
{
    const app::Display& display = session_.display();
    app::PictureOptions options;
    options.view = view();
    options.removed = display.removed;
    if (look_.dark && !display.asPrinted)
        options.page = colourOf(look_.paper);
    options.leastWidth = pixelRatio < 1.5 ? 0.75 : 0.5;
    if (display.presenting) {
        options.strokes = 2;
        options.ghosting = app::Ghosting{colourOf(pageColour()), look_.ghost};
    }
    options.selection = session_.selection().ranges();
    options.light = colourOf(look_.selection);
    if (const app::Differences* differences = differing(pane))
        options.differing = differences->pieces;
    else if (pane.among == 1)
        options.differing = session_.differences.piecesAt(window());
    if (pane.among == 1)
        addErrors(options);
    options.marked = colourOf(look_.differs);
    if (look_.dark) // magenta is close to the selection's blue in the dark look
        options.ticks = app::PictureOptions::Ticks::Everywhere;
    return app::picture(session_.now().styles(), session_.scene.lines(), frame, options);
}

// Shows the page and objects outside it.
void Controller::fitDrawing()
{
    clipping::Window all = session_.now().page().rectangle();
    if (const auto lines = app::boundsOf(session_.scene.lines()))
        all = {glm::min(all.min, lines->min), glm::max(all.max, lines->max)};
    navigation_.show(all);
}

void Controller::fitSelection()
{
    const auto& bounds = session_.selectionBounds();
    bounds ? navigation_.show(*bounds) : fitDrawing();
}

void Controller::fitWindow() { navigation_.show(window()); }

static double pixelsPerUnit(const app::Page& page)
{
    return page.millimetresPerUnit() / app::infoOf(app::Unit::Px).millimetres;
}

double Controller::zoom() const { return view().zoom / pixelsPerUnit(session_.now().page()); }

void Controller::setZoom(double zoom)
{
    const QPointF middle(view().size.x / 2, view().size.y / 2);
    navigation_.zoomAt(middle, zoom / this->zoom());
}

Controller::Steps Controller::steps() const
{
    return {canUndo(), canRedo(), tool_->canTakeBack(), tool_->pendingPoints()};
}

// Receivers copy the whole object being drawn, which would be slow for each point of a long
// freehand line.
void Controller::tellSteps(const Steps& before)
{
    const Steps now = steps();
    Steps grown = before;
    grown.points = now.points;
    const bool following = now == grown && !now.takeBack && now.points > before.points;
    if (now == before)
        return;
    if (following && !growing_.isActive())
        growing_.start();
    if (following)
        return;
    growing_.stop();
    emit stepsChanged();
}

void Controller::withTool(const std::function<void()>& call)
{
    const QString before = hint();
    const Steps stepsBefore = steps();
    call();
    navigation_.go(toolView_);
    if (hint() != before)
        emit hintChanged();
    tellSteps(stepsBefore);
    emit changed();
}

Pointer Controller::pointerAt(const QPointF& screen, Qt::MouseButtons buttons,
                              Qt::KeyboardModifiers modifiers)
{
    const app::Point at(screen.x(), screen.y()), raw = view().toDrawing(at);
    snap_.reset();
    const auto to = app::SnapTo(std::uint8_t(tool_->snapsTo()) & std::uint8_t(snapTo_));
    if (to != app::SnapTo::Nothing && !(modifiers & Qt::ControlModifier)) {
        std::vector<clipping::Segment> near;
        const double radius = bench_.inDrawing(snapReach);
        for (const std::size_t line : picking_.near(raw, radius))
            near.push_back(session_.scene.lines()[line]);
        snap_ = app::snap(raw, radius, near, firstWindow(session_.now().windows()), to);
    }
    return {snap_ ? snap_->point : raw, raw, at, buttons, modifiers};
}

void Controller::endGesture()
{
    panningFrom_.reset();
    if (tool_->busy())
        withTool([&] { tool_->end(bench_); });
}

std::optional<app::PendingObject> Controller::objectInHand() const
{
    const auto path = tool_->pendingPath();
    if (!path)
        return std::nullopt;
    return app::PendingObject{objectOf(session_, std::span(&*path, 1)), session_.pen.layer};
}

bool Controller::handle(QEvent& event)
{
    switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
        pointerEvent(static_cast<QMouseEvent&>(event));
        return true;
    case QEvent::Wheel:
        navigation_.wheel(static_cast<QWheelEvent&>(event));
        return true;
    case QEvent::NativeGesture:
        return navigation_.gesture(static_cast<QNativeGestureEvent&>(event));
    case QEvent::KeyPress:
        return keyPress(static_cast<QKeyEvent&>(event));
    case QEvent::KeyRelease:
        return keyRelease(static_cast<QKeyEvent&>(event));
    case QEvent::Leave:
        pointer_.reset();
        snap_.reset();
        withTool([&] { tool_->leave(bench_); });
        emit pointerMoved(std::nullopt);
        emit changed();
        return false;
    case QEvent::FocusOut:
        space_ = false;
        return false;
    default:
        return false;
    }
}

void Controller::pointerEvent(QMouseEvent& event)
{
    if (event.type() == QEvent::MouseMove)
        move(event);
    else if (event.type() == QEvent::MouseButtonRelease)
        release(event);
    else if (event.type() == QEvent::MouseButtonDblClick && event.button() == Qt::MiddleButton)
        fitDrawing();
    else
        press(event);
    pointer_ = pointerAt(event.position(), event.buttons(), event.modifiers());
    if (event.type() == QEvent::MouseButtonRelease)
        snap_.reset(); // the snapped action is finished
    emit pointerMoved(pointer_->position);
}

void Controller::press(QMouseEvent& event)
{
    if (event.button() == Qt::MiddleButton || (event.button() == Qt::LeftButton && space_)) {
        panningFrom_ = event.position();
        emit changed();
        return;
    }
    if (event.button() != Qt::LeftButton || pressOffer(event))
        return;
    const Pointer pointer = pointerAt(event.position(), event.buttons(), event.modifiers());
    if (!mayDraw())
        return;
    withTool([&] {
        event.type() == QEvent::MouseButtonDblClick ? tool_->doubleClick(pointer, bench_)
                                                    : tool_->press(pointer, bench_);
    });
}

// Whether the offered handle takes the click. At the second press of a double click it no longer
// exists.
bool Controller::pressOffer(const QMouseEvent& event)
{
    if (onOffer_ && event.type() == QEvent::MouseButtonDblClick)
        return true;
    onOffer_ = offeredHandle().contains(event.position());
    if (onOffer_)
        layWindowOnPage(session_);
    return onOffer_;
}

void Controller::move(QMouseEvent& event)
{
    if (panningFrom_) {
        navigation_.pan(event.position() - *panningFrom_);
        panningFrom_ = event.position();
        return;
    }
    const Pointer pointer = pointerAt(event.position(), event.buttons(), event.modifiers());
    pointer_ = pointer;
    withTool([&] { tool_->move(pointer, bench_); });
}

void Controller::release(QMouseEvent& event)
{
    if (panningFrom_ && (event.button() == Qt::MiddleButton || event.button() == Qt::LeftButton)) {
        panningFrom_.reset();
        emit changed();
        return;
    }
    if (event.button() != Qt::LeftButton || onOffer_)
        return;
    const Pointer pointer = pointerAt(event.position(), event.buttons(), event.modifiers());
    withTool([&] { tool_->release(pointer, bench_); });
}

} // namespace ui
