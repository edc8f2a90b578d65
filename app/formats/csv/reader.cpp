// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/reader.h"

#include "app/base/csv_text.h"
#include "app/base/memory.h"
#include "app/base/text.h"
#include "app/formats/csv/lines_by_layer.h"
#include "app/formats/csv/record_blocks.h"
#include "app/formats/csv/record_fields.h"
#include "app/formats/csv/row_reader.h"

#include <algorithm>

namespace app::csv {
namespace {

constexpr std::uint64_t bytesOfLine = 48; // in a document

class Reader {
public:
    explicit Reader(QIODevice& in)
        : size_(in.isSequential() ? 0 : std::uint64_t(in.size())),
          blocks_([&in](char* bytes, std::size_t size) {
              return std::size_t(std::max<qint64>(in.read(bytes, qint64(size)), 0));
          })
    {
    }

    Imported read()
    {
        RecordBlock block;
        if (blocks_.first(block) && !readHeader(block))
            addRows(block);
        while (blocks_.next(block)) {
            if (lines_.size() <= 1) // the first ones
                checkMemory(block);
            addRows(block);
        }
        finish();
        return std::move(imported_);
    }

private:
    bool readHeader(const RecordBlock& block)
    {
        const RecordBlock::Place& place = block.places.front();
        const bool isHeader = rows_.readHeader(block.text(place), block.line + place.line);
        blocks_.setSeparator(rows_.separator());
        fields_ = RecordFields(rows_.separator());
        if (isHeader && rows_.beginsWithColour())
            blocks_.endComments();
        return isHeader;
    }

    /// Throws Refused if the whole file, of lines like these, does not fit into memory.
    void checkMemory(const RecordBlock& block) const
    {
        if (block.places.empty() || block.bytes.empty())
            return;
        const double lines =
            double(size_) / double(block.bytes.size()) * double(block.places.size());
        if (const QString fault = memoryFault(std::uint64_t(lines * double(bytesOfLine)));
            !fault.isEmpty())
            throw Refused{0, fault};
    }

    void addRows(const RecordBlock& block)
    {
        for (const RecordBlock::Place& place : block.places)
            addRow(block.text(place), block.line + place.line);
    }

    void addRow(std::string_view record, std::size_t line)
    {
        if (!memory_.isEnough())
            throw Refused{line, memoryEnds()};
        const Fields fields = fields_.of(record, line);
        const Row row = rows_.row(fields, line);
        const StyleEntry style = styleOf(row, line);
        lines_.turnTo(row.layer);
        if (rows_.hasGeometries())
            lines_.add(rows_.geometry(fields, line), style);
        else
            lines_.add(row.line, style);
    }

    // Most rows have the style of the previous row.
    StyleEntry styleOf(const Row& row, std::size_t line)
    {
        if (!style_ || row.colour != colour_ || row.width != width_) {
            style_ = lines_.style(csv::styleOf(row, rows_, line));
            colour_ = row.colour;
            width_ = row.width;
        }
        return *style_;
    }

    void finish()
    {
        imported_.paged = false;
        imported_.report = rows_.report();
        if (const int beyond = lines_.beyond(); beyond > 0)
            imported_.report.push_back({Text::tr("layer names of lines, beyond the first %1 layers")
                                            .arg(Containers::mostLayers),
                                        beyond});
        imported_.document = lines_.take();
        imported_.rows = lines_.order();
    }

    std::uint64_t size_; ///< of the file; 0: not known
    MemoryWatch memory_;
    RecordBlocks blocks_;
    RecordFields fields_;
    RowReader rows_;
    LinesByLayer lines_;
    std::string colour_, width_; ///< of the last row
    std::optional<StyleEntry> style_;
    Imported imported_;
};

} // namespace

Result<Imported> read(QIODevice& in)
{
    try {
        return Result<Imported>::of(Reader(in).read());
    } catch (const Refused& refused) {
        return Result<Imported>::failure(
            refused.line > 0 ? Text::tr("line %1 %2").arg(refused.line).arg(refused.why)
                             : refused.why);
    }
}

} // namespace app::csv
