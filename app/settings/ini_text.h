// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QSettings>

namespace app {

/// Reads the INI text that QSettings of an earlier version wrote: texts (numbers and truth values
/// are texts there), lists of texts, and bytes. Other lines and values are skipped: Qt's own parser
/// constructs any type that the text names, and crashes on some texts.
QSettings::SettingsMap settingsOfIni(const QByteArray& text);

} // namespace app
