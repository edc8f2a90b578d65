// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/workspace_tabs.h"

#include "app/base/text.h"
#include "ui/look/key_tip.h"
#include "ui/look/text.h"
#include "ui/window/panel_layout.h"
#include "ui/window/workspaces.h"

#include <QSignalBlocker>

namespace ui {

WorkspaceTabs::WorkspaceTabs(PanelLayout& layout, QWidget* parent) : QTabBar(parent)
{
    setAccessibleName(Text::tr("Workspace"));
    setDrawBase(false);
    setExpanding(false);
    setFocusPolicy(Qt::NoFocus); // the menu View and Ctrl+Alt+digit serve the keyboard
    for (const Workspace& workspace : workspaces()) {
        const int tab = addTab(workspace.name);
        followKeys(*this, [this, tab, &workspace] {
            setTabToolTip(tab, app::withKeys(Text::tr("%1: %2 ({%3})")
                                                 .arg(workspace.name, workspace.tip,
                                                      app::latin(workspace.key))));
        });
    }
    const auto follow = [this, &layout] {
        const QSignalBlocker quiet(this);
        setCurrentIndex(int(&layout.workspace() - workspaces().data()));
    };
    connect(&layout, &PanelLayout::workspaceChanged, this, follow);
    connect(this, &QTabBar::tabBarClicked, this, [&layout](int tab) {
        if (tab >= 0)
            layout.choose(workspaces()[std::size_t(tab)]);
    });
    follow();
}

QSize WorkspaceTabs::tabSizeHint(int tab) const
{
    return {QTabBar::tabSizeHint(tab).width(), fontMetrics().height() + 6};
}

} // namespace ui

#include "moc_workspace_tabs.cpp"
