// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/showing/show_steps.h"

#include "app/session/samples.h"
#include "ui/files/files.h"
#include "ui/look/text.h"
#include "ui/showing/shown_commands.h"
#include "ui/showing/shown_counts.h"
#include "ui/showing/step_player.h"
#include "ui/window/drawings.h"
#include "ui/window/main_window.h"
#include "ui/window/workspaces.h"

#include <QPointer>

#include <algorithm>
#include <memory>

namespace ui {

namespace {

QString cannot(const QString& why)
{
    return Text::tr("The steps of this page cannot be shown: %1").arg(why);
}

std::vector<double> countsNow(const MainWindow& window, const std::vector<app::ShownEnd>& ends)
{
    std::vector<double> counts;
    for (const app::ShownEnd& end : ends)
        counts.push_back(shownCount(end.what)->count(window));
    return counts;
}

bool hasEnded(const MainWindow& window, const std::vector<app::ShownEnd>& ends,
              const std::vector<double>& before)
{
    const std::vector<double> now = countsNow(window, ends);
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (now[i] != ends[i].number + (ends[i].isMore ? before[i] : 0))
            return false;
    return true;
}

/// Tool, workspace and snapping go along from tab to tab: the person gets back those of before.
void closeShown(MainWindow& shown, const MainWindow* from)
{
    if (from) {
        const Theme theme = shown.theme();
        shown.takeOver(*from);
        if (shown.theme() != theme)
            shown.setTheme(theme);
    }
    shown.session().history.setClean(); // which the question would be about
    if (shown.drawings())
        shown.drawings()->close(shown);
}

void tellEnd(MainWindow& shown, const QPointer<MainWindow>& from, bool wholly, bool asSaid)
{
    const QString sentence =
        !wholly  ? Text::tr("The show has ended. Your own drawing is as it was.")
        : asSaid ? Text::tr("These were the steps of the page. Your own drawing is as it was.")
                 : Text::tr("In this drawing the steps did not end as the page says. Your own "
                            "drawing is as it was.");
    shown.tell({wholly && !asSaid ? Message::Kind::Warning : Message::Kind::Done, sentence,
                Text::tr("Close this drawing"),
                [&shown, from] { closeShown(shown, from.data()); }});
}

/// What belongs to the program, not to the drawing, as it is at the first start: a page tells of
/// this state.
void begin(MainWindow& shown)
{
    shown.choose(findWorkspace("workspace-cut"));
    Canvas& canvas = shown.canvas();
    canvas.setTool("select");
    canvas.switchSnapping(true);
    app::Panes panes = canvas.panes();
    panes.show(1);
    canvas.setPanes(panes);
    shown.session().changeDisplay([](app::Display& display) { display.grid.shown = false; });
}

constexpr const char* shownFrom = "shownFrom"; // a property of a window that shows steps

/// The person's own drawing: a show may be asked for in the drawing of another one.
QPointer<MainWindow> ownOf(MainWindow& asking)
{
    const QVariant from = asking.property(shownFrom);
    return from.isValid() ? qobject_cast<MainWindow*>(from.value<QPointer<QObject>>().data())
                          : &asking;
}

void play(MainWindow& shown, const QPointer<MainWindow>& from, const app::ShownSteps& steps)
{
    shown.setProperty(shownFrom, QVariant::fromValue(QPointer<QObject>(from.data())));
    begin(shown);
    auto* player = new StepPlayer(shown, steps.steps);
    // What was shown is no work of the person, so nothing asks to save it.
    const auto forgive = [&shown] { shown.session().history.setClean(); };
    QObject::connect(player, &StepPlayer::stepDone, &shown, forgive);
    QObject::connect(player, &StepPlayer::ended, &shown,
                     [&shown, from, player, forgive, ends = steps.ends,
                      before = countsNow(shown, steps.ends)](bool wholly) {
                         forgive();
                         player->deleteLater();
                         tellEnd(shown, from, wholly, hasEnded(shown, ends, before));
                     });
    player->begin();
}

} // namespace

QString faultOf(MainWindow& window, const app::ShownSteps& steps)
{
    for (const app::ShownStep& step : steps.steps)
        if (step.kind == app::ShownStep::Kind::Command && !commandToShow(window, step.command))
            return cannot(Text::tr("it has no command \"%1\" to show.").arg(step.command));
    for (const app::ShownEnd& end : steps.ends)
        if (!shownCount(end.what))
            return cannot(Text::tr("\"%1\" cannot be counted.").arg(end.what));
    const auto all = app::samples();
    if (!steps.sample.isEmpty()
        && std::ranges::find(all, steps.sample, &app::Sample::key) == all.end())
        return cannot(Text::tr("there is no sample \"%1\".").arg(steps.sample));
    return {};
}

app::Document drawingFor(const app::Document& own, const app::ShownSteps& steps)
{
    if (steps.areIn(own))
        return own;
    for (const app::Sample& sample : app::samples())
        if (sample.key == steps.sample)
            if (auto read = app::readFile(sample.file))
                return read.value->document;
    return app::newDrawing();
}

QString showSteps(MainWindow& from, const app::ManualPage& page)
{
    const auto steps = app::shownSteps(page.shows);
    if (!steps)
        return steps.error;
    if (const QString fault = faultOf(from, *steps.value); !fault.isEmpty())
        return fault;
    if (!from.drawings())
        return cannot(Text::tr("this window has no place for a further drawing."));
    from.canvas().endGesture(); // a copy has what is seen
    app::Document drawing = drawingFor(from.session().now(), *steps.value);
    MainWindow* const shown = from.drawings()->addEmpty();
    if (!shown)
        return {};
    shown->window()->activateWindow();
    shown->files().openMade(
        std::move(drawing), Text::tr("Shown: %1").arg(page.title),
        [shown = QPointer(shown), from = ownOf(from), steps = *steps.value](app::Session* opened) {
            if (shown && opened)
                play(*shown, from, steps);
        });
    return {};
}

} // namespace ui
