// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/formulas/expression.h"
#include "clipping/counted.h"
#include "clipping/pseudo_code.h"

#include <array>
#include <optional>
#include <set>

namespace app::formulas {

/// A formula with its number in the code, so that it can be said which were evaluated.
struct Formula {
    Expression expression;
    std::size_t number = 0;
};

/// `target = value`, in a line of its own or of several.
struct Assignment {
    Expression target;
    Formula value;
};

/// f(p, q): the parameters of a definition, or the arguments of a call.
struct Parameters {
    std::string of;
    std::vector<int> variables;
};
struct Arguments {
    std::string of;
    std::vector<Formula> values;
};

/// One line of the pseudo-code, read.
struct Line {
    std::string text;
    bool accepts = false, rejects = false, givesUp = false, holds = false; ///< its words
    bool turns = false; ///< its call is made in a plane that is turned or mirrored
    std::optional<Formula> condition{};
    std::vector<Assignment> assignments{};
    std::vector<Arguments> calls{};
    std::optional<Parameters> definition{};
    int loop = -1;                    ///< the variable of a `for` line
    std::vector<Expression> rounds{}; ///< the values that it gets, one after another
    std::vector<int> ofEach{};        ///< names in a `for each` line
    std::vector<Formula> accepted{};  ///< the four coordinates after "accept the line from"
    clipping::OperationCounts mostOperations{};                    ///< that its formulas can cost
    bool comparesInFunctions = false, computesInFunctions = false; ///< some of them, unseen
    bool comparesLess = false; ///< a run may need fewer comparisons than it shows (exceptions.h)
};

/// The pseudo-code of one form.
struct Code {
    Names names;
    std::vector<Line> lines;
    std::vector<clipping::CodeLine> labels;  ///< that steps name, of each line
    std::array<int, 4> ends{-1, -1, -1, -1}; ///< the names of what is left, as slots: x, y, x, y
    std::size_t formulas = 0;                ///< how many there are, copies among them
    std::set<std::string> loops;             ///< the variables of `for` lines
};

/// The text of a labelled pseudo-code (clipping/pseudo_code.h) without the labels.
std::string withoutLabels(std::string_view code);
/// Reads a pseudo-code with or without labels. Throws Unreadable, which says in which line.
Code read(std::string_view code);

/// What a formula can cost at most, whichever way its conditions go.
clipping::OperationCounts mostOperationsOf(const Expression& e);
/// Whether a formula calls a function whose cost depends on its arguments.
bool callsFunction(const Expression& e);
/// Whether one of them does more than compare: order, yAt, xAt, side.
bool callsArithmetic(const Expression& e);
void add(clipping::OperationCounts& to, const clipping::OperationCounts& more);

/// Each formula that computes something, with its line, from 1.
struct Place {
    std::size_t line;
    const Formula* formula;
};
std::vector<Place> formulasOf(const Code& code);

} // namespace app::formulas
