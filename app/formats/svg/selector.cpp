// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/selector.h"

#include "app/base/text.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>

namespace app::svg {
namespace {

using Pseudo = PseudoClass::Kind;

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

bool testsText(const AttributeTest& test, std::string_view value)
{
    using Kind = AttributeTest::Kind;
    const auto same = [&](std::string_view part) {
        return test.anyCase ? equalsIgnoringCase(part, test.value) : part == test.value;
    };
    const std::size_t size = test.value.size();
    const bool some = size > 0 && value.size() >= size;
    switch (test.kind) {
    case Kind::Present:
        return true;
    case Kind::Equal:
        return same(value);
    case Kind::Word:
        return size > 0 && hasWord(value, test.value);
    case Kind::Dash:
        return same(value)
               || (value.size() > size && value[size] == '-' && same(value.substr(0, size)));
    case Kind::Begin:
        return some && same(value.substr(0, size));
    case Kind::End:
        return some && same(value.substr(value.size() - size));
    case Kind::Contains:
        return size > 0 && value.find(test.value) != value.npos;
    }
    return false;
}

/// Matches one element against the selectors of a sheet.
class Matcher {
public:
    Matcher(const Tree& tree, Siblings& siblings, std::size_t& tried)
        : tree_(tree), siblings_(siblings), tried_(tried)
    {
    }

    bool matches(Node node, const Selector& selector, std::size_t last)
    {
        countTried(tried_, 1);
        if (!matchesPart(node, selector[last]))
            return false;
        if (last == 0)
            return true;
        const char how = selector[last].before;
        const bool beside = how == '+' || how == '~', once = how == '>' || how == '+';
        const auto next = [&](Node from) {
            return beside ? siblings_.of(from).previous : tree_.parent(from);
        };
        for (Node other = next(node); other != noNode; other = next(other)) {
            if (matches(other, selector, last - 1))
                return true;
            if (once)
                return false;
        }
        return false;
    }

private:
    bool matchesPart(Node node, const Compound& part)
    {
        if (!part.tag.empty() && tree_.name(node) != part.tag)
            return false;
        if (!part.id.empty() && tree_.attribute(node, "id") != part.id)
            return false;
        const auto classes =
            part.classes.empty() ? std::string_view() : tree_.attribute(node, "class");
        return std::ranges::all_of(part.classes, [&](auto name) { return hasWord(classes, name); })
               && std::ranges::all_of(part.attributes,
                                      [&](const AttributeTest& test) {
                                          return tree_.hasAttribute(node, test.name)
                                                 && testsText(test,
                                                              tree_.attribute(node, test.name));
                                      })
               && std::ranges::all_of(part.pseudo, [&](const PseudoClass& pseudo) {
                      return matchesPseudo(node, pseudo);
                  });
    }

    bool matchesPseudo(Node node, const PseudoClass& pseudo)
    {
        switch (pseudo.kind) {
        case Pseudo::Root:
            return node == 0;
        case Pseudo::Empty:
            return tree_.end(node) == node + 1;
        case Pseudo::Link:
            return tree_.name(node) == "a" && !hrefOf(tree_, node).empty();
        case Pseudo::Never:
            return false;
        case Pseudo::Nth:
            return isNth(node, pseudo);
        case Pseudo::Is:
        case Pseudo::Not:
            return std::ranges::any_of(pseudo.list,
                                       [&](const Selector& selector) {
                                           return matches(node, selector, selector.size() - 1);
                                       })
                   == (pseudo.kind == Pseudo::Is);
        }
        return false;
    }

    bool isNth(Node node, const PseudoClass& pseudo)
    {
        const Siblings::Position& at = siblings_.of(node);
        const auto number = std::int64_t(pseudo.ofType ? at.numberOfType : at.number);
        const auto count = std::int64_t(pseudo.ofType ? at.countOfType : at.count);
        const std::int64_t beyond = (pseudo.fromEnd ? count + 1 - number : number) - pseudo.first;
        return pseudo.step == 0 ? beyond == 0
                                : beyond % pseudo.step == 0 && beyond / pseudo.step >= 0;
    }

    const Tree& tree_;
    Siblings& siblings_;
    std::size_t& tried_;
};

struct Weight {
    std::size_t ids = 0, classes = 0, tags = 0;
    friend auto operator<=>(const Weight&, const Weight&) = default;
};

Weight weightOf(const Selector& selector)
{
    Weight all;
    for (const Compound& part : selector) {
        all.ids += !part.id.empty();
        all.classes += part.classes.size() + part.attributes.size();
        all.tags += !part.tag.empty();
        for (const PseudoClass& pseudo : part.pseudo) {
            Weight most;
            for (const Selector& each : pseudo.list)
                most = std::max(most, weightOf(each));
            const bool listed = pseudo.kind == Pseudo::Is || pseudo.kind == Pseudo::Not;
            if (!listed)
                most.classes = 1;
            if (!pseudo.weightless)
                all = {all.ids + most.ids, all.classes + most.classes, all.tags + most.tags};
        }
    }
    return all;
}

} // namespace

int specificityOf(const Selector& selector)
{
    const Weight all = weightOf(selector);
    const auto limited = [](std::size_t n) { return int(std::min<std::size_t>(n, 255)); };
    return limited(all.ids) << 16 | limited(all.classes) << 8 | limited(all.tags);
}

bool matches(const Tree& tree, Siblings& siblings, Node node, const Selector& selector,
             std::size_t& tried)
{
    return Matcher(tree, siblings, tried).matches(node, selector, selector.size() - 1);
}

void countTried(std::size_t& tried, std::size_t count)
{
    tried += count;
    if (tried > mostDeclarations)
        throw Refused{Text::tr("its style sheet is too large for so many elements."),
                      Refused::wholeFile};
}

} // namespace app::svg
