// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/selector.h"

#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace app::svg {

class Report;

/// The style text without its /* comments */. Strings and unquoted addresses, url(…), contain no
/// comments. A comment inside a block is replaced by a blank and its line breaks, as it separates
/// words; `depth` is the nesting depth of the blocks around the text.
std::string withoutComments(std::string_view text, int depth);

/// A declaration such as "stroke-width: 2px !important".
struct Declaration {
    std::string_view property, value;
    bool important = false;
};

/// The declarations of a rule or a style attribute; invalid ones are left out.
std::vector<Declaration> parseDeclarations(std::string_view text);

struct Rule {
    Selector selector;
    std::size_t body = 0; ///< index of its declarations, which all selectors of a list share
    int specificity = 0;
};

/// The rules of the <style> elements, with those of @media for screens and of @import of data.
/// Rules whose selectors or conditions are not understood are reported, unless they cannot change
/// shapes.
class StyleSheet {
public:
    StyleSheet(const Tree& tree, Report& report);
    StyleSheet(const StyleSheet&) = delete;

    bool empty() const { return rules_.empty(); }

    /// The declarations that apply to an element, from the weakest rule to the strongest. Throws
    /// Refused if the number of tested rules exceeds mostDeclarations.
    std::vector<const std::vector<Declaration>*> matching(Node node);
    std::size_t& tried() { return tried_; } ///< the number of tested rules

private:
    using Index = std::unordered_map<std::string_view, std::vector<std::uint32_t>>;

    class Reader;
    void index(std::uint32_t rule);

    const Tree& tree_;
    Siblings siblings_;
    std::deque<std::string> texts_; ///< without comments; all views point into them
    std::vector<std::vector<Declaration>> bodies_;
    std::vector<Rule> rules_;
    Index byId_, byClass_, byTag_; ///< by the rightmost part of the selector
    std::size_t tried_ = 0;
};

} // namespace app::svg
