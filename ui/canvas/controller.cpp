// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/controller.h"

#include "app/base/keys_in_use.h"
#include "app/session/arrange_selection.h"
#include "app/session/inspection.h"
#include "ui/canvas/canvas_keys.h"
#include "ui/canvas/view_commands.h"
#include "ui/widgets/swatch.h"

#include <QGuiApplication>
#include <QPalette>

#include <utility>

namespace ui {

Controller::Controller(app::Session& session, QObject* parent)
    : QObject(parent), held_(session, navigation_), typing_(held_), aim_(held_, typing_),
      pointing_(held_, aim_, navigation_), steps_(held_, typing_), frames_(held_.bench()),
      look_(lookOf(QGuiApplication::palette())), shown_(session.display())
{
    connect(&navigation_, &Navigation::moved, this, &Controller::changed);
    connect(&held_, &HeldTool::chosen, this, [this] {
        aim_.forget();
        inspectOnly();
        emit hintChanged();
        emit changed();
    });
    connect(&held_, &HeldTool::used, this, [this] {
        tellHint();
        emit changed();
    });
    connect(&held_, &HeldTool::snappingChanged, this, [this] {
        aim_.forget();
        emit changed();
    });
    connect(&typing_, &Typing::changed, this, &Controller::changed);
    connect(&pointing_, &Pointing::changed, this, &Controller::changed);
    connect(&pointing_, &Pointing::moved, this, [this](std::optional<app::Point> position) {
        emit pointerMoved(position);
        if (position && typing_.readout())
            emit typing_.changed();
    });
    connectSession();
    fitPage(session, navigation_);
}

QColor Controller::pageColour() const
{
    const app::Colour& own = session().now().page().background.colour;
    return paperLook().dark || own.alpha == 0 ? paperLook().paper : screenColour(own);
}

/// At another scale of the drawing, the paper stays as it is seen; what is drawn on it grows or
/// shrinks.
void Controller::followScale(const app::DocumentChange& change)
{
    const app::Page& page = session().now().page();
    const double unit = page.millimetresPerUnit(), before = std::exchange(paperUnit_, unit);
    if (change.everything || unit == before)
        return;
    app::View view = navigation_.view();
    view.zoom *= unit / before;
    view.centre = page.min + (view.centre - page.min) * (before / unit);
    navigation_.go(view);
}

void Controller::connectSession()
{
    app::Session& session = this->session();
    paperUnit_ = session.now().page().millimetresPerUnit();
    connect(&session.document, &app::EditedDocument::changed, this, &Controller::followScale);
    connect(&session.scene, &app::Scene::outdated, this, [this] {
        aim_.forget();
        frames_.followPage();
        emit hintChanged();
        emit changed();
    });
    connect(&session, &app::Session::displayChanged, this, &Controller::followDisplay);
    connect(&session, &app::Session::selectionChanged, this, &Controller::outdate);
    connect(&session, &app::Session::inspectedChanged, this, &Controller::changed);
    connect(&session.entered, &app::EnteredGroup::changed, this, &Controller::changed);
    const auto tell = [this] {
        emit hintChanged();
        emit changed();
    };
    connect(&session, &app::Session::previewChanged, this, tell); // another window may be chosen
    connect(&session.nodes, &app::NodeEditing::changed, this, tell);
    connect(&session.differences, &app::LiveDifferences::changed, this, &Controller::renew);
    connect(&session.exactness, &app::LiveExactness::changed, this, &Controller::renew);
    connect(&session, &app::Session::loaded, this, [this] {
        held_.use([](Tool& tool, Workbench& bench) {
            tool.cancel(bench);
            bench.lastPoint.reset();
        });
        emit steps_.changed();
        fitPage(this->session(), navigation_);
    });
    // Queued: the scene has followed the document then, and a click has inspected its own line.
    for (const auto signal : {&app::Session::selectionChanged, &app::Session::inspectedChanged})
        connect(&session, signal, this, &Controller::inspectOnly, Qt::QueuedConnection);
}

/// However an object was selected, it is shown as if it had been clicked.
void Controller::inspectOnly()
{
    app::Session& session = this->session();
    const bool isNew =
        std::exchange(inspectedSelection_, session.selection()) != session.selection();
    const auto inspected = session.inspected(), line = app::lineOfOnlyObject(session);
    if (!line || !toolInfo().arranges())
        return;
    const app::SceneLines& lines = session.scene.lines();
    const bool other = inspected && lines.objectOf(*inspected) != session.selection().first();
    if (!inspected || (isNew && other))
        session.inspect(line);
}

void Controller::outdate()
{
    aim_.forget();
    emit hintChanged();
    renew();
}

// The lines are unchanged but look different.
void Controller::renew()
{
    frames_.renew();
    emit changed();
}

// The variant is part of a pane's key, so the other panes' pictures stay valid.
void Controller::followDisplay()
{
    const app::Display before = std::exchange(shown_, session().display());
    app::Display now = shown_;
    now.variant = before.variant;
    now.cuts = before.cuts;
    if (now != before)
        outdate();
    else
        emit changed();
}

/// Says the hint and the use of digits again, if a tool has changed them.
void Controller::tellHint()
{
    const auto now = std::pair(held_.hint(), digitUse());
    if (std::exchange(told_, now) != now)
        emit hintChanged();
}

void Controller::setLook(const Look& look)
{
    look_ = look;
    outdate();
}

void Controller::setCapsule(const QObject* capsule, const QRectF& place)
{
    capsule_ = capsule;
    if (std::exchange(capsulePlace_, place) != place)
        emit changed(); // the label with the size is where the capsule is not
}

bool Controller::actsOnWindow() const
{
    return toolInfo().showsHandles()
           && (toolInfo().key == "window" ? session().windowChosen()
                                          : session().windowChosenLast());
}

app::DigitPlace Controller::digitPlace() const
{
    return {.gesture = gestureGoes(),
            .numbers = typing_.takesNumbers(),
            .draws = session().worksInDraw,
            .windowChosen = toolInfo().showsHandles() && session().windowChosen()};
}

bool Controller::digitsChoose() const
{
    app::DigitPlace place = digitPlace();
    place.gesture = false;
    return app::digitUse(place) == app::DigitUse::Algorithm;
}

void Controller::endGesture()
{
    pointing_.stopPanning();
    held_.end();
}

std::optional<app::ObjectInHand> Controller::unfinished() const
{
    return held_.as<HasUnfinished>().unfinished(bench());
}

void Controller::transform(const app::Transformation& kind)
{
    endGesture();
    app::Session& session = this->session();
    if (session.selection().empty())
        session.select(app::justAdded(session));
    if (session.selection().empty()) {
        emit session.refused(app::withKeys(kind.needs));
        return;
    }
    if (toolInfo().key != "select")
        held_.choose("select");
    const app::Point middle = view().toDrawing(view().size * 0.5);
    const Pointer pointer =
        held_.pointer.value_or(Pointer{middle, middle, view().toScreen(middle), {}, {}, middle});
    held_.use([&](Tool& tool, Workbench& bench) {
        tool.as<Transforms>().transform(kind, pointer, bench);
    });
    typing_.steer();
}

bool Controller::handle(QEvent& event)
{
    switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
        pointing_.handle(static_cast<QMouseEvent&>(event));
        return true;
    case QEvent::Wheel:
        navigation_.wheel(static_cast<QWheelEvent&>(event));
        return true;
    case QEvent::NativeGesture:
        return navigation_.gesture(static_cast<QNativeGestureEvent&>(event));
    case QEvent::ShortcutOverride:
        return takesKey(static_cast<QKeyEvent&>(event), *this) && (event.accept(), true);
    case QEvent::KeyPress:
        return pressKey(static_cast<QKeyEvent&>(event), *this);
    case QEvent::KeyRelease:
        return releaseKey(static_cast<QKeyEvent&>(event), *this);
    case QEvent::Leave:
        pointing_.leave();
        return false;
    case QEvent::FocusOut:
        pointing_.setSpace(false);
        return false;
    default:
        return false;
    }
}

} // namespace ui

#include "moc_controller.cpp"
