// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object.h"

#include <span>

namespace app {

/// Consecutive objects, stored by columns. A column with the same value for all objects has one
/// element or none. Blocks in `Objects` are never empty, and their columns are as narrow as
/// possible.
struct ObjectBlock {
    std::vector<clipping::Segment> lines{}; ///< if all objects are lines or points; else empty
    std::vector<Path> paths{};              ///< all paths, if `lines` is empty
    std::vector<StyleIndex> styles{};       ///< one for all objects, or one for each
    std::vector<std::uint8_t> hidden{};     ///< empty: none is hidden
    std::vector<Shared<Particulars>> particulars{}; ///< empty: none has any
    std::uint32_t points = 0;                       ///< the sum of `weight` over all objects

    static constexpr std::uint32_t mostPoints = 8192;          ///< a single object may have more
    static constexpr std::uint32_t fewPoints = mostPoints / 2; ///< smaller blocks are merged

    std::size_t size() const { return lines.size() + paths.size(); }
    Path path(std::size_t i) const { return paths.empty() ? Path(lines[i]) : paths[i]; }
    StyleIndex style(std::size_t i) const { return styles.size() == 1 ? styles[0] : styles[i]; }
    bool isHidden(std::size_t i) const { return !hidden.empty() && hidden[i]; }
    const Shared<Particulars>& particularsOf(std::size_t i) const
    {
        return particulars.empty() ? noParticulars() : particulars[i];
    }
    std::uint32_t pointsOf(std::size_t first, std::size_t count) const;
    std::size_t heapBytes() const; ///< of the columns
    HeapPart pathPart(std::size_t i) const;
    HeapPart particularsPart(std::size_t i) const;

    void append(const clipping::Segment& line, StyleIndex style);
    void append(const ObjectRow& row, StyleIndex style); ///< which `row.style` has here
    /// Appends some objects of another block.
    void append(const ObjectBlock& from, std::size_t first, std::size_t count);
    void narrow(); ///< makes the columns as narrow as possible; `append` only widens them
};

/// The weight of a path in a block: its number of stored points, but at least two, which limits the
/// number of objects in a block.
std::uint32_t weight(const Path& path);

} // namespace app
