// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/own_layout.h"

#include "app/settings/seal.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QSettings>

namespace ui {

namespace {

constexpr int version = 1; // of the data of QMainWindow::saveState()

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

QByteArray OwnLayout::state() const { return window_.saveState(version); }

void OwnLayout::save(const QByteArray& state) const
{
    QSettings settings;
    settings.setValue("ownLayout", exists_);
    if (exists_)
        settings.setValue("layout", app::sealed(state));
}

void OwnLayout::restore()
{
    const QSettings settings;
    const auto layout = app::unsealed(settings.value("layout").toByteArray());
    exists_ =
        settings.value("ownLayout").toBool() && layout && window_.restoreState(*layout, version);
}

} // namespace ui
