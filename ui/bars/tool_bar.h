// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/canvas.h"

#include <QToolBar>

namespace ui {

struct ToolInfo;

/// The bar at the side: one button for each tool of the catalogue. A tool's key works while the
/// canvas has the focus. To choose a tool leaves the microscope.
class ToolBar : public QToolBar {
    Q_OBJECT

public:
    ToolBar(app::Session& session, Canvas& canvas);

    QList<QAction*> tools() const { return tools_; } ///< in the order of the catalogue

private:
    QAction* makeAction(const ToolInfo& tool);
    void addTool(QAction* action);

    app::Session& session_;
    Canvas& canvas_;
    QList<QAction*> tools_;
};

} // namespace ui
