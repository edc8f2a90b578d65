// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/panel_docks.h"

class QMainWindow;

namespace ui {

/// What decides how the program arranges the panels, apart from the window's size.
struct Situation {
    bool starting;          ///< the panel Start is wanted in front
    bool inspecting;        ///< the panel Line shows a line
    QList<Dock*> wide = {}; ///< the visible comparison panels, the newest last
};

/// Places the panels in a column at the right: one below the other; as tabs in a low window or
/// below comparison panels; or as tabs with Start in front. In a stack that is too low, the lowest
/// panels share a place as tabs.
class Arrangement {
public:
    enum class Form : std::uint8_t { Stacked, Tabs, StartInFront };
    static constexpr int narrowest = 272; ///< the least width of a panel, in logical pixels

    Arrangement(QMainWindow& window, PanelDocks docks);

    Form form() const { return form_; } ///< as placed last
    Form fitting(const Situation& situation) const;
    /// Whether the number of panels that share a place as tabs fits the window's current height.
    bool tabsFit() const { return neededTabs() == tabs_; }
    bool hasTabsBelow() const { return tabs_ > 0; } ///< in a stack, the lowest panels are tabs

    /// Places all panels in the fitting form. Closed comparison panels stay closed.
    void place(const Situation& situation);
    /// Shares the column's height among the panels of a stack: algorithm, clip window and selection get
    /// what they need, line and layers the rest.
    void shareHeight(const Situation& situation);

private:
    int neededTabs() const;
    void addDocks(const Situation& situation);
    int columnWidth(const Situation& situation) const;
    void shareHeightAbove(Dock& lower);
    void shareHeightWithWide(Dock& front);

    QMainWindow& window_;
    PanelDocks docks_;
    Form form_ = Form::Stacked;
    int tabs_ = 0; ///< how many of the stacked panels share the lowest place
};

} // namespace ui
