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
constexpr int high = 780;  // in a lower one they are tabs, except below a folded panel
constexpr int usualWidth = 336, startWidth = 396, widest = 572;
constexpr int separator = 4;    // between two panels
constexpr int barsHeight = 90;  // menus, option bar and status bar, before they are laid out
constexpr int leastRest = 160;  // for the panels that grow with the window
constexpr int leastBelow = 190; // for the panels below a comparison panel

int wantedHeight(const Dock* dock)
{
    return dock->widget()->sizeHint().height() + space::dockTitleHeight;
}

int leastHeight(const Dock* dock)
{
    const QWidget& widget = *dock->widget();
    const int body = std::max(widget.minimumSizeHint().height(), widget.minimumHeight());
    return (dock->isFolded() ? 0 : body) + space::dockTitleHeight + separator;
}

/// Lists take what the panels of fixed height leave.
bool grows(const Dock* dock)
{
    return dock->widget()->sizePolicy().verticalPolicy() & QSizePolicy::ExpandFlag;
}

} // namespace

Arrangement::Arrangement(QMainWindow& window, PanelDocks docks)
    : window_(window), docks_(std::move(docks))
{
}

Arrangement::Form Arrangement::fitting(const Situation& situation) const
{
    if (situation.starting)
        return Form::StartInFront;
    const bool low = window_.height() < high && !situation.folded;
    return low || !situation.wide.empty() ? Form::Tabs : Form::Stacked;
}

int Arrangement::neededTabs() const
{
    const int room =
        window_.isVisible() ? window_.centralWidget()->height() : window_.height() - barsHeight;
    std::vector<int> needed;
    for (const Dock* dock : column_)
        needed.push_back(leastHeight(dock));
    return lowerTabs(needed, room);
}

void Arrangement::place(const Situation& situation)
{
    form_ = fitting(situation);
    column_ = docks_.named(situation.workspace->column);
    docks_.algorithm->setFolded(form_ == Form::Stacked && situation.folded);
    tabs_ = form_ == Form::Stacked ? neededTabs() : 0;
    for (Dock* dock : docks_.all()) {
        dock->setFloating(false);
        window_.removeDockWidget(dock);
    }
    addDocks(situation);
    Dock* const second = column_[1];
    second->raise();
    if (tabs_ > 0)
        column_[column_.size() - tabs_]->raise();
    Dock* const front = form_ == Form::StartInFront                         ? docks_.start
                        : !situation.wide.empty()                           ? situation.wide.last()
                        : form_ == Form::Tabs && situation.workspace->folds ? second
                                                                            : docks_.algorithm;
    front->raise();
    window_.resizeDocks({form_ == Form::StartInFront ? docks_.start : docks_.algorithm},
                        {columnWidth(situation)}, Qt::Horizontal);
    if (form_ == Form::Stacked)
        shareHeight();
    else if (!situation.wide.empty())
        shareHeightWithWide(*situation.wide.last());
}

void Arrangement::addDocks(const Situation& situation)
{
    const bool allTabs = form_ != Form::Stacked;
    QList<Dock*> docks = situation.wide;
    if (form_ == Form::StartInFront)
        docks << docks_.start;
    Dock* last = nullptr;
    for (Dock* dock : docks + column_) {
        if (dock == column_[1] && !situation.wide.empty())
            last = nullptr; // the panels from here on are below
        window_.addDockWidget(Qt::RightDockWidgetArea, dock);
        dock->show();
        const bool lower = column_.indexOf(dock) > column_.size() - tabs_; // except the first
        if ((allTabs || lower) && last)
            window_.tabifyDockWidget(last, dock);
        last = dock;
    }
}

int Arrangement::columnWidth(const Situation& situation) const
{
    const int width = window_.width();
    if (!situation.wide.empty())
        return std::clamp(width * 9 / 20, narrowest, widest);
    return width < wide ? narrowest : situation.starting ? startWidth : usualWidth;
}

/// The panels of fixed height get what they need, the others share the rest.
void Arrangement::shareHeight()
{
    QList<QDockWidget*> docks;
    QList<int> heights;
    QList<qsizetype> growing;
    int rest = window_.height() - barsHeight;
    for (qsizetype i = 0; i <= column_.size() - std::max(tabs_, 1); ++i) {
        const Dock* dock = column_[i];
        docks << column_[i];
        heights << (dock->isFolded() ? space::dockTitleHeight : wantedHeight(dock));
        if (grows(dock) || (tabs_ > 0 && i == column_.size() - tabs_))
            growing << i;
        else
            rest -= heights.last() + separator;
    }
    for (const qsizetype i : growing)
        heights[i] = std::max(leastRest, rest) / int(growing.size());
    window_.resizeDocks(docks, heights, Qt::Vertical);
}

/// The front panel gets the height it needs, as long as some is left for those below.
void Arrangement::shareHeightWithWide(Dock& front)
{
    const int all = window_.centralWidget()->height();
    const int above = std::min(wantedHeight(&front), all - leastBelow);
    window_.resizeDocks({&front, column_[1]}, {above, all - above}, Qt::Vertical);
}

int lowerTabs(std::span<const int> needed, int room)
{
    const int all = std::accumulate(needed.begin(), needed.end(), 0);
    if (needed.empty() || all <= room)
        return 0;
    int below = needed.back();
    int above = all - below;
    for (std::size_t tabs = 2; tabs < needed.size(); ++tabs) {
        const int next = needed[needed.size() - tabs];
        above -= next;
        below = std::max(below, next);
        if (above + below <= room || tabs + 1 == needed.size())
            return int(tabs);
    }
    return 0;
}

} // namespace ui
