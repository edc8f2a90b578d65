// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/panels.h"
#include "ui/window/workspaces.h"

#include <span>

class QMainWindow;

namespace ui {

/// What decides how the program arranges the panels, apart from the window's size.
struct Situation {
    const Workspace* workspace;
    bool starting;          ///< the panel Start is wanted in front
    bool folded;            ///< the panel Algorithm is only a title where it has a place of its own
    QList<Dock*> wide = {}; ///< the visible comparison panels, the newest last
};

/// Places the panels of a workspace in a column at the right: one below the other; as tabs in a low
/// window, unless the panel Algorithm is folded, or below comparison panels; or as tabs with Start
/// in front. In a stack that is too low, the lowest panels share a place as tabs. Nothing depends
/// on what is selected.
class Arrangement {
public:
    enum class Form : std::uint8_t { Stacked, Tabs, StartInFront };
    static constexpr int narrowest = 272; ///< the least width of a panel, in logical pixels

    Arrangement(QMainWindow& window, PanelDocks docks);

    Form form() const { return form_; } ///< as placed last
    Form fitting(const Situation& situation) const;
    /// Whether the number of panels that share a place as tabs fits the window's current height.
    bool tabsFit() const { return neededTabs() == tabs_; }

    /// Places the panels in the fitting form. Closed comparison panels stay closed.
    void place(const Situation& situation);

private:
    int neededTabs() const;
    void choosePanels(const Situation& situation);
    void addDocks(const Situation& situation);
    int columnWidth(const Situation& situation) const;
    void shareHeight();
    void shareHeightWithWide(Dock& front);

    QMainWindow& window_;
    PanelDocks docks_;
    Form form_ = Form::Stacked;
    QList<Dock*> column_; ///< the workspace's panels, from top to bottom
    int tabs_ = 0;        ///< how many of the stacked panels share the lowest place
};

/// How many panels of a stack, counted from below, must share the lowest place as tabs so that none
/// is smaller than it needs. `needed` are the heights of the panels from top to bottom, `room` is
/// the height of the column, in logical pixels. 0: all fit one below the other. Otherwise at least
/// 2, and the first panel always keeps a place of its own, even if the room is too small for that.
int lowerTabs(std::span<const int> needed, int room);

} // namespace ui
