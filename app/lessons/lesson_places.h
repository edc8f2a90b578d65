// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

class QSettings;

namespace app {

/// The lesson files and folders that were opened last, as full paths, so that the next run of the
/// program has their lessons, too. At most 12; the settings are read as untrusted input.
QStringList lessonPlaces(const QSettings& settings);
void keepLessonPlaces(QSettings& settings, const QStringList& paths);
void forgetLessonPlace(QSettings& settings, const QString& folder); ///< and its files

} // namespace app
