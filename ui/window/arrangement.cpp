// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/arrangement.h"

#include "ui/look/look.h"

#include <QMainWindow>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace ui {

namespace {

// Logical pixels.
constexpr int wide = 1200; // in a narrower window, panels are narrow
constexpr int usualWidth = 336, startWidth = 396, widest = 572;
constexpr int separator = 4;   // between two panels
constexpr int barsHeight = 90; // menus, option bar and status bar, before they are laid out
constexpr int leastRest = 160; // for the panels that grow with the window
constexpr int slack = 2; // a window cannot be made lower than its panels: they become tabs before

int wantedHeight(const Dock* dock)
{
    return dock->body().sizeHint().height() + space::dockTitleHeight;
}

int leastHeight(const Dock* dock)
{
    const QWidget& widget = dock->body();
    const int body = std::max(widget.minimumSizeHint().height(), widget.minimumHeight());
    return body + space::dockTitleHeight + separator;
}

/// Lists take what the panels of fixed height leave.
bool grows(const Dock* dock)
{
    return dock->body().sizePolicy().verticalPolicy() & QSizePolicy::ExpandFlag;
}

} // namespace

Arrangement::Arrangement(QMainWindow& window, PanelDocks docks)
    : window_(window), docks_(std::move(docks))
{
}

QList<Dock*> Arrangement::unfolded() const
{
    QList<Dock*> docks;
    for (Dock* dock : column_)
        if (!dock->isFolded())
            docks << dock;
    return docks;
}

int Arrangement::neededTabs() const
{
    const QList<Dock*> docks = unfolded();
    int room =
        window_.isVisible() ? window_.centralWidget()->height() : window_.height() - barsHeight;
    room -= int(column_.size() - docks.size()) * (space::dockTitleHeight + separator) + slack;
    std::vector<int> needed;
    for (const Dock* dock : docks)
        needed.push_back(leastHeight(dock));
    return lowerTabs(needed, room);
}

void Arrangement::place(const Situation& situation)
{
    form_ = fitting(situation);
    column_ = docks_.named(situation.workspace->column);
    column_.removeIf(
        [&](Dock* dock) { return docks_.wide.contains(dock) && !situation.wide.contains(dock); });
    beside_ = situation.wide;
    beside_.removeIf([this](Dock* dock) { return column_.contains(dock); });
    if (!beside_.empty() && (column_.empty() || !docks_.wide.contains(column_.front())))
        column_.prepend(beside_.takeFirst());
    tabs_ = form_ == Form::Stacked ? neededTabs() : 0;
    for (Dock* dock : docks_.all()) {
        dock->setFloating(false);
        window_.removeDockWidget(dock);
    }
    addDocks();
    raiseDocks(situation);
    window_.resizeDocks({form_ == Form::StartInFront ? docks_.start : column_.front()},
                        {columnWidth(situation)}, Qt::Horizontal);
    if (form_ == Form::Stacked)
        shareHeight();
}

void Arrangement::addDocks()
{
    const auto add = [this](Dock* dock, Dock* inPlaceOf) {
        window_.addDockWidget(Qt::RightDockWidgetArea, dock);
        dock->show();
        if (inPlaceOf)
            window_.tabifyDockWidget(inPlaceOf, dock);
    };
    const QList<Dock*> whole = unfolded();
    const QList<Dock*> lowest = tabs_ > 0 ? whole.mid(whole.size() - tabs_) : QList<Dock*>{};
    Dock* last = nullptr;
    if (form_ == Form::StartInFront)
        add(last = docks_.start, nullptr);
    for (Dock* dock : column_) {
        const bool shares =
            form_ == Form::StartInFront || (lowest.contains(dock) && dock != lowest.front());
        add(dock, shares ? last : nullptr);
        if (form_ == Form::StartInFront || lowest.contains(dock))
            last = dock;
        if (dock == column_.front())
            for (Dock* other : beside_)
                add(other, dock);
    }
}

/// The highest of panels that share a place is in front, or the newest comparison panel.
void Arrangement::raiseDocks(const Situation& situation)
{
    const QList<Dock*> whole = unfolded();
    if (tabs_ > 0)
        whole[whole.size() - tabs_]->raise();
    if (!beside_.empty())
        situation.wide.last()->raise();
    if (form_ == Form::StartInFront)
        docks_.start->raise();
}

int Arrangement::columnWidth(const Situation& situation) const
{
    const int width = window_.width();
    if (!situation.wide.empty())
        return std::clamp(width * 9 / 20, narrowest, widest);
    return width < wide ? narrowest : situation.starting ? startWidth : usualWidth;
}

void Arrangement::shareHeight()
{
    const QList<Dock*> whole = unfolded();
    const qsizetype lowest = whole.size() - std::max(tabs_, 1); // the place of the tabs
    QList<QDockWidget*> docks;
    QList<int> heights;
    QList<qsizetype> growing;
    int rest = window_.height() - barsHeight;
    for (Dock* dock : column_) {
        const qsizetype number = whole.indexOf(dock);
        if (number > lowest)
            continue;
        docks << dock;
        heights << (dock->isFolded() ? space::dockTitleHeight : wantedHeight(dock));
        if (number >= 0 && (grows(dock) || (tabs_ > 0 && number == lowest)))
            growing << heights.size() - 1;
        else
            rest -= heights.last() + separator;
    }
    for (const qsizetype i : growing)
        heights[i] = std::max(leastRest, rest) / int(growing.size());
    window_.resizeDocks(docks, heights, Qt::Vertical);
}

int lowerTabs(std::span<const int> needed, int room)
{
    int above = std::accumulate(needed.begin(), needed.end(), 0);
    if (needed.size() < 2 || above <= room)
        return 0;
    int below = 0;
    for (std::size_t tabs = 1; tabs <= needed.size(); ++tabs) {
        const int next = needed[needed.size() - tabs];
        above -= next;
        below = std::max(below, next);
        if (above + below <= room)
            return int(tabs);
    }
    return int(needed.size());
}

} // namespace ui
