// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/progress.h"
#include "app/cut/cut.h"
#include "app/formats/format.h"
#include "app/tiles/sheet_names.h"

namespace app {

/// Whether a further page shows where each sheet belongs.
enum class OverviewSheet : std::uint8_t { No, Yes };

/// A drawing, divided among sheets.
struct Sheets {
    Document drawing; ///< already cut at its own windows
    TilePlan plan;
    Tiling tiling;      ///< of its page, by the plan
    CutOptions options; ///< how it is cut at the sheets' edges; the region does not count
    QString title;      ///< on each sheet, if the plan has labels
    OverviewSheet overview = OverviewSheet::No;

    /// Number of pages: the sheets that are not left out, and the overview.
    std::size_t count() const;
    /// The drawing on one sheet, in its own coordinates, on a page with margins. Marks are on a
    /// layer above all others.
    Document sheet(const Tile& tile) const;
};

/// All files that writeSheets() writes by this pattern, in their order.
QStringList filesOf(const Sheets& sheets, const QString& pattern);

/// Writes a file for each sheet, by the pattern; or, in the format PDF, one file with a page for
/// each, if the pattern does not name them all. The overview comes first. Existing files are
/// replaced only by complete new ones. Returns nothing, or a sentence; the sheets before the one
/// that failed are written.
std::optional<QString> writeSheets(const Sheets& sheets, const QString& pattern,
                                   const Format& format, const WriteOptions& options,
                                   const Follower& follower = {});

} // namespace app
