// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/formulas/expression.h"
#include "clipping/counted.h"

#include <array>

// The words and signs of formulas.

namespace app::formulas {

/// An operator of two operands.
struct Operator {
    std::string_view text;
    std::size_t level; ///< the higher, the tighter it binds
    Kind kind;
};
inline constexpr std::array operators{
    Operator{"or", 0, Kind::Or},     Operator{"and", 1, Kind::And},
    Operator{"<", 3, Kind::Less},    Operator{">", 3, Kind::Greater},
    Operator{"<=", 3, Kind::AtMost}, Operator{">=", 3, Kind::AtLeast},
    Operator{"==", 3, Kind::Equal},  Operator{"!=", 3, Kind::NotEqual},
    Operator{"|", 4, Kind::BitOr},   Operator{"&", 5, Kind::BitAnd},
    Operator{"+", 6, Kind::Sum},     Operator{"-", 6, Kind::Difference},
    Operator{"*", 7, Kind::Product}, Operator{"/", 7, Kind::Quotient},
};
inline constexpr std::size_t levelOfNot = 2, levelOfComparisons = 3, tightest = 8;

/// A word for a number, a truth or the bit of an outcode.
struct Constant {
    std::string_view name;
    double value;
};
inline constexpr std::array constants{Constant{"true", 1},   Constant{"false", 0},
                                      Constant{"LEFT", 1},   Constant{"RIGHT", 2},
                                      Constant{"BOTTOM", 4}, Constant{"TOP", 8}};

/// A function, how many arguments it takes and what it costs at most.
struct Function {
    std::string_view name;
    std::size_t arguments;
    clipping::OperationCounts cost;
};
/// What exact/line.h does in floating point: of a side, and of a coordinate.
inline constexpr clipping::OperationCounts costOfOrder{7, 3, 0, 7, 3},
    costOfCrossing{56, 19, 2, 4, 5};
/// What exact/turn.h does in floating point.
inline constexpr clipping::OperationCounts costOfSide{7, 3, 0, 5, 3};
/// sign(v) is -1, 0 or 1, by one comparison. order(x, y) is -1, 0 or 1: the line from x1, y1 to x2,
/// y2 passes x before, together with or after y. atEdge(u) is whether u was computed at an edge,
/// vertical(u) whether this edge is vertical, and edge(u) its coordinate. yAt(x) and xAt(y) are its
/// other coordinate there, rounded once. side(x, y) is 1 for a point to its left, 0 for one on it,
/// -1 for one to its right. beyond(x, y) is whether a point is beyond the edge of the step.
inline constexpr std::array functions{Function{"outcode", 2, {.comparisons = 4}},
                                      Function{"abs", 1, {.comparisons = 1, .negations = 1}},
                                      Function{"sign", 1, {.comparisons = 1}},
                                      Function{"min", 2, {.comparisons = 1}},
                                      Function{"max", 2, {.comparisons = 1}},
                                      Function{"held", 1, {.comparisons = 2}},
                                      Function{"atEdge", 1, {}},
                                      Function{"vertical", 1, {}},
                                      Function{"edge", 1, {}},
                                      Function{"order", 2, costOfOrder},
                                      Function{"yAt", 1, costOfCrossing},
                                      Function{"xAt", 1, costOfCrossing},
                                      Function{"side", 2, costOfSide},
                                      Function{"beyond", 2, {.comparisons = 1}}};

} // namespace app::formulas
