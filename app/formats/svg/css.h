// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/selector.h"

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace app::svg {

/// The style text without its /* comments */. Strings and unquoted addresses, url(…), contain no
/// comments. A comment inside a block is replaced by a blank, as it separates words; `depth` is the
/// nesting depth of the blocks around the text.
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
/// lists of these, descendants and children. Other rules (pseudo-classes, siblings, at-rules) are
/// only counted.
class StyleSheet {
public:
    explicit StyleSheet(std::string_view text);
    StyleSheet(const StyleSheet&) = delete;

    int ignored() const { return ignored_; }
    bool empty() const { return rules_.empty(); }

    /// The declarations that apply to an element, from the weakest rule to the strongest. Throws
    /// Refused if the number of tested rules exceeds mostDeclarations.
    std::vector<const std::vector<Declaration>*> matching(const Tree& tree, Node node);

private:
    using Index = std::unordered_map<std::string_view, std::vector<std::uint32_t>>;

    void addRules(std::string_view selectors, std::string_view body);
    void index(std::uint32_t rule);
    void countTried(std::size_t count); ///< throws Refused beyond mostDeclarations
    bool matches(const Tree& tree, Node node, const Selector& selector, std::size_t last);

    std::string text_; ///< without comments; all views point into it
    std::vector<std::vector<Declaration>> bodies_;
    std::vector<Rule> rules_;
    Index byId_, byClass_, byTag_; ///< by the rightmost part of the selector
    int ignored_ = 0;
    std::size_t tried_ = 0;
};

} // namespace app::svg
