// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object.h"

#include <span>

namespace app {

/// Objects that follow each other, by columns. A column that says the same of all is one value, or
/// empty. Blocks in `Objects` are never empty, and their columns are as narrow as they can be.
struct ObjectBlock {
    std::vector<clipping::Segment> lines{}; ///< all are single lines or points; else empty and
    std::vector<Path> paths{};              ///< all are here
    std::vector<StyleIndex> styles{};       ///< one for all, or one each
    std::vector<std::uint8_t> hidden{};     ///< empty: none is
    std::vector<Shared<Particulars>> particulars{}; ///< empty: none has any
    std::uint32_t points = 0;                       ///< sum of `weight`

    static constexpr std::uint32_t mostPoints = 8192;          ///< unless one object alone has more
    static constexpr std::uint32_t fewPoints = mostPoints / 2; ///< fewer: join it with a neighbour

    std::size_t size() const { return lines.size() + paths.size(); }
    Path path(std::size_t i) const { return paths.empty() ? Path(lines[i]) : paths[i]; }
    StyleIndex style(std::size_t i) const { return styles.size() == 1 ? styles[0] : styles[i]; }
    bool isHidden(std::size_t i) const { return !hidden.empty() && hidden[i]; }
    const Shared<Particulars>& particularsOf(std::size_t i) const
    {
        return particulars.empty() ? noParticulars() : particulars[i];
    }
    std::uint32_t pointsOf(std::size_t first, std::size_t count) const;
    std::size_t heapBytes() const; ///< of its columns
    HeapPart pathPart(std::size_t i) const;
    HeapPart particularsPart(std::size_t i) const;

    void append(const clipping::Segment& line, StyleIndex style);
    void append(const ObjectRow& row);
    void append(const ObjectBlock& from, std::size_t first, std::size_t count); ///< of another one
    void narrow(); ///< makes the columns as narrow as they can be; `append` widens them only
};

/// What a path counts in a block: its stored points, at least two, so that a block has an end.
std::uint32_t weight(const Path& path);

} // namespace app
