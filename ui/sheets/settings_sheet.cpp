// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/settings_sheet.h"

#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/sheets/command_keys.h"
#include "ui/sheets/keyboard_page.h"
#include "ui/sheets/settings_page.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/segments.h"

#include <QVBoxLayout>

namespace ui {

SettingsSheet::SettingsSheet(MainWindow& window)
    : Sheet(QStringLiteral("settings"), Text::tr("Settings"), Width::Wide),
      pages_(new Segments(Text::tr("Page"), {Text::tr("General"), Text::tr("Keyboard")})),
      general_(new SettingsPage(window)), keyboard_(new KeyboardPage(CommandKeys::of(window))),
      reset_(plainButton({}))
{
    pages_->setObjectName(QStringLiteral("settings-page"));
    auto* above = new QHBoxLayout;
    above->setContentsMargins(space::dockMargin, space::labelToField, space::dockMargin,
                              space::labelToField);
    above->addWidget(pages_);
    above->addStretch();
    body().addLayout(above);
    body().addWidget(general_, 1);
    body().addWidget(keyboard_, 1);
    reset_->setObjectName(QStringLiteral("reset-settings"));
    addToFoot(reset_, Side::Left);
    auto* done = plainButton(Text::tr("Done"));
    done->setObjectName(QStringLiteral("done"));
    addToFoot(done);
    connect(pages_, &Segments::picked, this, &SettingsSheet::turnTo);
    connect(reset_, &QPushButton::clicked, this,
            [this] { general_->isHidden() ? keyboard_->reset() : general_->reset(); });
    connect(done, &QPushButton::clicked, this, &Sheet::closeWanted);
    turnTo(General);
}

void SettingsSheet::turnTo(int page)
{
    pages_->choose(page);
    general_->setVisible(page == General);
    keyboard_->setVisible(page == Keyboard);
    reset_->setText(page == General ? Text::tr("Reset all to standard")
                                    : Text::tr("Reset all keys"));
}

} // namespace ui

#include "moc_settings_sheet.cpp"
