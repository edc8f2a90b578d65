// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/css.h"

#include "app/formats/svg/limits.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>
#include <optional>

namespace app::svg {
namespace {

std::string withoutComments(std::string_view text)
{
    std::string result;
    result.reserve(std::max<std::size_t>(text.size(), 100)); // views of it are kept
    while (!text.empty()) {
        const auto begin = std::min(text.find("/*"), text.size());
        result += text.substr(0, begin);
        const auto end = text.find("*/", begin);
        text.remove_prefix(begin == text.size() || end == text.npos ? text.size() : end + 2);
    }
    return result;
}

bool isNameCharacter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-'
           || c == '_' || (static_cast<unsigned char>(c) & 0x80);
}

std::string_view takeName(std::string_view& text)
{
    const auto end = std::size_t(std::ranges::find_if_not(text, isNameCharacter) - text.begin());
    const auto name = text.substr(0, end);
    text.remove_prefix(end);
    return name;
}

std::optional<Compound::Attribute> takeAttribute(std::string_view& text)
{
    const auto close = text.find(']');
    if (close == text.npos)
        return std::nullopt;
    const auto inside = text.substr(0, close);
    text.remove_prefix(close + 1);
    const auto equals = inside.find('=');
    if (equals == inside.npos)
        return Compound::Attribute{trimmed(inside), {}, true};
    auto value = trimmed(inside.substr(equals + 1));
    if (value.size() >= 2 && (value.front() == '"' || value.front() == '\''))
        value = value.substr(1, value.size() - 2);
    const auto name = trimmed(inside.substr(0, equals));
    const bool plain = !name.empty() && std::ranges::all_of(name, isNameCharacter);
    return plain ? std::optional(Compound::Attribute{name, value}) : std::nullopt;
}

std::optional<Compound> takeCompound(std::string_view& text)
{
    Compound part;
    const auto all = text;
    if (text.starts_with('*'))
        text.remove_prefix(1);
    else
        part.tag = takeName(text);
    while (!text.empty()) {
        const char kind = text.front();
        if (kind != '.' && kind != '#' && kind != '[')
            break;
        text.remove_prefix(1);
        if (kind == '[') {
            const auto attribute = takeAttribute(text);
            if (!attribute)
                return std::nullopt;
            part.attributes.push_back(*attribute);
            continue;
        }
        const auto name = takeName(text);
        if (name.empty() || (kind == '#' && !part.id.empty()))
            return std::nullopt;
        if (kind == '#')
            part.id = name;
        else
            part.classes.push_back(name);
    }
    return text.size() < all.size() ? std::optional(part) : std::nullopt;
}

std::optional<std::vector<Compound>> parseSelector(std::string_view text)
{
    std::vector<Compound> parts;
    char before = ' ';
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        auto part = takeCompound(text);
        if (!part)
            return std::nullopt;
        part->before = before;
        parts.push_back(std::move(*part));
        const auto rest = trimmed(text);
        const bool apart = rest.size() < text.size();
        before = ' ';
        if (rest.starts_with('>')) {
            before = '>';
            text = rest.substr(1);
            if (trimmed(text).empty())
                return std::nullopt;
        } else if (!rest.empty() && !apart) {
            return std::nullopt; // ":hover", "+", "~"
        }
    }
    return parts.empty() ? std::nullopt : std::optional(std::move(parts));
}

int specificityOf(const std::vector<Compound>& selector)
{
    std::size_t ids = 0, classes = 0, tags = 0;
    for (const Compound& part : selector) {
        ids += !part.id.empty();
        classes += part.classes.size() + part.attributes.size();
        tags += !part.tag.empty();
    }
    const auto limited = [](std::size_t n) { return int(std::min<std::size_t>(n, 255)); };
    return limited(ids) << 16 | limited(classes) << 8 | limited(tags);
}

bool hasWord(std::string_view list, std::string_view word)
{
    for (list = trimmed(list); !list.empty(); list = trimmed(list)) {
        const auto end = std::min(list.find_first_of(blanks), list.size());
        if (list.substr(0, end) == word)
            return true;
        list.remove_prefix(end);
    }
    return false;
}

bool matches(const Tree& tree, Node node, const Compound& part)
{
    const auto classes = part.classes.empty() ? std::string_view() : tree.attribute(node, "class");
    return (part.tag.empty() || tree.name(node) == part.tag)
           && (part.id.empty() || tree.attribute(node, "id") == part.id)
           && std::ranges::all_of(part.classes, [&](auto name) { return hasWord(classes, name); })
           && std::ranges::all_of(part.attributes, [&](const Compound::Attribute& attribute) {
                  const auto value = tree.attribute(node, attribute.name);
                  return attribute.anyValue ? !value.empty() : value == attribute.value;
              });
}

// The end of the block that begins at text[open] == '{', one past its '}'.
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

// A semicolon or the end, outside of quotes and brackets ("url(data:image/png;base64,...)").
std::size_t endOfDeclaration(std::string_view text)
{
    char quote = 0;
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quote) {
            quote = c == quote ? 0 : quote;
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

} // namespace

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

StyleSheet::StyleSheet(std::string_view text) : text_(withoutComments(text))
{
    std::string_view rest = text_;
    for (rest = trimmed(rest); !rest.empty(); rest = trimmed(rest)) {
        const auto open = rest.find_first_of("{;");
        if (open == rest.npos) {
            break;
        }
        if (rest[open] == ';') { // "@import ...;"
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

bool StyleSheet::matches(const Tree& tree, Node node, const std::vector<Compound>& selector,
                         std::size_t last)
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
    std::ranges::sort(found); // rules_ is sorted by specificity, then by place
    found.erase(std::ranges::unique(found).begin(), found.end());
    std::vector<const std::vector<Declaration>*> bodies;
    for (const auto rule : found) {
        bodies.push_back(&bodies_[rules_[rule].body]);
        countTried(bodies.back()->size());
    }
    return bodies;
}

} // namespace app::svg
