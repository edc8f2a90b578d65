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
    QList<Dock*> wide = {}; ///< the visible comparison panels, the newest last
};

/// Places the panels of a workspace in a column at the right: one below the other; or as tabs with
/// Start in front. Other comparison panels that are open share the highest place. In a stack that
/// is too low, the lowest panels that are not folded share a place as tabs. Nothing depends on what
/// is selected.
class Arrangement {
public:
    enum class Form : std::uint8_t { Stacked, StartInFront };
    static constexpr int narrowest = 272; ///< the least width of a panel, in logical pixels

    Arrangement(QMainWindow& window, PanelDocks docks);

    static Form fitting(const Situation& situation)
    {
        return situation.starting ? Form::StartInFront : Form::Stacked;
    }
    /// Whether the panels are placed as they fit the window's current height.
    bool fits(const Situation& situation) const
    {
        return form_ == fitting(situation) && (form_ != Form::Stacked || neededTabs() == tabs_);
    }

    /// Whether some of the panels that are not folded must share a place as tabs.
    bool needsTabs() const { return neededTabs() > 0; }
    QList<Dock*> unfolded() const; ///< the stacked panels that have more than their heading

    /// Places the panels in the fitting form. Closed comparison panels stay closed.
    void place(const Situation& situation);
    /// Gives the panels of fixed height what they need; the others share the rest.
    void shareHeight();

private:
    int neededTabs() const;
    void addDocks();
    void raiseDocks(const Situation& situation);
    int columnWidth(const Situation& situation) const;

    QMainWindow& window_;
    PanelDocks docks_;
    Form form_ = Form::Stacked;
    QList<Dock*> column_; ///< the panels with places of their own, from top to bottom
    QList<Dock*> beside_; ///< the comparison panels that share the highest place
    int tabs_ = 0;        ///< how many of the stacked panels share the lowest place
};

/// How many panels of a stack, counted from below, must share the lowest place as tabs so that none
/// is smaller than it needs. `needed` are the heights of the panels from top to bottom, `room` is
/// the height of the column, in logical pixels. 0: all fit one below the other. Otherwise at least
/// 2; all, if nothing else helps.
int lowerTabs(std::span<const int> needed, int room);

} // namespace ui
