// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"

#include <QString>

namespace app {

/// What two of them, A and B, leave of one line that is not the same.
struct Difference {
    enum class Kind : std::uint8_t { OnlyA, OnlyB, EndsApart };

    std::uint32_t source; ///< the line: an index into the segments that were compared
    Kind kind;            ///< only A sees the line, only B does, or both with other ends
    /// In units in the last place of the largest |coordinate| of line and window: how far the ends
    /// are apart, or how long the piece is that only one sees (0: a point).
    double ulps;

    friend bool operator==(const Difference&, const Difference&) = default;
};

/// When pieces of the same line are the same: no end off by more ulps than this.
struct Allowance {
    double ulps = 0;
    Ends ends = Ends::InOrder;
};

/// The lines of which a and b, both ascending by source, leave different things, ascending.
std::vector<Difference> differences(std::span<const clipping::Segment> lines,
                                    const clipping::Window& window,
                                    std::span<const clipping::Clipped> a,
                                    std::span<const clipping::Clipped> b, const Allowance& allowed);

/// The same, clipping first. Takes as long as clipping twice.
std::vector<Difference> differences(std::span<const clipping::Segment> lines,
                                    const clipping::Window& window, const Variant& a,
                                    const Variant& b, double ulpsAllowed);

/// How many there are of each kind.
struct DifferenceCounts {
    std::size_t onlyA = 0, onlyB = 0, endsApart = 0;

    std::size_t all() const { return onlyA + onlyB + endsApart; }
    friend bool operator==(const DifferenceCounts&, const DifferenceCounts&) = default;
};
DifferenceCounts counted(std::span<const Difference> differences);

/// "KWC as published loses 456 lines that exact keeps", or "They agree on all 9,969 lines here".
QString sentence(const Variant& a, const Variant& b, const DifferenceCounts& counts,
                 std::size_t lines);

} // namespace app
