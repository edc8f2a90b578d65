// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/block_cut.h"

#include "app/base/csv_text.h"
#include "app/formats/coordinates.h"
#include "app/formats/csv/look_columns.h"

#include <glm/common.hpp>

#include <cmath>

namespace app::csv {
namespace {

clipping::Window around(const clipping::Window& a, const clipping::Window& b)
{
    return {glm::min(a.min, b.min), glm::max(a.max, b.max)};
}

} // namespace

void TableCounts::add(const TableCounts& more)
{
    lines.whole += more.lines.whole;
    lines.cut += more.lines.cut;
    lines.gone += more.lines.gone;
    lines.dropped += more.lines.dropped;
    lines.segmentsBefore += more.lines.segmentsBefore;
    lines.segmentsAfter += more.lines.segmentsAfter;
    badRows += more.badRows;
    if (more.bounds)
        bounds = bounds ? around(*bounds, *more.bounds) : *more.bounds;
}

BlockCut::BlockCut(const RowReader& rows, const TableCutOptions& options)
    : rows_(rows), options_(options), clipping_(options.cut)
{
}

void BlockCut::cut(const RecordBlock& block)
{
    lines_.clear();
    sources_.clear();
    looks_.clear();
    text_.clear();
    badRows_.clear();
    counts_ = {};
    try {
        readRows(block);
    } catch (const Refused&) {
        cutLines();
        throw;
    }
    cutLines();
}

void BlockCut::readRows(const RecordBlock& block)
{
    for (std::size_t i = 0; i < block.places.size(); ++i) {
        const RecordBlock::Place& place = block.places[i];
        try {
            readRow(block.text(place), block.line + place.line, block.record + i);
        } catch (const Refused& refused) {
            if (!options_.skipBad)
                throw;
            ++counts_.badRows;
            if (badRows_.size() < mostBadRowsNamed)
                badRows_.push_back({refused.line, refused.why});
        }
    }
}

void BlockCut::readRow(std::string_view record, std::size_t line, std::size_t row)
{
    Row read;
    try {
        read = rows_.row(fields_.of(record), line);
    } catch (Refused& refused) {
        refused.line = line; // in a quoted record it is counted from the record
        throw;
    }
    const std::size_t look = lookOf(read, line);
    lines_.push_back(read.line);
    sources_.push_back({row, look});
}

// Most rows look like the row before.
std::size_t BlockCut::lookOf(const Row& row, std::size_t line)
{
    if (looks_.empty() || row.layer != layer_ || row.colour != colour_ || row.width != width_) {
        const Style style = styleOf(row, line);
        const QString layer =
            row.layer.empty() ? usualLayer()
                              : QString::fromUtf8(row.layer.data(), qsizetype(row.layer.size()));
        looks_.push_back(lookColumns(layer, *style.stroke, style.width));
        layer_ = row.layer;
        colour_ = row.colour;
        width_ = row.width;
    }
    return looks_.size() - 1;
}

void BlockCut::cutLines()
{
    countBounds();
    auto kept = clipping_.keptOf(lines_);
    for (std::size_t line = 0; line < lines_.size(); ++line) {
        std::size_t count = 0;
        while (count < kept.size() && kept[count].source == line)
            ++count;
        const bool whole = count == 1 && kept.front().segment == lines_[line];
        const std::size_t written = writePieces(line, kept.first(count));
        counts_.lines.whole += whole;
        counts_.lines.cut += written > 0 && !whole;
        counts_.lines.gone += written == 0;
        kept = kept.subspan(count);
        counts_.lines.segmentsAfter += count;
    }
    counts_.lines.segmentsBefore = lines_.size();
}

std::size_t BlockCut::writePieces(std::size_t line, std::span<const clipping::Clipped> pieces)
{
    std::size_t written = 0;
    for (const auto& [piece, source, cut] : pieces) {
        const auto [a, b] = piece;
        const bool tooShort = options_.cut.leastLength > 0 && !(piece == lines_[line])
                              && std::hypot(b.x - a.x, b.y - a.y) < options_.cut.leastLength;
        counts_.lines.dropped += tooShort;
        if (tooShort)
            continue;
        write(piece, sources_[line]);
        ++written;
    }
    return written;
}

void BlockCut::write(const clipping::Segment& piece, const Source& source)
{
    appendPoint(text_, piece.a, ',', options_.write);
    text_ += ',';
    appendPoint(text_, piece.b, ',', options_.write);
    text_ += looks_[source.look];
    if (!options_.rowsOnly)
        (text_ += ',') += std::to_string(source.row);
    text_ += '\n';
}

void BlockCut::countBounds()
{
    for (const auto& [a, b] : lines_) {
        const clipping::Window box{glm::min(a, b), glm::max(a, b)};
        counts_.bounds = counts_.bounds ? around(*counts_.bounds, box) : box;
    }
}

} // namespace app::csv
