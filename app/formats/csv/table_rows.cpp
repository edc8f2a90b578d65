// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/table_rows.h"

#include "app/base/csv_text.h"
#include "app/formats/csv/columns.h"

namespace app::csv {

void TableRows::read(const RecordBlock& block)
{
    lines_.clear();
    sources_.clear();
    looks_.clear();
    badRows_.clear();
    badCount_ = 0;
    for (std::size_t i = 0; i < block.places.size(); ++i) {
        const RecordBlock::Place& place = block.places[i];
        try {
            readRow(block.text(place), block.line + place.line, block.record + i);
        } catch (const Refused& refused) {
            if (bad_ == BadRows::End)
                throw;
            ++badCount_;
            if (badRows_.size() < mostBadRowsNamed)
                badRows_.push_back({refused.line, refused.why});
        }
    }
}

void TableRows::readRow(std::string_view record, std::size_t line, std::size_t row)
{
    const Fields fields = fields_.of(record, line);
    const Row read = rows_.row(fields, line);
    const std::size_t look = lookOf(read, line);
    if (!rows_.hasGeometries()) {
        lines_.push_back(read.line);
        sources_.push_back({row, look});
        return;
    }
    for (const Subpath& path : rows_.geometry(fields, line)) {
        Point at = path.start;
        for (const PathSegment& segment : path.segments) {
            lines_.push_back({at, segment.to});
            sources_.push_back({row, look});
            at = segment.to;
        }
    }
}

// Most rows look like the row before.
std::size_t TableRows::lookOf(const Row& row, std::size_t line)
{
    if (looks_.empty() || row.layer != layer_ || row.colour != colour_ || row.width != width_) {
        const Style style = styleOf(row, rows_, line);
        const QString layer = row.layer.empty() ? usualLayer() : QString::fromUtf8(row.layer);
        looks_.push_back(lookColumns(layer, *style.stroke, style.width));
        layer_ = row.layer;
        colour_ = row.colour;
        width_ = row.width;
    }
    return looks_.size() - 1;
}

} // namespace app::csv
