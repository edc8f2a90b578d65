// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/own_layout.h"

#include "app/base/read_strings.h"
#include "app/settings/remembered.h"

#include <QDataStream>
#include <QDockWidget>
#include <QMainWindow>
#include <QSettings>

namespace ui {

namespace {

constexpr int version = 1; // of the data of QMainWindow::saveState()
constexpr quint32 mostPanels = 100;
constexpr auto group = "layouts";

} // namespace

OwnLayout::OwnLayout(QMainWindow& window) : window_(window) {}

void OwnLayout::watch(const QDockWidget& dock)
{
    connect(&dock, &QDockWidget::topLevelChanged, this, &OwnLayout::notice);
    connect(&dock, &QDockWidget::dockLocationChanged, this, &OwnLayout::notice);
}

void OwnLayout::notice()
{
    if (!byProgram_ && window_.isVisible())
        exists_ = true;
}

QByteArray OwnLayout::state() const
{
    QStringList open;
    for (const QDockWidget* dock : docks())
        if (!dock->isHidden())
            open << dock->objectName();
    QByteArray state;
    QDataStream stream(&state, QIODevice::WriteOnly);
    stream << open << window_.saveState(version);
    return state;
}

QList<QDockWidget*> OwnLayout::docks() const
{
    return window_.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly);
}

void OwnLayout::keep(const QByteArray& state)
{
    if (exists_)
        layouts_[workspace_] = state;
    else
        layouts_.remove(workspace_);
}

void OwnLayout::show()
{
    const auto own = layouts_.constFind(workspace_);
    exists_ = own != layouts_.cend();
    if (!exists_)
        return;
    QDataStream stream(*own);
    const QStringList open = app::readStrings(stream, mostPanels);
    QByteArray places;
    stream >> places;
    exists_ = window_.restoreState(places, version);
    // It also shows docks that its data do not name.
    for (QDockWidget* dock : docks())
        if (exists_ && !open.contains(dock->objectName()))
            dock->hide();
}

void OwnLayout::choose(const QString& workspace)
{
    keep(state());
    workspace_ = workspace;
    show();
}

void OwnLayout::save(const QByteArray& state)
{
    keep(state);
    QSettings settings;
    settings.beginGroup(group);
    settings.remove(QString());
    for (auto own = layouts_.cbegin(); own != layouts_.cend(); ++own)
        settings.setValue(own.key(), app::sealed(own.value()));
}

void OwnLayout::restore(const QString& workspace)
{
    QSettings settings;
    settings.beginGroup(group);
    for (const QString& key : settings.childKeys())
        if (const auto layout = app::unsealed(settings.value(key).toByteArray()))
            layouts_[key] = *layout;
    workspace_ = workspace;
    show();
}

} // namespace ui

#include "moc_own_layout.cpp"
