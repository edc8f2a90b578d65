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

/// The rules of the <style> elements with supported selectors: tags, classes, ids, attributes, `*`,
/// `:root`, lists of these, descendants and children, also in @media rules for screens. All others
/// (pseudo-classes, siblings, further at-rules) are reported, unless they cannot change shapes.
class StyleSheet {
public:
    StyleSheet(const std::vector<StyleText>& texts, Report& report);
    StyleSheet(const StyleSheet&) = delete;

    bool empty() const { return rules_.empty(); }

    /// The declarations that apply to an element, from the weakest rule to the strongest. Throws
    /// Refused if the number of tested rules exceeds mostDeclarations.
    std::vector<const std::vector<Declaration>*> matching(const Tree& tree, Node node);

private:
    using Index = std::unordered_map<std::string_view, std::vector<std::uint32_t>>;

    class Reader;
    void index(std::uint32_t rule);
    void countTried(std::size_t count); ///< throws Refused beyond mostDeclarations
    bool matches(const Tree& tree, Node node, const Selector& selector, std::size_t last);

    std::deque<std::string> texts_; ///< without comments; all views point into them
    std::vector<std::vector<Declaration>> bodies_;
    std::vector<Rule> rules_;
    Index byId_, byClass_, byTag_; ///< by the rightmost part of the selector
    std::size_t tried_ = 0;
};

} // namespace app::svg
