// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/selector.h"

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace app::svg {

/// Style text without its /* comments */, which strings and addresses, url(…), do not hold. One
/// that is in a block leaves a blank, as it parts words; `depth` is that of the blocks around the
/// text.
std::string withoutComments(std::string_view text, int depth);

/// "stroke-width: 2px !important"
struct Declaration {
    std::string_view property, value;
    bool important = false;
};

/// The declarations of a rule or of an attribute "style"; what is not one is left out.
std::vector<Declaration> parseDeclarations(std::string_view text);

struct Rule {
    Selector selector;
    std::size_t body = 0; ///< which declarations; a list of selectors shares them
    int specificity = 0;
};

/// The rules of the <style> elements that are understood: tags, classes, ids, attributes, `*`,
/// lists of them, descendants and children. Others (pseudo-classes, siblings, at-rules) are
/// counted.
class StyleSheet {
public:
    explicit StyleSheet(std::string_view text);
    StyleSheet(const StyleSheet&) = delete;

    int ignored() const { return ignored_; }
    bool empty() const { return rules_.empty(); }

    /// The declarations for an element, the weakest rule's first. Throws Refused when far too much
    /// was tried.
    std::vector<const std::vector<Declaration>*> matching(const Tree& tree, Node node);

private:
    using Index = std::unordered_map<std::string_view, std::vector<std::uint32_t>>;

    void addRules(std::string_view selectors, std::string_view body);
    void index(std::uint32_t rule);
    void countTried(std::size_t count); ///< throws Refused where that becomes too much
    bool matches(const Tree& tree, Node node, const Selector& selector, std::size_t last);

    std::string text_; ///< without comments; what all views point into
    std::vector<std::vector<Declaration>> bodies_;
    std::vector<Rule> rules_;
    Index byId_, byClass_, byTag_; ///< of the rightmost part
    int ignored_ = 0;
    std::size_t tried_ = 0;
};

} // namespace app::svg
