// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/showing/step_beats.h"

#include "ui/showing/actor.h"
#include "ui/showing/shown_commands.h"

#include <QAbstractButton>
#include <QAction>

namespace ui {

namespace {

using Beats = std::deque<Beat>;
using Kind = app::ShownStep::Kind;

constexpr int perPlace = 22, perKey = 260, perButton = 220; // milliseconds
constexpr int places = 24; // of the pointer, from one point of a step to the next

/// In a straight line, slowly at its ends.
void addWay(Beats& beats, const app::Point& from, const app::Point& to,
            const std::function<void(const app::Point&)>& move)
{
    for (int i = 1; i <= places; ++i) {
        const double part = double(i) / places, eased = part * part * (3 - 2 * part);
        const app::Point place = i == places ? to : from + (to - from) * eased;
        beats.push_back({perPlace, [move, place] { move(place); }});
    }
}

void addPress(Beats& beats, const app::ShownStep& step, Actor& actor, QEvent::Type type)
{
    beats.push_back({perButton, [&actor, with = step.with, type] { actor.press(with, type); }});
}

void addRelease(Beats& beats, const app::ShownStep& step, Actor& actor)
{
    beats.push_back({perButton, [&actor, with = step.with] { actor.release(with); }});
}

void addPoints(Beats& beats, const app::ShownStep& step, Actor& actor)
{
    app::Point from = actor.at();
    for (const app::Point& point : step.points) {
        const app::Point to = actor.inDrawing(point);
        const bool isFirst = &point == &step.points.front();
        addWay(beats, from, to,
               [&actor, with = step.with](const app::Point& place) { actor.move(place, with); });
        if (isFirst && step.kind != Kind::Move)
            addPress(beats, step, actor, QEvent::MouseButtonPress);
        from = to;
    }
    if (step.kind != Kind::Move)
        addRelease(beats, step, actor);
    if (step.kind != Kind::DoubleClick)
        return;
    addPress(beats, step, actor, QEvent::MouseButtonDblClick);
    addRelease(beats, step, actor);
}

void addButton(Beats& beats, const QString& name, Actor& actor)
{
    const QPointer button(actor.button(name));
    if (!button)
        return;
    addWay(beats, actor.at(), actor.placeOf(*button),
           [&actor](const app::Point& place) { actor.pointAt(place); });
    beats.push_back({perButton, [&actor, button] {
                         if (button)
                             actor.press(*button);
                     }});
    beats.push_back({perButton, [&actor, button] {
                         if (button)
                             actor.release(*button);
                     }});
}

} // namespace

std::deque<Beat> beatsOf(const app::ShownStep& step, MainWindow& window, Actor& actor)
{
    Beats beats;
    if (!step.points.empty())
        addPoints(beats, step, actor);
    if (step.kind == Kind::Press)
        addButton(beats, step.button, actor);
    for (const auto& key : step.keys)
        beats.push_back({perKey, [&actor, key] { actor.type(key); }});
    if (step.kind == Kind::Command)
        beats.push_back({perButton, [&window, name = step.command] {
                             QAction* command = commandToShow(window, name);
                             if (command && command->isEnabled())
                                 command->trigger();
                         }});
    return beats;
}

} // namespace ui
