// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/siblings.h"

#include <optional>
#include <string_view>
#include <vector>

namespace app::svg {

struct Compound;
/// The parts from left to right; never empty.
using Selector = std::vector<Compound>;

/// A condition on an attribute: "[d]", "[class~=thin i]".
struct AttributeTest {
    enum class Kind : std::uint8_t { Present, Equal, Word, Dash, Begin, End, Contains };
    std::string_view name{}, value{};
    Kind kind = Kind::Present;
    bool anyCase = false;
};

/// A condition on the place of an element: ":first-child", ":nth-of-type(2n+1)", ":not(.a, .b)".
struct PseudoClass {
    enum class Kind : std::uint8_t { Root, Empty, Link, Never, Nth, Is, Not };
    Kind kind = Kind::Root;
    int step = 0, first = 0;              ///< Nth: the numbers first, first + step, …, from 1
    bool fromEnd = false, ofType = false; ///< Nth
    bool weightless = false;              ///< Is: as ":where()"
    std::vector<Selector> list{};         ///< Is, Not
};

/// One part of a selector, without combinators: "path.thin#a[d]:first-child".
struct Compound {
    std::string_view tag{}, id{}; ///< "": matches any
    std::vector<std::string_view> classes{};
    std::vector<AttributeTest> attributes{};
    std::vector<PseudoClass> pseudo{};
    /// The combinator with the part on its left: ' ' descendant, '>' child, '+' next, '~' later
    /// sibling.
    char before = ' ';
};

/// Empty for unsupported selectors ("::before", ":lang(en)").
std::optional<Selector> parseSelector(std::string_view text);

/// The parts of a list between its commas, those in brackets and quotation marks apart.
std::vector<std::string_view> selectorsIn(std::string_view list);

/// CSS's three numbers (ids; classes and attributes; tags) packed into one.
int specificityOf(const Selector& selector);

/// Whether an element matches a selector. `tried` counts parts that were tested; throws Refused
/// beyond mostDeclarations.
bool matches(const Tree& tree, Siblings& siblings, Node node, const Selector& selector,
             std::size_t& tried);

/// Counts `count` steps of a style sheet's work. Throws Refused beyond mostDeclarations.
void countTried(std::size_t& tried, std::size_t count);

} // namespace app::svg
