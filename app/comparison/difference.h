// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"

#include <QString>

namespace app {

/// How the results of two variants, A and B, differ for one line.
struct Difference {
    enum class Kind : std::uint8_t { OnlyA, OnlyB, EndsApart };

    std::uint32_t source; ///< index of the line among the compared segments
    Kind kind;            ///< only A sees the line, only B does, or both with different ends
    /// In ulps of the largest |coordinate| of line and window: the distance between the ends, or
    /// the length of the piece that only one variant sees (0: a point).
    double ulps;

    friend bool operator==(const Difference&, const Difference&) = default;
};

/// Two pieces of the same line count as equal if their ends are at most this far apart.
struct Allowance {
    double ulps = 0;
    Ends ends = Ends::InOrder;
};

/// The lines for which a and b (both ascending by source) differ, ascending by source.
std::vector<Difference> differences(std::span<const clipping::Segment> lines,
                                    const clipping::Window& window,
                                    std::span<const clipping::Clipped> a,
                                    std::span<const clipping::Clipped> b, const Allowance& allowed);

/// The same, but clips the lines first. Takes as long as clipping twice.
std::vector<Difference> differences(std::span<const clipping::Segment> lines,
                                    const clipping::Window& window, const Variant& a,
                                    const Variant& b, double ulpsAllowed);

/// The number of differences of each kind.
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
