// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/scanner.h"
#include "app/formats/svg/selector.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace app::svg {
namespace {

constexpr int deepestList = 8; // of :not() in :is() in :not() …

std::string_view takeName(std::string_view& text)
{
    const auto end = std::size_t(std::ranges::find_if_not(text, isNameCharacter) - text.begin());
    const auto name = text.substr(0, end);
    text.remove_prefix(end);
    return name;
}

struct AttributeOperator {
    char sign; ///< before "="
    AttributeTest::Kind kind;
};
constexpr std::array attributeOperators{AttributeOperator{'~', AttributeTest::Kind::Word},
                                        AttributeOperator{'|', AttributeTest::Kind::Dash},
                                        AttributeOperator{'^', AttributeTest::Kind::Begin},
                                        AttributeOperator{'$', AttributeTest::Kind::End},
                                        AttributeOperator{'*', AttributeTest::Kind::Contains}};

// Where the bracket is closed that was opened before the text; its size: nowhere.
std::size_t endOfBracket(std::string_view text, char open, char close)
{
    char quote = 0;
    int depth = 1;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quote)
            quote = c == quote ? '\0' : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        else if (c == close && --depth == 0)
            return i;
        else
            depth += c == open;
    }
    return text.size();
}

std::optional<AttributeTest> takeAttribute(std::string_view& text)
{
    const auto close = endOfBracket(text, '[', ']');
    if (close == text.size())
        return std::nullopt;
    auto inside = trimmed(text.substr(0, close));
    text.remove_prefix(close + 1);
    AttributeTest test{.name = takeName(inside)};
    if (inside.starts_with(':') || inside.starts_with("\\:")) // xlink:href
        return std::nullopt;
    inside = trimmed(inside);
    if (test.name.empty() || inside.empty())
        return inside.empty() && !test.name.empty() ? std::optional(test) : std::nullopt;
    test.kind = AttributeTest::Kind::Equal;
    for (const auto& [sign, kind] : attributeOperators)
        if (inside.front() == sign)
            test.kind = kind;
    inside.remove_prefix(test.kind == AttributeTest::Kind::Equal ? 0 : 1);
    if (!inside.starts_with('='))
        return std::nullopt;
    inside = trimmed(inside.substr(1));
    const char quote = inside.empty() ? '\0' : inside.front();
    if (quote == '"' || quote == '\'') {
        const auto end = inside.find(quote, 1);
        if (end == inside.npos)
            return std::nullopt;
        test.value = inside.substr(1, end - 1);
        inside.remove_prefix(end + 1);
    } else {
        test.value = inside.substr(0, inside.find_first_of(blanks));
        inside.remove_prefix(test.value.size());
    }
    inside = trimmed(inside);
    test.anyCase = equalsIgnoringCase(inside, "i");
    return inside.empty() || test.anyCase || equalsIgnoringCase(inside, "s") ? std::optional(test)
                                                                             : std::nullopt;
}

std::optional<int> numberIn(std::string_view text)
{
    if (text.starts_with('+'))
        text.remove_prefix(1);
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional(number)
                                                                    : std::nullopt;
}

// "odd", "3", "2n + 1", "-n+3".
bool readNth(std::string_view text, PseudoClass& nth)
{
    std::string plain;
    for (const char c : text)
        if (blanks.find(c) == blanks.npos)
            plain += c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    if (plain == "odd" || plain == "even") {
        nth.step = 2;
        nth.first = plain == "odd";
        return true;
    }
    const auto n = plain.find('n');
    const auto first = numberIn(n == plain.npos ? plain : std::string_view(plain).substr(n + 1));
    std::string step = n == plain.npos ? "0" : plain.substr(0, n);
    if (step.empty() || step == "+" || step == "-")
        step += '1';
    const auto steps = numberIn(step);
    const bool noFirst = n != plain.npos && n + 1 == plain.size();
    if (!steps || !(first || noFirst))
        return false;
    nth.step = *steps;
    nth.first = first.value_or(0);
    return true;
}

struct PlainPseudo {
    std::string_view name;
    PseudoClass meaning;
};
/// Those without brackets. What depends on a pointer or on typing is nothing in a picture.
const std::vector<PlainPseudo>& plainPseudos()
{
    using Kind = PseudoClass::Kind;
    static const std::vector<PlainPseudo> all{
        {"root", {Kind::Root}},
        {"empty", {Kind::Empty}},
        {"link", {Kind::Link}},
        {"any-link", {Kind::Link}},
        {"hover", {Kind::Never}},
        {"active", {Kind::Never}},
        {"focus", {Kind::Never}},
        {"focus-visible", {Kind::Never}},
        {"focus-within", {Kind::Never}},
        {"visited", {Kind::Never}},
        {"target", {Kind::Never}},
        {"first-child", {Kind::Nth, 0, 1}},
        {"last-child", {Kind::Nth, 0, 1, true}},
        {"first-of-type", {Kind::Nth, 0, 1, false, true}},
        {"last-of-type", {Kind::Nth, 0, 1, true, true}},
    };
    return all;
}

constexpr std::array nthNames{std::string_view("nth-child"), std::string_view("nth-last-child"),
                              std::string_view("nth-of-type"),
                              std::string_view("nth-last-of-type")};

class SelectorParser {
public:
    explicit SelectorParser(int depth) : depth_(depth) {}

    std::optional<Selector> parse(std::string_view text) const
    {
        Selector parts;
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
            if (!rest.empty() && std::string_view(">+~").find(rest.front()) != rest.npos) {
                before = rest.front();
                text = rest.substr(1);
                if (trimmed(text).empty())
                    return std::nullopt;
            } else if (!rest.empty() && !apart) {
                return std::nullopt;
            }
        }
        return parts.empty() ? std::nullopt : std::optional(std::move(parts));
    }

private:
    std::optional<Compound> takeCompound(std::string_view& text) const
    {
        Compound part;
        const auto all = text;
        if (text.starts_with('*'))
            text.remove_prefix(1);
        else
            part.tag = takeName(text);
        while (!text.empty() && std::string_view(".#[:").find(text.front()) != text.npos)
            if (!takeCondition(text, part))
                return std::nullopt;
        return text.size() < all.size() ? std::optional(std::move(part)) : std::nullopt;
    }

    bool takeCondition(std::string_view& text, Compound& part) const
    {
        const char kind = text.front();
        text.remove_prefix(1);
        if (kind == ':')
            return takePseudo(text, part);
        if (kind == '[') {
            const auto test = takeAttribute(text);
            if (test)
                part.attributes.push_back(*test);
            return test.has_value();
        }
        const auto name = takeName(text);
        if (name.empty() || (kind == '#' && !part.id.empty()))
            return false;
        if (kind == '#')
            part.id = name;
        else
            part.classes.push_back(name);
        return true;
    }

    bool takePseudo(std::string_view& text, Compound& part) const
    {
        const auto name = takeName(text);
        if (text.starts_with('('))
            return takeFunction(name, text, part);
        const auto is = [&](std::string_view word) { return equalsIgnoringCase(name, word); };
        for (const PlainPseudo& plain : plainPseudos())
            if (is(plain.name)) {
                part.pseudo.push_back(plain.meaning);
                return true;
            }
        const bool ofType = is("only-of-type");
        if (!ofType && !is("only-child"))
            return false;
        for (const bool fromEnd : {false, true})
            part.pseudo.push_back({PseudoClass::Kind::Nth, 0, 1, fromEnd, ofType});
        return true;
    }

    bool takeFunction(std::string_view name, std::string_view& text, Compound& part) const
    {
        text.remove_prefix(1);
        const auto close = endOfBracket(text, '(', ')');
        if (close == text.size())
            return false;
        const auto inside = text.substr(0, close);
        text.remove_prefix(close + 1);
        const auto is = [&](std::string_view word) { return equalsIgnoringCase(name, word); };
        PseudoClass pseudo;
        if (std::ranges::any_of(nthNames, is)) {
            pseudo = {PseudoClass::Kind::Nth, 0, 0, name.find("last") != name.npos,
                      name.find("type") != name.npos};
            part.pseudo.push_back(pseudo);
            return readNth(inside, part.pseudo.back());
        }
        if (!is("not") && !is("is") && !is("where") && !is("matches") && !is("-webkit-any"))
            return false;
        pseudo.kind = is("not") ? PseudoClass::Kind::Not : PseudoClass::Kind::Is;
        pseudo.weightless = is("where");
        for (const auto one :
             depth_ < deepestList ? selectorsIn(inside) : std::vector<std::string_view>())
            if (auto selector = SelectorParser(depth_ + 1).parse(one))
                pseudo.list.push_back(std::move(*selector));
            else
                return false;
        part.pseudo.push_back(std::move(pseudo));
        return !part.pseudo.back().list.empty();
    }

    int depth_;
};

} // namespace

std::vector<std::string_view> selectorsIn(std::string_view list)
{
    std::vector<std::string_view> all;
    char quote = 0;
    int depth = 0;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const char c = list[i];
        if (quote) {
            quote = c == quote ? '\0' : quote;
            continue;
        }
        quote = c == '"' || c == '\'' ? c : '\0';
        depth += (c == '(' || c == '[') - (c == ')' || c == ']');
        if (c == ',' && depth <= 0) {
            all.push_back(trimmed(list.substr(begin, i - begin)));
            begin = i + 1;
        }
    }
    if (const auto last = trimmed(list.substr(begin)); !last.empty() || all.empty())
        all.push_back(last);
    return all;
}

std::optional<Selector> parseSelector(std::string_view text)
{
    return SelectorParser(0).parse(text);
}

} // namespace app::svg
