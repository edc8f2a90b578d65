// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/selector.h"

#include "app/formats/svg/scanner.h"

#include <algorithm>

namespace app::svg {
namespace {

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
        if (kind != '.' && kind != '#' && kind != '[' && kind != ':')
            break;
        text.remove_prefix(1);
        if (kind == ':') {
            if (part.root = takeName(text) == "root"; !part.root)
                return std::nullopt;
            continue;
        }
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

} // namespace

std::optional<Selector> parseSelector(std::string_view text)
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
        if (rest.starts_with('>')) {
            before = '>';
            text = rest.substr(1);
            if (trimmed(text).empty())
                return std::nullopt;
        } else if (!rest.empty() && !apart) {
            return std::nullopt; // unsupported: ":hover", "+", "~"
        }
    }
    return parts.empty() ? std::nullopt : std::optional(std::move(parts));
}

int specificityOf(const Selector& selector)
{
    std::size_t ids = 0, classes = 0, tags = 0;
    for (const Compound& part : selector) {
        ids += !part.id.empty();
        classes += part.classes.size() + part.attributes.size() + part.root;
        tags += !part.tag.empty();
    }
    const auto limited = [](std::size_t n) { return int(std::min<std::size_t>(n, 255)); };
    return limited(ids) << 16 | limited(classes) << 8 | limited(tags);
}

bool matches(const Tree& tree, Node node, const Compound& part)
{
    const auto classes = part.classes.empty() ? std::string_view() : tree.attribute(node, "class");
    return (!part.root || node == 0) && (part.tag.empty() || tree.name(node) == part.tag)
           && (part.id.empty() || tree.attribute(node, "id") == part.id)
           && std::ranges::all_of(part.classes, [&](auto name) { return hasWord(classes, name); })
           && std::ranges::all_of(part.attributes, [&](const Compound::Attribute& attribute) {
                  const auto value = tree.attribute(node, attribute.name);
                  return attribute.anyValue ? !value.empty() : value == attribute.value;
              });
}

} // namespace app::svg
