// SPDX-License-Identifier: MIT
//
// Sobkow-Pospisil-Yang (1987), "Fast Clipping".
//
//   M. S. Sobkow, P. Pospisil, Y.-H. Yang: A Fast Two-Dimensional Line Clipping Algorithm via Line
//   Encoding. Computers & Graphics 11(4), 1987, 459-467.
//
// The regions of both ends make one of 81 cases, and each case has a short script of its own. The
// scripts are data: the compiler turns every one into a function without loops, and the code of the
// case picks it, as the authors' switch does.
//
// Corrected: each end moves from where it was given, not along what rounding has left; whether it
// is then beyond an edge is asked of the way it has gone where its rounded place is on that edge;
// and it is held inside the window, but for the sides where it cannot be outside.

#include "clipping/clamped.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"
#include "clipping/outcode.h"

#include <array>
#include <compare>

namespace clipping {

struct SobkowPospisilYang {
    static constexpr About about{
        .key = "sobkow-pospisil-yang",
        .abbreviation = "SPY",
        .name = "Sobkow-Pospisil-Yang",
        .year = 1987,
        .idea = "Let the regions of both ends pick one of 81 short scripts, which cuts and asks no "
                "more than that case needs.",
        .ulps = 24, // README.md, "How far off"
    };

    /// The outcodes of the nine regions in the order of the table: C L R B T LB RB LT RT.
    static constexpr std::array<unsigned, 9> regions{0, 1, 2, 4, 8, 5, 6, 9, 10};

    /// What to do when a (P) is in the region of the row and b (Q) in that of the column. PL moves
    /// P to the left edge, !PL rejects if P is beyond it, ?PL moves P there if it is; x rejects.
    // clang-format off
    static constexpr std::array<std::array<std::string_view, 9>, 9> scripts{{
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
        bool ofB;
        Edge edge;
    };
    /// The regions of both ends, and what is to be done.
    struct Script {
        unsigned codeA = 0, codeB = 0;
        std::array<Instruction, 6> instructions{};
        std::size_t size = 0;
    };
    static constexpr Edge edgeNamed(char letter)
    {
        return letter == 'L'   ? Edge::Left
               : letter == 'R' ? Edge::Right
               : letter == 'B' ? Edge::Bottom
                               : Edge::Top;
    }
    static constexpr Script scriptOf(std::size_t row, std::size_t column)
    {
        Script script{regions[row], regions[column]};
        for (std::string_view text = scripts[row][column]; text.size() > 1;) {
            const Kind kind = text[0] == '!'   ? Kind::RejectIfBeyond
                              : text[0] == '?' ? Kind::MoveIfBeyond
                                               : Kind::Move;
            text.remove_prefix(kind == Kind::Move ? 0 : 1);
            script.instructions[script.size++] = {kind, text[0] == 'Q', edgeNamed(text[1])};
            text.remove_prefix(2);
        }
        return script;
    }

    static constexpr unsigned bitOf(Edge edge) { return 1U << (static_cast<int>(edge) - 1); }
    static constexpr bool isLow(Edge edge) { return edge == lowerEdge(axisOf(edge)); }

    /// Whether the move of instruction `at` may leave the end beyond `edge`, as far as rounding
    /// goes: not if the script asks about it later, nor if the end comes from this side of the edge
    /// and moves away from it.
    static constexpr bool mayEndBeyond(const Script& script, std::size_t at, Edge edge)
    {
        const bool ofB = script.instructions[at].ofB;
        for (std::size_t i = at + 1; i < script.size; ++i)
            if (script.instructions[i].ofB == ofB && script.instructions[i].edge == edge)
                return false;
        const unsigned own = ofB ? script.codeB : script.codeA;
        const unsigned other = ofB ? script.codeA : script.codeB;
        const unsigned bit = bitOf(edge), opposite = isLow(edge) ? bit << 1 : bit >> 1;
        const bool away = (own & bit) == 0 && (own & opposite) == 0 && (other & opposite) != 0;
        return !away;
    }

    /// What is left of a segment while its script runs; how far each end has gone along its edge.
    template <class T>
    struct Run {
        const BasicSegment<T>& given;
        const BasicWindow<T>& window;
        BasicSegment<T> visible;
        glm::vec<2, T> d, way{};
    };

    /// Moves an end to an edge, along the segment.
    template <Form form, auto script, std::size_t i, class T>
    static constexpr void move(Run<T>& run)
    {
        constexpr Instruction what = script.instructions[i];
        constexpr glm::length_t axis = axisOf(what.edge), across = 1 - axis;
        glm::vec<2, T>& p = what.ofB ? run.visible.b : run.visible.a;
        const T edge = levelOf(what.edge, run.window);
        if constexpr (form == Form::Published) {
            const glm::vec<2, T>& other = what.ofB ? run.visible.a : run.visible.b;
            p[across] += (other[across] - p[across]) * (edge - p[axis]) / (other[axis] - p[axis]);
        } else {
            const glm::vec<2, T>& from = what.ofB ? run.given.b : run.given.a;
            const T way = run.d[across] * (edge - from[axis]) / run.d[axis];
            run.way[what.ofB] = way;
            p[across] = from[across] + way;
            const T low = run.window.min[across], high = run.window.max[across];
            if constexpr (mayEndBeyond(script, i, lowerEdge(across)))
                p[across] = p[across] < low ? low : p[across];
            if constexpr (mayEndBeyond(script, i, upperEdge(across)))
                p[across] = p[across] > high ? high : p[across];
        }
        p[axis] = edge;
    }

    /// Whether an end that has moved is beyond an edge.
    template <Form form, Instruction what, class T>
    static constexpr bool beyond(const Run<T>& run)
    {
        constexpr glm::length_t axis = axisOf(what.edge);
        const T edge = levelOf(what.edge, run.window);
        const T place = (what.ofB ? run.visible.b : run.visible.a)[axis];
        const auto side = place <=> edge;
        if (form == Form::Published || std::is_neq(side))
            return isLow(what.edge) ? std::is_lt(side) : std::is_gt(side);
        const T way = run.way[what.ofB], gap = edge - (what.ofB ? run.given.b : run.given.a)[axis];
        return isLow(what.edge) ? way < gap : way > gap;
    }

    /// Follows one instruction; false: nothing is visible.
    template <Form form, auto script, std::size_t i, class T>
    static constexpr bool follow(Run<T>& run, auto& watch)
    {
        constexpr Instruction what = script.instructions[i];
        constexpr int line = static_cast<int>(what.edge); // the four edges' lines in their order
        const Named number{"i", what.ofB ? 2 : 1};
        if constexpr (what.kind != Kind::Move)
            if (!asked(beyond<form, what>(run), line + (what.kind == Kind::MoveIfBeyond ? 12 : 8),
                       run.visible, what.edge, watch, number))
                return true;
        if constexpr (what.kind == Kind::RejectIfBeyond) {
            watch("reject", line + 8, run.visible, what.edge);
            return false;
        }
        move<form, script, i>(run);
        watch("cut", line + 4, run.visible, what.edge, number);
        return true;
    }

    /// Follows a script to its end; false: nothing is visible.
    template <Form form, auto script, std::size_t i, class T>
    static constexpr bool followFrom(Run<T>& run, auto& watch)
    {
        if constexpr (i == script.size) {
            return true;
        } else if constexpr (script.instructions[i].kind == Kind::RejectIfBeyond) {
            return follow<form, script, i>(run, watch)
                   && followFrom<form, script, i + 1>(run, watch);
        } else {
            follow<form, script, i>(run, watch);
            return followFrom<form, script, i + 1>(run, watch);
        }
    }

    template <Form form, auto script, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>> play(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, Watch& watch)
    {
        Run<T> run{s, w, s, {}};
        if constexpr (form == Form::Corrected && script.size != 0)
            run.d = {s.b.x - s.a.x, s.b.y - s.a.y};
        if (!followFrom<form, script, 0>(run, watch))
            return std::nullopt;
        watch("accept", 17, run.visible, Edge::None);
        return run.visible;
    }

    /// Whether the table rejects the cases whose outcodes have a bit in common, and no other.
    static constexpr bool rejectsByOutcodes()
    {
        for (std::size_t i = 0; i < 81; ++i)
            if ((scripts[i / 9][i % 9] == "x") != ((regions[i / 9] & regions[i % 9]) != 0))
                return false;
        return true;
    }

    /// The function of every pair of outcodes, 16 * a's + b's; null where the table rejects.
    template <Form form, class T, class Watch>
    static constexpr auto players()
    {
        using Player = std::optional<BasicSegment<T>> (*)(const BasicSegment<T>&,
                                                          const BasicWindow<T>&, Watch&);
        std::array<Player, 256> all{};
        [&]<std::size_t... cases>(std::index_sequence<cases...>)
        {
            ((all[16 * regions[cases / 9] + regions[cases % 9]] =
                  scripts[cases / 9][cases % 9] == "x"
                      ? nullptr
                      : &play<form, scriptOf(cases / 9, cases % 9), T, Watch>),
             ...);
        }
        (std::make_index_sequence<81>{});
        return all;
    }
    template <Form form, class T, class Watch>
    static constexpr auto player = players<form, T, Watch>();

    template <Form form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, Watch&& watch)
    {
        static_assert(rejectsByOutcodes());
        const unsigned codeA = outcodeOf(s.a, w), codeB = outcodeOf(s.b, w);
        watch("outcodes", 1, s, Edge::None, Named{"code1", codeA}, Named{"code2", codeB});
        watch("script", 2, s, Edge::None);
        if (asked((codeA & codeB) != 0, 3, s, Edge::None, watch)) { // the cases "x"
            watch("reject", 3, s, Edge::None);
            return std::nullopt;
        }
        return player<form, T, std::remove_reference_t<Watch>>[16 * codeA + codeB](s, w, watch);
    }
};

template Algorithm describe<SobkowPospisilYang>();

} // namespace clipping
