// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/panes.h"

#include <QObject>

#include <map>
#include <optional>
#include <string_view>

namespace app {
class Session;
}

namespace ui {

class Canvas;
struct Workspace;

/// The panes of each workspace. They are shown again when it is chosen, and kept in the settings.
class WorkspacePanes : public QObject {
    Q_OBJECT

public:
    WorkspacePanes(app::Session& session, Canvas& canvas, QObject* parent);

    void choose(const Workspace& workspace);

signals:
    void changed(); ///< the person has changed those of the chosen workspace

private:
    app::Panes panesOf(const Workspace& workspace) const;
    void note();

    app::Session& session_;
    Canvas& canvas_;
    const Workspace* workspace_ = nullptr;
    std::map<std::string_view, app::Panes> panes_; ///< of the workspaces that were seen, by key
    bool choosing_ = false;
};

} // namespace ui
