// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/settings_sheet.h"

#include "ui/look/text.h"
#include "ui/sheets/settings_page.h"
#include "ui/widgets/buttons.h"

#include <QVBoxLayout>

namespace ui {

SettingsSheet::SettingsSheet(MainWindow& window)
    : Sheet(QStringLiteral("settings"), Text::tr("Settings"), Width::Wide)
{
    auto* page = new SettingsPage(window);
    body().addWidget(page);
    auto* reset = plainButton(Text::tr("Reset all to standard"));
    reset->setObjectName(QStringLiteral("reset-settings"));
    addToFoot(reset);
    auto* done = plainButton(Text::tr("Done"));
    done->setObjectName(QStringLiteral("done"));
    addToFoot(done);
    connect(reset, &QPushButton::clicked, page, &SettingsPage::reset);
    connect(done, &QPushButton::clicked, this, &Sheet::closeWanted);
}

} // namespace ui

#include "moc_settings_sheet.cpp"
