// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/curved_border.h"
#include "app/cut/line_clipping.h"
#include "app/formats/csv/table_rows.h"

#include <optional>

namespace app::csv {

/// Counts of the lines of a table, or of a part of it, before and after the cut.
struct TableCounts {
    CutCounts lines;
    std::size_t points = 0; ///< pieces left out because the precision makes them points
    std::optional<clipping::Window> bounds{}; ///< around all lines before the cut

    void add(const TableCounts& more);
};

struct CutRows {
    CutOptions cut;
    WriteOptions write;
    Page page{};           ///< of which the windows are
    bool rowsOnly = false; ///< neither header nor the column `source`
};

/// Cuts the lines of one block after the other. Reuses its buffers.
class BlockCut {
public:
    /// `options` must outlive this object.
    explicit BlockCut(const CutRows& options)
        : options_(options),
          all_(options, {options.cut.windows, options.page, options.cut.coincident})
    {
    }

    /// Replaces the results by those of these lines.
    void cut(const TableRows& rows);

    const std::string& text() const { return text_; } ///< the rows of the kept pieces
    const TableCounts& counts() const { return counts_; }

private:
    /// The windows, as polygons that are near enough to their curves.
    struct Windows {
        Windows(const CutRows& options, CurvedBorder curves)
            : border(std::move(curves)), cut(atPolygons(options.cut, border, options.page)),
              clipping(cut)
        {
        }
        Windows(const Windows&) = delete; // clipping refers to cut
        Windows& operator=(const Windows&) = delete;

        CurvedBorder border;
        CutOptions cut;
        LineClipping clipping;
    };

    void cutAt(Windows& windows, const TableRows& rows);
    std::size_t writePieces(const CurvedBorder& border, const TableRows& rows, std::size_t line,
                            std::span<const clipping::Clipped> pieces);
    void write(const clipping::Segment& piece, const TableRows& rows, std::size_t line);
    void countBounds(std::span<const clipping::Segment> lines);

    const CutRows& options_;
    Windows all_; ///< for any block
    std::string text_;
    TableCounts counts_;
};

} // namespace app::csv
