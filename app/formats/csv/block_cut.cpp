// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/block_cut.h"

#include "app/formats/coordinates.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app::csv {
namespace {

clipping::Window around(const clipping::Window& a, const clipping::Window& b)
{
    return {glm::min(a.min, b.min), glm::max(a.max, b.max)};
}

clipping::Segment atTrueCurves(const CurvedBorder& border, const clipping::Segment& piece,
                               const clipping::Segment& line)
{
    const auto moved = [&](const Point& end, const Point& whole) {
        const auto met = end == whole ? std::nullopt : border.meeting(line, end);
        return met ? met->point : end;
    };
    return border.isEmpty() ? piece
                            : clipping::Segment{moved(piece.a, line.a), moved(piece.b, line.b)};
}

bool isPointPiece(const clipping::Clipped& piece) { return piece.segment.a == piece.segment.b; }

} // namespace

void TableCounts::add(const TableCounts& more)
{
    lines.whole += more.lines.whole;
    lines.cut += more.lines.cut;
    lines.gone += more.lines.gone;
    lines.touching += more.lines.touching;
    lines.dropped += more.lines.dropped;
    lines.segmentsBefore += more.lines.segmentsBefore;
    lines.segmentsAfter += more.lines.segmentsAfter;
    points += more.points;
    if (more.bounds)
        bounds = bounds ? around(*bounds, *more.bounds) : *more.bounds;
}

void BlockCut::cut(const TableRows& rows)
{
    // Not divided for earlier blocks, so that the rows of a block depend on its own lines alone.
    auto divided = all_.border.dividedFor(rows.lines());
    if (!divided)
        return cutAt(all_, rows);
    Windows windows(options_, std::move(*divided));
    cutAt(windows, rows);
}

void BlockCut::cutAt(Windows& windows, const TableRows& rows)
{
    const std::vector<clipping::Segment>& lines = rows.lines();
    text_.clear();
    counts_ = {};
    countBounds(lines);
    auto kept = windows.clipping.keptOf(lines);
    for (std::size_t line = 0; line < lines.size(); ++line) {
        std::size_t count = 0;
        while (count < kept.size() && kept[count].source == line)
            ++count;
        const bool whole = count == 1 && kept.front().segment == lines[line];
        const bool touches =
            !whole && count > 0 && std::ranges::all_of(kept.first(count), isPointPiece);
        const std::size_t written = writePieces(windows.border, rows, line, kept.first(count));
        counts_.lines.whole += whole;
        counts_.lines.touching += touches;
        counts_.lines.cut += written > 0 && !whole && !touches;
        counts_.lines.gone += written == 0 && !touches;
        kept = kept.subspan(count);
        counts_.lines.segmentsAfter += count;
    }
    counts_.lines.segmentsBefore = lines.size();
}

std::size_t BlockCut::writePieces(const CurvedBorder& border, const TableRows& rows,
                                  std::size_t line, std::span<const clipping::Clipped> pieces)
{
    std::size_t written = 0;
    for (const auto& [atPolygon, source, cut] : pieces) {
        const clipping::Segment piece = atTrueCurves(border, atPolygon, rows.lines()[line]);
        const auto [a, b] = piece;
        const bool tooShort = options_.cut.leastLength > 0 && !(piece == rows.lines()[line])
                              && std::hypot(b.x - a.x, b.y - a.y) < options_.cut.leastLength;
        counts_.lines.dropped += tooShort;
        if (tooShort || (piece.a == piece.b && atPolygon.a != atPolygon.b))
            continue;
        write(piece, rows, line);
        ++written;
    }
    return written;
}

void BlockCut::write(const clipping::Segment& piece, const TableRows& rows, std::size_t line)
{
    if (becomesPoint(piece, options_.write)) {
        ++counts_.points;
        return;
    }
    appendPoint(text_, piece.a, ',', options_.write);
    text_ += ',';
    appendPoint(text_, piece.b, ',', options_.write);
    text_ += rows.lookOf(line);
    if (!options_.rowsOnly)
        (text_ += ',') += std::to_string(rows.rowOf(line));
    text_ += '\n';
}

void BlockCut::countBounds(std::span<const clipping::Segment> lines)
{
    for (const auto& [a, b] : lines) {
        const clipping::Window box{glm::min(a, b), glm::max(a, b)};
        counts_.bounds = counts_.bounds ? around(*counts_.bounds, box) : box;
    }
}

} // namespace app::csv
