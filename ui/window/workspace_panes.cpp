// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/workspace_panes.h"

#include "app/base/text.h"
#include "app/session/session.h"
#include "ui/canvas/canvas.h"
#include "ui/window/workspaces.h"

#include <QScopedValueRollback>
#include <QSettings>

namespace ui {

namespace {

QString settingOf(const Workspace& workspace)
{
    return QStringLiteral("panes/") + app::latin(workspace.key);
}

} // namespace

WorkspacePanes::WorkspacePanes(app::Session& session, Canvas& canvas, QObject* parent)
    : QObject(parent), session_(session), canvas_(canvas)
{
    connect(&canvas, &Canvas::panesChanged, this, &WorkspacePanes::note);
}

void WorkspacePanes::choose(const Workspace& workspace)
{
    if (workspace_ == &workspace)
        return;
    workspace_ = &workspace;
    session_.worksInCompare = workspace.compares;
    const QScopedValueRollback quiet(choosing_, true); // what is shown meanwhile is not chosen
    canvas_.setPanes(panesOf(workspace));
}

/// A single pane shows what the session shows.
app::Panes WorkspacePanes::panesOf(const Workspace& workspace) const
{
    const app::Variant chosen = session_.cuts();
    const auto seen = panes_.find(workspace.key);
    app::Panes panes =
        seen != panes_.end()
            ? seen->second
            : app::Panes::fromText(QSettings().value(settingOf(workspace)).toString(), chosen)
                  .value_or(app::Panes(chosen));
    if (panes.size() == 1)
        panes.choose(chosen);
    return panes;
}

void WorkspacePanes::note()
{
    if (choosing_ || !workspace_)
        return;
    panes_.insert_or_assign(workspace_->key, canvas_.panes());
    QSettings().setValue(settingOf(*workspace_), canvas_.panes().text());
    emit changed();
}

} // namespace ui

#include "moc_workspace_panes.cpp"
