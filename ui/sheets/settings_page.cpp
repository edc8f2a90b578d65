// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/settings_page.h"

#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/segments.h"
#include "ui/window/main_window.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QStyle>

namespace ui {

namespace {

/// A part of a switch begins below the switch's text.
int widthOfMark(const QCheckBox& box)
{
    const QStyle& style = *box.style();
    return style.pixelMetric(QStyle::PM_IndicatorWidth)
           + style.pixelMetric(QStyle::PM_CheckBoxLabelSpacing);
}

} // namespace

SettingsPage::SettingsPage(MainWindow& window, QWidget* parent) : QWidget(parent), window_(window)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    for (const SettingsGroup& group : settingsGroups())
        addGroup(group);
    column->addStretch();
}

void SettingsPage::addGroup(const SettingsGroup& group)
{
    auto& column = static_cast<QVBoxLayout&>(*layout());
    if (column.count() > 0)
        column.addWidget(rule(Qt::Horizontal));
    auto* grid = new QGridLayout;
    grid->setContentsMargins(space::dockMargin, space::dockMargin, space::dockMargin,
                             space::dockMargin);
    grid->setHorizontalSpacing(space::labelToField);
    grid->setVerticalSpacing(5);
    grid->setColumnStretch(1, 1);
    auto* title = new QLabel(group.title);
    title->setFont(semiBold(font()));
    grid->addWidget(title, 0, 0, 1, 3);
    for (const Setting& setting : group.settings)
        addSetting(setting, *grid);
    column.addLayout(grid);
}

void SettingsPage::addSetting(const Setting& setting, QGridLayout& grid)
{
    const int row = grid.rowCount();
    setting.choices.empty() ? addSwitch(setting, grid, row) : addChoices(setting, grid, row);
    addReset(setting, grid, row);
}

void SettingsPage::addSwitch(const Setting& setting, QGridLayout& grid, int row)
{
    auto* box = new QCheckBox(setting.text);
    box->setObjectName(QStringLiteral("setting-") + setting.key);
    box->setToolTip(setting.tip);
    auto* place = new QHBoxLayout;
    place->setContentsMargins(setting.counts ? widthOfMark(*box) : 0, 0, 0, 0);
    place->addWidget(box);
    grid.addLayout(place, row, 0, 1, 2);
    connect(box, &QCheckBox::clicked, this,
            [this, &setting](bool on) { change(setting, window_, on); });
    const auto follow = [this, box, &setting] {
        box->setChecked(setting.value(window_) == 1);
        box->setEnabled(!setting.counts || setting.counts(window_));
    };
    connect(&window_, &MainWindow::actionsOutdated, box, follow);
    follow();
}

void SettingsPage::addChoices(const Setting& setting, QGridLayout& grid, int row)
{
    QStringList texts;
    for (const Setting::Choice& choice : setting.choices)
        texts << choice.text;
    auto* choices = new Segments(setting.text, texts);
    choices->setObjectName(QStringLiteral("setting-") + setting.key);
    choices->setToolTip(setting.tip);
    auto* label = quietLabel(setting.text);
    label->setToolTip(setting.tip);
    grid.addWidget(label, row, 0);
    grid.addWidget(choices, row, 1, Qt::AlignLeft);
    connect(choices, &Segments::picked, this,
            [this, &setting](int chosen) { change(setting, window_, chosen); });
    const auto follow = [this, choices, &setting] {
        const int now = setting.value(window_);
        now < 0 ? choices->chooseNone() : choices->choose(now);
    };
    connect(&window_, &MainWindow::actionsOutdated, choices, follow);
    follow();
}

/// It is seen only where it would change something, and keeps its place.
void SettingsPage::addReset(const Setting& setting, QGridLayout& grid, int row)
{
    const QString& name = setting.command.isEmpty() ? setting.text : setting.command;
    auto* button = iconButton("undo", Text::tr("Reset “%1” to standard").arg(name));
    button->setObjectName(QStringLiteral("reset-") + setting.key);
    button->setFocusPolicy(Qt::TabFocus);
    keepPlaceWhenHidden(*button);
    grid.addWidget(button, row, 2);
    connect(button, &QToolButton::clicked, this, [this, &setting] {
        focusNextChild(); // it is about to be hidden
        ui::reset(setting, window_);
    });
    const auto follow = [this, button, &setting] {
        button->setVisible(setting.value(window_) != setting.standard(window_));
    };
    connect(&window_, &MainWindow::actionsOutdated, button, follow);
    follow();
}

void SettingsPage::reset()
{
    for (const SettingsGroup& group : settingsGroups())
        for (const Setting& setting : group.settings)
            if (setting.value(window_) != setting.standard(window_))
                ui::reset(setting, window_);
}

} // namespace ui

#include "moc_settings_page.cpp"
