// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <array>
#include <string_view>
#include <utility>

// The scripts of Sobkow, Pospisil and Yang: the actions for each of the 81 pairs of regions.

namespace clipping::fast_clipping {

/// The outcodes of the nine regions in the order of the table: C L R B T LB RB LT RT.
inline constexpr std::array<unsigned, 9> regions{0, 1, 2, 4, 8, 5, 6, 9, 10};

/// The script if End 1 (P) is in the region of the row and End 2 (Q) in that of the column. PL
/// moves P to the left edge (procedure L of the pseudo-code); !PL rejects if P is beyond the left
/// edge (notL); ?PL moves P to the left edge if P is beyond it (ifL); x rejects.
// clang-format off
inline constexpr std::array<std::array<std::string_view, 9>, 9> scripts{{
    {"", "QL", "QR", "QB", "QT", "QL?QB", "QR?QB", "QL?QT", "QR?QT"},
    {"PL", "x", "PLQR", "PL!PBQB", "PL!PTQT", "x", "PL!PBQB?QR", "x", "PL!PTQT?QR"},
    {"PR", "PRQL", "x", "PR!PBQB", "PR!PTQT", "PR!PBQB?QL", "x", "PR!PTQT?QL", "x"},
    {"PB", "PB!PLQL", "PB!PRQR", "x", "PBQT", "x", "x", "PB!PLQL?QT", "PB!PRQR?QT"},
    {"PT", "PT!PLQL", "PT!PRQR", "PTQB", "x", "PT!PLQL?QB", "PT!PRQR?QB", "x", "x"},
    {"PL?PB", "x", "QR!QBPB?PL", "x", "QT!QLPB?PL", "x", "x", "x", "PL!PTQR!QB?PB?QT"},
    {"PR?PB", "QL!QBPB?PR", "x", "x", "QT!QRPB?PR", "x", "x", "QL!QBPR!PT?QT?PB", "x"},
    {"PL?PT", "x", "QR!QTPT?PL", "QB!QLPL?PT", "x", "x", "PL!PBQR!QT?PT?QB", "x", "x"},
    {"PR?PT", "QL!QTPT?PR", "x", "QB!QRPR?PT", "x", "QL!QTPR!PB?QB?PT", "x", "x", "x"},
}};
// clang-format on

enum class Kind : std::uint8_t { Move, RejectIfBeyond, MoveIfBeyond };
struct Instruction {
    Kind kind;
    int i; ///< the end: 0 for P, 1 for Q
    Edge edge;
    /// Whether a move is clamped at each side, in the corrected form.
    bool holdLow = false, holdHigh = false;
};
/// The regions of both ends, and the script for them.
struct Script {
    unsigned code1 = 0, code2 = 0;
    std::array<Instruction, 6> instructions{};
    std::size_t size = 0;
};
constexpr Edge edgeNamed(char letter)
{
    return letter == 'L'   ? Edge::Left
           : letter == 'R' ? Edge::Right
           : letter == 'B' ? Edge::Bottom
                           : Edge::Top;
}
constexpr unsigned bitOf(Edge edge) { return 1U << (static_cast<int>(edge) - 1); }
constexpr bool isLow(Edge edge) { return edge == lowerEdge(axisOf(edge)); }

/// Whether rounding in the move of instruction `at` can leave the end beyond `edge`: not if the
/// script tests this edge later, nor if the end starts between the edge and the opposite one and
/// moves away from the edge.
constexpr bool mayEndBeyond(const Script& script, std::size_t at, Edge edge)
{
    const int i = script.instructions[at].i;
    for (std::size_t later = at + 1; later < script.size; ++later)
        if (script.instructions[later].i == i && script.instructions[later].edge == edge)
            return false;
    const unsigned own = i == 0 ? script.code1 : script.code2;
    const unsigned other = i == 0 ? script.code2 : script.code1;
    const unsigned bit = bitOf(edge), opposite = isLow(edge) ? bit << 1 : bit >> 1;
    const bool away = (own & bit) == 0 && (own & opposite) == 0 && (other & opposite) != 0;
    return !away;
}

constexpr Script scriptOf(std::size_t row, std::size_t column)
{
    Script script{regions[row], regions[column]};
    for (std::string_view text = scripts[row][column]; text.size() > 1;) {
        const Kind kind = text[0] == '!'   ? Kind::RejectIfBeyond
                          : text[0] == '?' ? Kind::MoveIfBeyond
                                           : Kind::Move;
        text.remove_prefix(kind == Kind::Move ? 0 : 1);
        script.instructions[script.size++] = {kind, text[0] == 'Q' ? 1 : 0, edgeNamed(text[1])};
        text.remove_prefix(2);
    }
    for (std::size_t at = 0; at < script.size; ++at) {
        Instruction& what = script.instructions[at];
        what.holdLow = mayEndBeyond(script, at, lowerEdge(1 - axisOf(what.edge)));
        what.holdHigh = mayEndBeyond(script, at, upperEdge(1 - axisOf(what.edge)));
    }
    return script;
}

/// Executes a script; returns false if nothing is visible.
template <auto script>
constexpr bool followAll(auto& ends)
{
    return [&]<std::size_t... at>(std::index_sequence<at...>)
    {
        return (ends.template follow<script.instructions[at]>() && ...);
    }
    (std::make_index_sequence<script.size>{});
}

/// Whether the table rejects exactly the cases whose outcodes have a common bit.
constexpr bool rejectsByOutcodes()
{
    for (std::size_t i = 0; i < 81; ++i)
        if ((scripts[i / 9][i % 9] == "x") != ((regions[i / 9] & regions[i % 9]) != 0))
            return false;
    return true;
}

} // namespace clipping::fast_clipping
