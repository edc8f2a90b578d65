// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "tests/clipping/formulas/expression.h"

// The words and signs of formulas.

namespace formulas {

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

/// A function and how many arguments it takes.
struct Function {
    std::string_view name;
    std::size_t arguments;
};
inline constexpr std::array functions{Function{"outcode", 2}, Function{"abs", 1},
                                      Function{"min", 2}, Function{"max", 2}, Function{"held", 1}};

} // namespace formulas
