// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/css.h"

#include "app/formats/svg/data_address.h"
#include "app/formats/svg/media.h"
#include "app/formats/svg/report.h"
#include "app/formats/svg/scanner.h"
#include "app/formats/svg/supports.h"

#include <algorithm>
#include <array>
#include <utility>

namespace app::svg {
namespace {

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

// The position of the first of these characters outside literals, or the end of the text.
std::size_t findOutside(std::string_view text, std::string_view characters)
{
    std::size_t i = 0;
    while (i < text.size() && characters.find(text[i]) == characters.npos)
        i = endOfLiteral(text, i);
    return std::min(i, text.size());
}

// The end of the block that begins at text[open] == '{': one past its '}'.
std::size_t endOfBlock(std::string_view text, std::size_t open)
{
    int depth = 0;
    for (std::size_t i = open; i < text.size(); i = endOfLiteral(text, i)) {
        depth += text[i] == '{';
        depth -= text[i] == '}';
        if (depth == 0)
            return i + 1;
    }
    return text.size();
}

// Whether a comment between these texts separates nothing that would belong together without it.
bool isApart(std::string_view before, std::string_view after)
{
    constexpr std::string_view ends = " \t\r\n\f{};,>";
    return before.empty() || after.empty() || ends.find(before.back()) != ends.npos
           || ends.find(after.front()) != ends.npos;
}

} // namespace

std::string withoutComments(std::string_view text, int depth)
{
    std::string result;
    result.reserve(std::max<std::size_t>(text.size(), 100)); // on the heap, so that views of it
                                                             // survive a move
    for (std::size_t i = 0; i < text.size();) {
        if (text.substr(i, 2) == "/*") {
            const auto end = std::min(text.find("*/", i + 2), text.size());
            const auto lines = std::ranges::count(text.substr(i, end - i), '\n');
            i = std::min(end + 2, text.size());
            if (depth > 0 || isApart(result, text.substr(i)))
                result.append(" ").append(std::size_t(lines), '\n');
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

namespace {

// Rules that change no shape. Those for animations are told where an element uses them.
constexpr std::array<std::string_view, 9> rulesWithoutEffect{"@charset",
                                                             "@counter-style",
                                                             "@font-face",
                                                             "@font-feature-values",
                                                             "@font-palette-values",
                                                             "@keyframes",
                                                             "@namespace",
                                                             "@-webkit-keyframes",
                                                             "@page"};

// Rules for parts of a page that a drawing does not have: "a::before".
bool ofNothingDrawn(std::string_view selector)
{
    constexpr std::array<std::string_view, 6> parts{"::before", "::after",     ":before",
                                                    ":after",   "::selection", "::marker"};
    return std::ranges::any_of(parts, [&](auto part) { return selector.ends_with(part); });
}

std::string_view firstWord(std::string_view text)
{
    return text.substr(0, text.find_first_of(" \t\r\n\f("));
}

} // namespace

// Reads the rules of one style element after the other.
class StyleSheet::Reader {
public:
    Reader(StyleSheet& sheet, Report& report) : sheet_(sheet), report_(report) {}

    void read(const StyleText& text)
    {
        const auto applies = appliesToScreens(text.media);
        line_ = text.line;
        counted_ = 0;
        if (!applies) {
            report_.turnTo(line_);
            report_.add(losses::styleRule, "media=" + text.media);
        }
        if (!applies.value_or(false))
            return;
        read(withoutComments(text.text, 0), 0);
    }

private:
    void read(std::string text, int depth)
    {
        sheet_.texts_.push_back(std::move(text));
        const std::string* const around = std::exchange(text_, &sheet_.texts_.back());
        const auto counted = std::exchange(counted_, 0);
        readRules(*text_, depth);
        text_ = around;
        counted_ = counted;
    }

    void readRules(std::string_view rest, int depth)
    {
        for (rest = trimmed(rest); !rest.empty(); rest = trimmed(rest)) {
            if (rest.starts_with("<!--") || rest.starts_with("-->")) { // from old HTML
                rest.remove_prefix(rest.front() == '<' ? 4 : 3);
                continue;
            }
            const auto open = findOutside(rest, "{;");
            if (open == rest.size())
                break;
            const auto before = trimmed(rest.substr(0, open));
            if (rest[open] == ';') { // an at-rule without a block: "@import ...;"
                readAtRule(before, {}, depth);
                rest.remove_prefix(open + 1);
                continue;
            }
            const auto end = endOfBlock(rest, open);
            auto body = rest.substr(open + 1, end - open - 1);
            if (body.ends_with('}'))
                body.remove_suffix(1);
            if (before.starts_with('@'))
                readAtRule(before, body, depth);
            else
                addRules(before, body);
            rest.remove_prefix(end);
        }
    }

    void readAtRule(std::string_view before, std::string_view body, int depth)
    {
        constexpr int deepest = 10; // nested rules
        const auto name = firstWord(before);
        const auto isName = [&](auto each) { return equalsIgnoringCase(each, name); };
        if (!before.starts_with('@') || std::ranges::any_of(rulesWithoutEffect, isName))
            return;
        if (isName("@import"))
            return readImport(before, trimmed(before.substr(name.size())), depth);
        const auto condition = before.substr(name.size());
        const auto applies = isName("@media")      ? appliesToScreens(condition)
                             : isName("@supports") ? isSupported(condition)
                                                   : std::nullopt;
        if (!applies || depth == deepest)
            tell(before);
        else if (*applies)
            readRules(body, depth + 1);
    }

    // `rest`: "url(data:text/css,...) screen". Other files are not read.
    void readImport(std::string_view rule, std::string_view rest, int depth)
    {
        constexpr int deepest = 10;
        const auto end = rest.empty() ? 0 : endOfLiteral(rest, 0);
        const auto data = dataOf(rest.substr(0, end));
        const auto applies = appliesToScreens(rest.substr(end));
        if (!data || !applies || depth == deepest)
            tell(rule);
        else if (*applies)
            read(withoutComments(*data, 0), depth + 1);
    }

    void addRules(std::string_view selectors, std::string_view body)
    {
        sheet_.bodies_.push_back(parseDeclarations(withoutNestedRules(body)));
        for (const std::string_view one : selectorsIn(selectors)) {
            auto selector = parseSelector(one);
            if (!selector) {
                if (!ofNothingDrawn(one))
                    tell(one);
                continue;
            }
            const int specificity = specificityOf(*selector);
            sheet_.rules_.push_back({std::move(*selector), sheet_.bodies_.size() - 1, specificity});
        }
    }

    // Rules in rules are told, and taken away from the declarations around them.
    std::string_view withoutNestedRules(std::string_view body)
    {
        if (body.find('{') == body.npos)
            return body;
        std::string plain;
        while (!body.empty()) {
            const auto end = findOutside(body, "{;");
            if (end < body.size() && body[end] == '{') {
                tell(trimmed(body.substr(0, end)));
                body.remove_prefix(endOfBlock(body, end));
            } else {
                plain += body.substr(0, end + 1);
                body.remove_prefix(std::min(end + 1, body.size()));
            }
        }
        return sheet_.texts_.emplace_back(std::move(plain));
    }

    void tell(std::string_view rule)
    {
        const std::string& text = *text_;
        const auto at = std::size_t(rule.data() - text.data());
        const auto place = text.begin() + std::ptrdiff_t(at), counted = text.begin() + counted_;
        line_ +=
            counted < place ? std::count(counted, place, '\n') : -std::count(place, counted, '\n');
        counted_ = std::ptrdiff_t(at);
        report_.turnTo(line_);
        report_.add(losses::styleRule, rule);
    }

    StyleSheet& sheet_;
    Report& report_;
    const std::string* text_ = nullptr; ///< that is being read
    qint64 line_ = 0;                   ///< of the place up to which lines were counted
    std::ptrdiff_t counted_ = 0;        ///< this place in the text
};

StyleSheet::StyleSheet(const Tree& tree, Report& report) : tree_(tree), siblings_(tree)
{
    Reader reader(*this, report);
    for (const StyleText& text : tree.styleSheets())
        reader.read(text);
    std::ranges::stable_sort(rules_, {}, &Rule::specificity);
    for (std::uint32_t i = 0; i < rules_.size(); ++i)
        index(i);
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

std::vector<const std::vector<Declaration>*> StyleSheet::matching(Node node)
{
    std::vector<std::uint32_t> found;
    const auto tryThose = [&](const Index& index, std::string_view key) {
        const auto at = index.find(key);
        if (at == index.end())
            return;
        for (const auto rule : at->second)
            if (matches(tree_, siblings_, node, rules_[rule].selector, tried_))
                found.push_back(rule);
    };
    tryThose(byTag_, "");
    tryThose(byTag_, tree_.name(node));
    auto classes = trimmed(tree_.attribute(node, "class"));
    while (!classes.empty()) {
        const auto end = std::min(classes.find_first_of(blanks), classes.size());
        tryThose(byClass_, classes.substr(0, end));
        classes = trimmed(classes.substr(end));
    }
    if (const auto id = tree_.attribute(node, "id"); !id.empty())
        tryThose(byId_, id);
    std::ranges::sort(found); // rules_ is sorted by specificity, then by position
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::vector<const std::vector<Declaration>*> bodies;
    for (const auto rule : found) {
        bodies.push_back(&bodies_[rules_[rule].body]);
        countTried(tried_, bodies.back()->size());
    }
    return bodies;
}

} // namespace app::svg
