// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTabBar>

namespace ui {

class PanelLayout;

/// The workspaces as tabs, at the right of the menu bar.
class WorkspaceTabs : public QTabBar {
    Q_OBJECT

public:
    explicit WorkspaceTabs(PanelLayout& layout, QWidget* parent = nullptr);

protected:
    QSize tabSizeHint(int tab) const override; ///< so low that the menu bar is not higher
};

} // namespace ui
