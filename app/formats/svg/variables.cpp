// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/variables.h"

#include "app/formats/svg/scanner.h"

#include <algorithm>

namespace app::svg {
namespace {

constexpr int deepest = 30;             // variables that refer to variables
constexpr std::size_t longest = 10'000; // bytes of one value
constexpr std::size_t most = 1'000;     // references that are followed for one value

// Where the next "var(" begins, or the end of the text.
std::size_t findReference(std::string_view text)
{
    for (std::size_t i = text.find('('); i != text.npos; i = text.find('(', i + 1)) {
        const bool named = i >= 3 && equalsIgnoringCase(text.substr(i - 3, 3), "var");
        if (named && (i == 3 || !isNameCharacter(text[i - 4])))
            return i - 3;
    }
    return text.size();
}

// The position of the bracket that closes the one before the text.
std::size_t endOfBrackets(std::string_view text)
{
    int depth = 1;
    for (std::size_t i = 0; i < text.size(); ++i) {
        depth += text[i] == '(';
        depth -= text[i] == ')';
        if (depth == 0)
            return i;
    }
    return text.size();
}

class Substitution {
public:
    explicit Substitution(const Variables* variables) : variables_(variables) {}

    bool append(std::string_view value, int depth)
    {
        while (!value.empty()) {
            const auto begin = findReference(value);
            text_ += value.substr(0, begin);
            work_ += begin;
            if (text_.size() > longest)
                return false;
            value.remove_prefix(begin);
            if (value.empty())
                break;
            value.remove_prefix(4); // "var("
            const auto end = endOfBrackets(value);
            if (!appendReference(value.substr(0, end), depth))
                return false;
            value.remove_prefix(std::min(end + 1, value.size()));
        }
        return true;
    }

    std::string take() { return std::move(text_); }

    std::size_t work() const { return work_; }

private:
    std::optional<std::string_view> valueOf(std::string_view name)
    {
        for (const Variables* at = variables_; at; at = at->around.get()) {
            ++work_;
            const auto found = at->own.find(name);
            if (found != at->own.end())
                return equalsIgnoringCase(found->second, "initial") ? std::nullopt
                                                                    : std::optional(found->second);
        }
        return std::nullopt;
    }

    // `reference` is "--name, fallback".
    bool appendReference(std::string_view reference, int depth)
    {
        if (depth == deepest || ++followed_ > most)
            return false;
        const auto comma = std::min(reference.find(','), reference.size());
        const auto size = text_.size();
        const auto value = valueOf(trimmed(reference.substr(0, comma)));
        if (value && append(*value, depth + 1))
            return true;
        text_.resize(size); // a variable that refers to an unknown one has no value either
        return comma < reference.size() && append(trimmed(reference.substr(comma + 1)), depth + 1);
    }

    const Variables* variables_;
    std::string text_;
    std::size_t followed_ = 0, work_ = 0;
};

} // namespace

bool usesVariables(std::string_view value) { return findReference(value) < value.size(); }

Substituted substituted(std::string_view value, const Variables* variables)
{
    Substitution substitution(variables);
    const bool isWhole = substitution.append(value, 0);
    return {isWhole ? std::optional(substitution.take()) : std::nullopt, substitution.work()};
}

} // namespace app::svg
