// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"
#include "app/tiles/sheets.h"

#include <QStringList>

#include <optional>
#include <string>

namespace app {

/// A person's settings for sheets: how the drawing is divided, and how the files are written. Only
/// the former are saved with the drawing.
struct SheetSettings : PageSheets {
    std::string format = "svg";
    bool oneFile = false; ///< for all sheets; only in the format PDF
    OverviewSheet overview = OverviewSheet::No;
    QString name{}; ///< the pattern of the files' names without the ending; empty: by the title
    friend bool operator==(const SheetSettings&, const SheetSettings&) = default;
};

TilePlan planOf(const SheetSettings& settings);

/// "A4 portrait"; by number "192 × 550 mm".
QString paperText(const SheetSettings& settings, const Tiling& tiling);

/// The pattern of the files' names with the ending. `title` is the name of the drawing.
QString patternOf(const SheetSettings& settings, const QString& title);
/// Takes a typed pattern; its ending may choose another format. The error is a sentence.
Result<SheetSettings> withName(SheetSettings settings, const QString& typed, const Tiling& tiling);
/// Takes another format, and whether all sheets are in one file; only PDF can hold several.
SheetSettings withFormat(SheetSettings settings, const Format& format);
SheetSettings withOneFile(SheetSettings settings, bool oneFile);

/// The formats that sheets can be written in, in menu order.
std::vector<const Format*> sheetFormats();

/// The papers that are offered for sheets: those that a page may have.
QStringList papers();
/// The size of a paper ("A4", "Letter", in any case) in millimetres, portrait; empty: unknown.
/// Other papers than those offered are known, too.
std::optional<Point> paperSize(const QString& name);

} // namespace app
