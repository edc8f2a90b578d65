// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/css.h"

#include "app/formats/svg/limits.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>

namespace app::svg {
namespace {

// The end of the block that begins at text[open] == '{': one past its '}'.
std::size_t endOfBlock(std::string_view text, std::size_t open)
{
    int depth = 0;
    for (std::size_t i = open; i < text.size(); ++i) {
        depth += text[i] == '{';
        depth -= text[i] == '}';
        if (depth == 0)
            return i + 1;
    }
    return text.size();
}

// The position of a semicolon outside quotes and brackets ("url(data:image/png;base64,...)"), or
// the end of the text.
std::size_t endOfDeclaration(std::string_view text)
{
    char quote = 0;
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quote) {
            quote = c == quote ? '\0' : quote;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == ';' && depth <= 0) {
            return i;
        }
        depth += !quote && c == '(';
        depth -= !quote && c == ')';
    }
    return text.size();
}

// One past the end of a literal that begins at text[i] and cannot contain comments: a string, or
// url(…) without quotes. `i + 1` if none begins there.
std::size_t endOfLiteral(std::string_view text, std::size_t i)
{
    if (text[i] == '"' || text[i] == '\'') {
        std::size_t end = i + 1;
        while (end < text.size() && text[end] != text[i] && text[end] != '\n')
            end += text[end] == '\\' ? 2 : 1;
        return std::min(end + 1, text.size());
    }
    const auto open = i + 4;
    if (!equalsIgnoringCase(text.substr(i, 4), "url(")
        || text.find_first_not_of(blanks, open) == text.find_first_of("\"'", open))
        return i + 1;
    return std::min(text.find(')', open), text.size() - 1) + 1;
}

} // namespace

std::string withoutComments(std::string_view text, int depth)
{
    std::string result;
    result.reserve(std::max<std::size_t>(text.size(), 100)); // on the heap, so that views of it
                                                             // survive a move
    for (std::size_t i = 0; i < text.size();) {
        if (text.substr(i, 2) == "/*") {
            const auto end = text.find("*/", i + 2);
            i = end == text.npos ? text.size() : end + 2;
            if (depth > 0)
                result += ' ';
            continue;
        }
        depth += text[i] == '{';
        depth -= text[i] == '}';
        const auto end = endOfLiteral(text, i);
        result += text.substr(i, end - i);
        i = end;
    }
    return result;
}

std::vector<Declaration> parseDeclarations(std::string_view text)
{
    std::vector<Declaration> declarations;
    while (!text.empty()) {
        const auto end = endOfDeclaration(text);
        const auto one = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const auto colon = one.find(':');
        if (colon == one.npos)
            continue;
        Declaration declaration{trimmed(one.substr(0, colon)), trimmed(one.substr(colon + 1))};
        const auto mark = declaration.value.rfind('!');
        if (mark != std::string_view::npos
            && equalsIgnoringCase(trimmed(declaration.value.substr(mark + 1)), "important")) {
            declaration.value = trimmed(declaration.value.substr(0, mark));
            declaration.important = true;
        }
        declarations.push_back(declaration);
    }
    return declarations;
}

StyleSheet::StyleSheet(std::string_view text) : text_(withoutComments(text, 0))
{
    std::string_view rest = text_;
    for (rest = trimmed(rest); !rest.empty(); rest = trimmed(rest)) {
        const auto open = rest.find_first_of("{;");
        if (open == rest.npos) {
            break;
        }
        if (rest[open] == ';') { // an at-rule without a block: "@import ...;"
            ignored_ += rest.starts_with('@') && !rest.starts_with("@charset");
            rest.remove_prefix(open + 1);
            continue;
        }
        const auto end = endOfBlock(rest, open);
        const auto before = rest.substr(0, open);
        auto body = rest.substr(open + 1, end - open - 1);
        if (body.ends_with('}'))
            body.remove_suffix(1);
        if (before.starts_with('@'))
            ++ignored_;
        else
            addRules(before, body);
        rest.remove_prefix(end);
    }
    std::ranges::stable_sort(rules_, {}, &Rule::specificity);
    for (std::uint32_t i = 0; i < rules_.size(); ++i)
        index(i);
}

void StyleSheet::addRules(std::string_view selectors, std::string_view body)
{
    bodies_.push_back(parseDeclarations(body));
    while (!selectors.empty()) {
        const auto comma = std::min(selectors.find(','), selectors.size());
        auto selector = parseSelector(selectors.substr(0, comma));
        selectors.remove_prefix(std::min(comma + 1, selectors.size()));
        if (!selector) {
            ++ignored_;
            continue;
        }
        const int specificity = specificityOf(*selector);
        rules_.push_back({std::move(*selector), bodies_.size() - 1, specificity});
    }
}

void StyleSheet::index(std::uint32_t rule)
{
    const Compound& last = rules_[rule].selector.back();
    if (!last.id.empty())
        byId_[last.id].push_back(rule);
    else if (!last.classes.empty())
        byClass_[last.classes.front()].push_back(rule);
    else
        byTag_[last.tag].push_back(rule);
}

void StyleSheet::countTried(std::size_t count)
{
    tried_ += count;
    if (tried_ > mostDeclarations)
        throw Refused{Text::tr("its style sheet is too large for so many elements."),
                      Refused::wholeFile};
}

bool StyleSheet::matches(const Tree& tree, Node node, const Selector& selector, std::size_t last)
{
    countTried(1);
    if (!svg::matches(tree, node, selector[last]))
        return false;
    if (last == 0)
        return true;
    const bool child = selector[last].before == '>';
    for (Node up = tree.parent(node); up != noNode; up = tree.parent(up)) {
        if (matches(tree, up, selector, last - 1))
            return true;
        if (child)
            return false;
    }
    return false;
}

std::vector<const std::vector<Declaration>*> StyleSheet::matching(const Tree& tree, Node node)
{
    std::vector<std::uint32_t> found;
    const auto tryThose = [&](const Index& index, std::string_view key) {
        const auto at = index.find(key);
        if (at == index.end())
            return;
        for (const auto rule : at->second)
            if (matches(tree, node, rules_[rule].selector, rules_[rule].selector.size() - 1))
                found.push_back(rule);
    };
    tryThose(byTag_, "");
    tryThose(byTag_, tree.name(node));
    auto classes = trimmed(tree.attribute(node, "class"));
    while (!classes.empty()) {
        const auto end = std::min(classes.find_first_of(blanks), classes.size());
        tryThose(byClass_, classes.substr(0, end));
        classes = trimmed(classes.substr(end));
    }
    if (const auto id = tree.attribute(node, "id"); !id.empty())
        tryThose(byId_, id);
    std::ranges::sort(found); // rules_ is sorted by specificity, then by position
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::vector<const std::vector<Declaration>*> bodies;
    for (const auto rule : found) {
        bodies.push_back(&bodies_[rules_[rule].body]);
        countTried(bodies.back()->size());
    }
    return bodies;
}

} // namespace app::svg
