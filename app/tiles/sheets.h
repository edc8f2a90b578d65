// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/cut.h"
#include "app/formats/format.h"
#include "app/tiles/tiling.h"

namespace app {

/// A drawing, divided among sheets.
struct Sheets {
    Document drawing; ///< already cut at its own windows
    TilePlan plan;
    Tiling tiling;      ///< of its page, by the plan
    CutOptions options; ///< how it is cut at the sheets' edges; the region does not count
    QString title;      ///< on each sheet, if the plan has marks

    std::size_t count() const { return tiling.tiles.size(); }
    /// The drawing on one sheet, in its own coordinates, on a page with margins. Marks are on a
    /// layer above all others.
    Document sheet(std::size_t number) const;
};

/// The name of a sheet's file: {row}, {column} and {n} in the pattern become its numbers.
QString sheetName(const QString& pattern, const Tiling& tiling, const Tile& tile);
/// Whether the pattern gives each sheet a name of its own.
bool namesEverySheet(const QString& pattern, const Tiling& tiling);

/// Writes a file for each sheet, by the pattern; or, in the format PDF, one file with a page for
/// each, if the pattern does not name them all. Existing files are replaced only by complete new
/// ones. Returns nothing, or a sentence; the sheets before the one that failed are written.
std::optional<QString> writeSheets(const Sheets& sheets, const QString& pattern,
                                   const Format& format, const WriteOptions& options);

} // namespace app
