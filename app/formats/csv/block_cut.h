// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/line_clipping.h"
#include "app/formats/csv/record_blocks.h"
#include "app/formats/csv/record_fields.h"
#include "app/formats/csv/row_reader.h"

#include <optional>

namespace app::csv {

/// Counts of the lines of a table, or of a part of it, before and after the cut.
struct TableCounts {
    CutCounts lines;
    std::size_t badRows = 0;
    std::optional<clipping::Window> bounds{}; ///< around all lines before the cut

    void add(const TableCounts& more);
};

struct BadRow;

struct TableCutOptions {
    CutOptions cut;
    WriteOptions write;
    bool skipBad = false;  ///< otherwise a bad row ends the work
    bool rowsOnly = false; ///< neither header nor the column `source`
    std::size_t threads = 1;
    std::function<void(const BadRow&)> sayBad{}; ///< for the first bad rows, in order
    std::function<void()> stopSource{}; ///< ends the source's wait for bytes, on any thread
};
constexpr std::size_t mostBadRowsNamed = 10;

/// A row that is skipped; `why` continues "line 12 ".
struct BadRow {
    std::size_t line;
    QString why;
};

/// Cuts the lines of one block after the other. Reuses its buffers.
class BlockCut {
public:
    /// All arguments must outlive this object.
    BlockCut(const RowReader& rows, const TableCutOptions& options);

    /// Replaces the results by those of this block. Throws Refused at a bad row, unless these are
    /// skipped; the results then are those of the rows before it.
    void cut(const RecordBlock& block);

    const std::string& text() const { return text_; } ///< the rows of the kept pieces
    const TableCounts& counts() const { return counts_; }
    const std::vector<BadRow>& badRows() const { return badRows_; } ///< the first few

private:
    struct Source {
        std::size_t row;
        std::size_t look; ///< index in looks_
    };

    void readRows(const RecordBlock& block);
    void readRow(std::string_view record, std::size_t line, std::size_t row);
    std::size_t lookOf(const Row& row, std::size_t line);
    void cutLines();
    std::size_t writePieces(std::size_t line, std::span<const clipping::Clipped> pieces);
    void write(const clipping::Segment& piece, const Source& source);
    void countBounds();

    const RowReader& rows_;
    const TableCutOptions& options_;
    LineClipping clipping_;
    RecordFields fields_;
    std::vector<clipping::Segment> lines_;
    std::vector<Source> sources_; ///< of the lines
    std::vector<std::string> looks_;
    std::string layer_, colour_, width_; ///< of the last look
    std::string text_;
    TableCounts counts_;
    std::vector<BadRow> badRows_;
};

} // namespace app::csv
