// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/tree.h"

#include <optional>
#include <string_view>
#include <vector>

namespace app::svg {

/// One part of a selector, without combinators: "path.thin#a[d]".
struct Compound {
    std::string_view tag, id; ///< "" where any will do
    std::vector<std::string_view> classes;
    struct Attribute {
        std::string_view name, value;
        bool anyValue = false;
    };
    std::vector<Attribute> attributes;
    char before = ' '; ///< how it is joined to the part on its left: ' ' descendant, '>' child
};

/// From left to right, never empty.
using Selector = std::vector<Compound>;

/// Nothing for what is not understood (":hover", "a + b").
std::optional<Selector> parseSelector(std::string_view text);

/// CSS's three numbers in one: ids, classes and attributes, tags.
int specificityOf(const Selector& selector);

/// Whether an element is as the part says, without regard to those around it.
bool matches(const Tree& tree, Node node, const Compound& part);

} // namespace app::svg
