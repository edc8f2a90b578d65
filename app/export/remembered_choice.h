// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/export_area.h"

#include <QSettings>

namespace app {

/// The choice as one readable text, without the number of a window or a layer, which other drawings
/// have not: "png area=selection paper=area dpi=300 precision=-1 background=00000000 …".
QString textOf(const ExportChoice& choice);
/// The reverse. What is missing or not possible is as usual; empty if the format is unknown.
std::optional<ExportChoice> choiceOf(const QString& text);

/// The last export of a drawing.
struct DrawingExport {
    QString drawing; ///< its path
    QString file;    ///< the path of what was written
    ExportChoice choice{};
};
/// The last one of this drawing; empty: none is known.
std::optional<DrawingExport> lastExport(const QSettings& settings, const QString& drawing);
/// The last choice of this format, or the usual one.
ExportChoice lastChoice(const QSettings& settings, std::string_view format);
/// The format of the last export, or the first one.
std::string lastFormat(const QSettings& settings);
/// Without a `drawing`, only the choice is remembered.
void remember(QSettings& settings, const DrawingExport& made);

} // namespace app
