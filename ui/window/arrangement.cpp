// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/arrangement.h"

#include "ui/look/look.h"
#include "ui/window/stacking.h"

#include <QMainWindow>

#include <algorithm>
#include <utility>
#include <vector>

namespace ui {

namespace {

// Logical pixels.
constexpr int wide = 1200, high = 780; // below these sizes: narrow panels; tabs instead of a stack
constexpr int usualWidth = 336, startWidth = 396, widest = 572;
constexpr int separator = 4;   // between two panels
constexpr int barsHeight = 90; // menus, option bar and status bar, before they are laid out
constexpr int barsAndSeparators = 120;
constexpr int emptyLine = 90;   // the height of the panel Line without a line
constexpr int leastRest = 160;  // for line and layers together
constexpr int leastBelow = 190; // for the panels below a comparison panel

int wantedHeight(const Dock* dock)
{
    return dock->widget()->sizeHint().height() + space::dockTitleHeight;
}

int leastHeight(const Dock* dock)
{
    return dock->widget()->minimumSizeHint().height() + space::dockTitleHeight + separator;
}

} // namespace

Arrangement::Arrangement(QMainWindow& window, PanelDocks docks)
    : window_(window), docks_(std::move(docks))
{
}

Arrangement::Form Arrangement::fitting(const Situation& situation) const
{
    return situation.starting                                   ? Form::StartInFront
           : window_.height() < high || !situation.wide.empty() ? Form::Tabs
                                                                : Form::Stacked;
}

int Arrangement::neededTabs() const
{
    const int room =
        window_.isVisible() ? window_.centralWidget()->height() : window_.height() - barsHeight;
    std::vector<int> needed;
    for (const Dock* dock : docks_.stack())
        needed.push_back(leastHeight(dock));
    return lowerTabs(needed, room);
}

void Arrangement::place(const Situation& situation)
{
    form_ = fitting(situation);
    tabs_ = form_ == Form::Stacked ? neededTabs() : 0;
    for (Dock* dock : docks_.all()) {
        dock->setFloating(false);
        window_.removeDockWidget(dock);
    }
    addDocks(situation);
    docks_.window->raise();
    Dock* const front = form_ == Form::StartInFront ? docks_.start
                        : situation.wide.empty()    ? docks_.algorithm
                                                    : situation.wide.last();
    front->raise();
    window_.resizeDocks({docks_.algorithm}, {columnWidth(situation)}, Qt::Horizontal);
    if (form_ == Form::Stacked)
        shareHeight(situation);
    else if (!situation.wide.empty())
        shareHeightWithWide(*situation.wide.last());
}

void Arrangement::addDocks(const Situation& situation)
{
    const bool allTabs = form_ != Form::Stacked;
    // No line is selected yet, or Start is finished.
    Dock* const hidden = form_ == Form::StartInFront ? docks_.line : docks_.start;
    const QList<Dock*> stack = docks_.stack();
    Dock* last = nullptr;
    for (Dock* dock : situation.wide + docks_.narrow()) {
        if (dock == hidden && !allTabs)
            continue; // not even behind another panel, whose title would then be in a tab
        if (dock == docks_.window && !situation.wide.empty())
            last = nullptr; // the panels from here on are below
        window_.addDockWidget(Qt::RightDockWidgetArea, dock);
        dock->setVisible(dock != hidden);
        const bool lower = stack.indexOf(dock) > stack.size() - tabs_; // except the first of them
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

void Arrangement::shareHeight(const Situation& situation)
{
    if (tabs_ > 0)
        return shareHeightAbove(*docks_.stack()[docks_.stack().size() - tabs_]);
    const int algorithm = wantedHeight(docks_.algorithm), window = wantedHeight(docks_.window),
              selection = wantedHeight(docks_.selection);
    const int rest =
        std::max(leastRest, window_.height() - barsAndSeparators - algorithm - window - selection);
    const int line = situation.inspecting ? rest * 11 / 20 : emptyLine;
    window_.resizeDocks(
        {docks_.algorithm, docks_.window, docks_.selection, docks_.line, docks_.layers},
        {algorithm, window, selection, line, rest - line}, Qt::Vertical);
}

/// `lower` holds the place of the lowest panels.
void Arrangement::shareHeightAbove(Dock& lower)
{
    QList<QDockWidget*> docks;
    QList<int> heights;
    int rest = window_.height() - barsHeight;
    for (Dock* dock : {docks_.algorithm, docks_.window, docks_.selection}) {
        if (dock == &lower)
            break;
        docks << dock;
        heights << wantedHeight(dock);
        rest -= heights.last();
    }
    window_.resizeDocks(docks << &lower, heights << std::max(leastRest, rest), Qt::Vertical);
}

/// The front panel gets the height it needs, as long as some is left for those below.
void Arrangement::shareHeightWithWide(Dock& front)
{
    const int all = window_.centralWidget()->height();
    const int above = std::min(wantedHeight(&front), all - leastBelow);
    window_.resizeDocks({&front, docks_.window}, {above, all - above}, Qt::Vertical);
}

} // namespace ui
