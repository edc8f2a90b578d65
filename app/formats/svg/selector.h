// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/tree.h"

#include <optional>
#include <string_view>
#include <vector>

namespace app::svg {

/// One part of a selector, without combinators: "path.thin#a[d]", ":root".
struct Compound {
    std::string_view tag, id; ///< "": matches any
    std::vector<std::string_view> classes;
    bool root = false; ///< ":root": the root alone
    struct Attribute {
        std::string_view name, value;
        bool anyValue = false;
    };
    std::vector<Attribute> attributes;
    char before = ' '; ///< the combinator with the part on its left: ' ' descendant, '>' child
};

/// The parts from left to right; never empty.
using Selector = std::vector<Compound>;

/// Empty for unsupported selectors (":hover", "a + b").
std::optional<Selector> parseSelector(std::string_view text);

/// CSS's three numbers (ids; classes and attributes; tags) packed into one.
int specificityOf(const Selector& selector);

/// Whether an element matches one part, regardless of the elements around it.
bool matches(const Tree& tree, Node node, const Compound& part);

} // namespace app::svg
