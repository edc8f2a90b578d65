// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QSettings>

namespace app {

/// The settings in an INI text that QSettings of an earlier version wrote: texts (numbers and truth
/// values are texts there), lists of texts, and bytes. Any other line or value is left out: Qt's
/// own parser builds any type that a text names, and some texts then crash it.
QSettings::SettingsMap settingsOfIni(const QByteArray& text);

} // namespace app
