// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

// The formulas of the pseudo-code that stands beside the algorithms.

namespace app::formulas {

/// What cannot be read, or has no value; `what()` says why in one sentence.
struct Unreadable : std::runtime_error {
    using runtime_error::runtime_error;
};

/// The names of one pseudo-code, each with its slot among the values. The first variables are those
/// of what is given: x1, y1, x2, y2, xmin, ymin, xmax, ymax.
class Names {
public:
    Names();
    int slotOf(const std::string& name);   ///< a new one for a new name
    int find(std::string_view name) const; ///< -1 if there is no such name
    const std::string& at(int slot) const { return names_[std::size_t(slot)]; }
    std::size_t size() const { return names_.size(); }

private:
    std::vector<std::string> names_;
    std::map<std::string, int, std::less<>> slots_;
};

/// Whether a slot is that of xmin, ymin, xmax or ymax.
constexpr bool isEdge(int slot) { return slot >= 4 && slot < 8; }
/// Whether it is that of x1, y1, x2 or y2.
constexpr bool isGivenEnd(int slot) { return slot >= 0 && slot < 4; }

enum class Kind {
    Number, ///< and bits and truths
    Name,
    Element, ///< x[i]: one of sixteen variables, by the value of its part
    Negative,
    Complement,
    Not,
    Sum,
    Difference,
    Product,
    Quotient,
    BitAnd,
    BitOr,
    Less,
    Greater,
    AtMost,
    AtLeast,
    Equal,
    NotEqual,
    And,
    Or,
    Choice,   ///< c ? a : b
    Function, ///< outcode, abs, sign, min, max, held, atEdge, vertical, edge, order, yAt, xAt
    Call      ///< of what the pseudo-code defines: it has no value
};

/// A formula, or a part of one.
struct Expression {
    Kind kind = Kind::Number;
    double number = 0;
    std::string name{};              ///< of a function or a call
    std::vector<int> variables{};    ///< one of a Name, sixteen of an Element
    std::vector<Expression> parts{}; ///< operands, arguments
};

/// Whether it is a number or a variable as it is: there is nothing to be computed.
inline bool isCopy(const Expression& e)
{
    return e.kind == Kind::Number || e.kind == Kind::Name || e.kind == Kind::Element;
}

} // namespace app::formulas
