// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/controller.h"

#include "app/session/inspection.h"

#include <QGuiApplication>
#include <QPalette>

#include <utility>

namespace ui {

constexpr int growthTold = 100; // milliseconds

Controller::Controller(app::Session& session, QObject* parent)
    : QObject(parent), session_(session), picking_(session.document, session.scene),
      textBoxes_(session.scene), shown_(session.display()),
      look_(lookOf(QGuiApplication::palette())),
      paperLook_(lookOnPaper(shown_.darkPaper)), bench_{session_,   toolView_, picking_,
                                                        paperLook_, snapper_,  snapNow_},
      snapper_(session.document, session.scene, picking_)
{
    setTool(tools().front().key);
    growing_.setSingleShot(true);
    growing_.setInterval(growthTold);
    connect(&growing_, &QTimer::timeout, this, &Controller::stepsChanged);
    connect(&session.scene, &app::Scene::outdated, this, &Controller::followDocument);
    connect(&session, &app::Session::displayChanged, this, &Controller::followDisplay);
    connect(&session, &app::Session::selectionChanged, this, &Controller::outdate);
    connect(&session, &app::Session::inspectedChanged, this, &Controller::changed);
    connect(&session, &app::Session::previewChanged, this, [this] {
        emit hintChanged(); // another window may be chosen
        emit changed();
    });
    connect(&session.nodes, &app::NodeEditing::changed, this, [this] {
        followGauge();
        emit hintChanged();
        emit changed();
    });
    connect(&session.entered, &app::EnteredGroup::changed, this, &Controller::changed);
    connect(&session.differences, &app::LiveDifferences::changed, this, &Controller::renew);
    connect(&session.exactness, &app::LiveExactness::changed, this, &Controller::renew);
    connect(&session, &app::Session::loaded, this, [this] {
        withTool([&] { tool_->cancel(bench_); });
        bench_.lastPoint.reset();
        followGauge();
        emit stepsChanged();
        fitPage();
    });
    connect(&session.history, &app::History::indexChanged, this, &Controller::stepsChanged);
    // Queued: the scene has followed the document then, and a click has inspected its own line.
    for (const auto signal : {&app::Session::selectionChanged, &app::Session::inspectedChanged})
        connect(&session, signal, this, &Controller::inspectOnly, Qt::QueuedConnection);
    connect(this, &Controller::toolChanged, this, &Controller::inspectOnly);
    connect(&navigation_, &Navigation::moved, this, [this] {
        toolView_ = view();
        emit viewChanged();
        emit changed();
    });
    fitPage();
}

/// However an object was selected, it is shown as if it had been clicked.
void Controller::inspectOnly()
{
    const bool isNew =
        std::exchange(inspectedSelection_, session_.selection()) != session_.selection();
    const auto inspected = session_.inspected(), line = app::lineOfOnlyObject(session_);
    if (!line || !toolInfo_->arranges())
        return;
    const app::SceneLines& lines = session_.scene.lines();
    const bool other = inspected && lines.objectOf(*inspected) != session_.selection().first();
    if (!inspected || (isNew && other))
        session_.inspect(line);
}

void Controller::outdate()
{
    snap_.reset();
    emit hintChanged();
    renew();
}

// Frames are told apart by their lines and clip windows. The page sets the size of a millimetre.
void Controller::followDocument()
{
    snap_.reset(); // its target may no longer exist
    emit hintChanged();
    const double size = session_.now().page().millimetresPerUnit();
    if (std::exchange(unitSize_, size) != size)
        ++revision_;
    emit changed();
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
    paperLook_ = lookOnPaper(shown_.darkPaper);
    app::Display now = shown_;
    now.variant = before.variant;
    if (now != before)
        outdate();
    else
        emit changed();
}

void Controller::setSnapping(app::SnapTo to)
{
    snapTo_ = to;
    switchSnapping(snaps_);
}

void Controller::switchSnapping(bool on)
{
    snaps_ = on;
    snapNow_ = on ? snapTo_ : app::SnapTo::Nothing;
    snap_.reset();
    emit changed();
}

void Controller::setLook(const Look& look)
{
    look_ = look;
    outdate();
}

void Controller::keepNumbers(std::string_view tool, const app::Numbers& numbers)
{
    bench_.kept[tool] = numbers;
    emit hintChanged(); // it may name them
}

void Controller::setCapsulePlace(const QRectF& place)
{
    if (std::exchange(capsulePlace_, place) != place)
        emit changed(); // the label with the size is where the capsule is not
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
    case QEvent::ShortcutOverride:
        return takesKey(static_cast<QKeyEvent&>(event)) && (event.accept(), true);
    case QEvent::KeyPress:
        return keyPress(static_cast<QKeyEvent&>(event));
    case QEvent::KeyRelease:
        return keyRelease(static_cast<QKeyEvent&>(event));
    case QEvent::Leave:
        snap_.reset();
        withTool([&] {
            pointer_.reset();
            tool_->leave(bench_);
        });
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

} // namespace ui

#include "moc_controller.cpp"
