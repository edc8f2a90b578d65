// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sheets/setting.h"

#include <QWidget>

class QGridLayout;

namespace ui {

/// The settings of the program, group by group, each with a button that sets it as it was at first.
class SettingsPage : public QWidget {
    Q_OBJECT

public:
    explicit SettingsPage(MainWindow& window, QWidget* parent = nullptr);

    void reset(); ///< sets all as they were at first

private:
    void addGroup(const SettingsGroup& group);
    void addSetting(const Setting& setting, QGridLayout& grid);
    void addSwitch(const Setting& setting, QGridLayout& grid, int row);
    void addChoices(const Setting& setting, QGridLayout& grid, int row);
    void addReset(const Setting& setting, QGridLayout& grid, int row);

    MainWindow& window_;
};

} // namespace ui
