// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/calc.h"

#include "app/formats/svg/scanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace app::svg {
namespace {

using CalcResult = std::optional<CalcValue>;

constexpr int deepestCalc = 30;
constexpr std::array<std::string_view, 4> calcNames{"calc", "min", "max", "clamp"};

std::string_view nameBefore(std::string_view text)
{
    const auto open = text.find('(');
    return open == text.npos ? std::string_view() : text.substr(0, open);
}

/// A parser by recursive descent: a sum of products of values.
class Calculation {
public:
    Calculation(std::string_view text, const CalcWords& words) : rest_(trimmed(text)), words_(words)
    {
    }
    CalcResult whole()
    {
        const CalcResult result = value(0);
        return trimmed(rest_).empty() && result && std::isfinite(result->value) ? result
                                                                                : std::nullopt;
    }

private:
    CalcResult sum(int depth)
    {
        CalcResult left = product(depth);
        for (skip(); left && !rest_.empty() && (rest_[0] == '+' || rest_[0] == '-'); skip()) {
            const double sign = rest_[0] == '+' ? 1 : -1;
            rest_.remove_prefix(1);
            const CalcResult right = product(depth);
            if (!right || right->isNumber != left->isNumber)
                return std::nullopt;
            left->value += sign * right->value;
        }
        return left;
    }

    CalcResult product(int depth)
    {
        CalcResult left = value(depth);
        for (skip(); left && !rest_.empty() && (rest_[0] == '*' || rest_[0] == '/'); skip()) {
            const bool divides = rest_[0] == '/';
            rest_.remove_prefix(1);
            const CalcResult right = value(depth);
            if (!right || !(right->isNumber || (!divides && left->isNumber))
                || (divides && right->value == 0))
                return std::nullopt;
            left = CalcValue{divides ? left->value / right->value : left->value * right->value,
                             left->isNumber && right->isNumber};
        }
        return left;
    }

    CalcResult value(int depth)
    {
        skip();
        if (depth == deepestCalc || rest_.empty())
            return std::nullopt;
        if (rest_[0] == '(')
            return function("calc", 0, depth);
        const auto name = nameBefore(rest_);
        for (const std::string_view known : calcNames)
            if (equalsIgnoringCase(name, known))
                return function(known, name.size(), depth);
        return word();
    }

    // A number with its unit, whose sign belongs to it.
    CalcResult word()
    {
        std::size_t end = rest_[0] == '+' || rest_[0] == '-';
        while (end < rest_.size()
               && !(std::string_view("+-*/(), \t\r\n\f").find(rest_[end]) != std::string_view::npos
                    && !isExponentSign(end)))
            ++end;
        const auto text = rest_.substr(0, end);
        rest_.remove_prefix(end);
        return words_.valueOf(text);
    }
    bool isExponentSign(std::size_t at) const
    {
        const bool sign = rest_[at] == '+' || rest_[at] == '-';
        return sign && at > 1 && (rest_[at - 1] == 'e' || rest_[at - 1] == 'E')
               && rest_[at - 2] >= '0' && rest_[at - 2] <= '9';
    }

    CalcResult function(std::string_view name, std::size_t size, int depth)
    {
        rest_.remove_prefix(size + 1);
        std::vector<CalcValue> values;
        for (bool more = true; more;) {
            const CalcResult one = sum(depth + 1);
            if (!one || (!values.empty() && one->isNumber != values[0].isNumber))
                return std::nullopt;
            values.push_back(*one);
            skip();
            more = rest_.starts_with(',');
            rest_.remove_prefix(more ? 1 : 0);
        }
        if (!rest_.starts_with(')'))
            return std::nullopt;
        rest_.remove_prefix(1);
        return combined(name, values);
    }

    static CalcResult combined(std::string_view name, const std::vector<CalcValue>& values)
    {
        const auto less = [](const CalcValue& a, const CalcValue& b) { return a.value < b.value; };
        if (name == "min")
            return *std::ranges::min_element(values, less);
        if (name == "max")
            return *std::ranges::max_element(values, less);
        if (name == "clamp")
            return values.size() == 3
                       ? CalcResult(std::max(values[0], std::min(values[1], values[2], less), less))
                       : std::nullopt;
        return values.size() == 1 ? CalcResult(values[0]) : std::nullopt;
    }

    void skip() { rest_ = trimmed(rest_); }

    std::string_view rest_;
    const CalcWords& words_;
};

} // namespace

bool isCalc(std::string_view text)
{
    const auto name = nameBefore(trimmed(text));
    return std::ranges::any_of(
        calcNames, [&](std::string_view known) { return equalsIgnoringCase(name, known); });
}

std::optional<CalcValue> calculated(std::string_view text, const CalcWords& words)
{
    return isCalc(text) ? Calculation(text, words).whole() : std::nullopt;
}

} // namespace app::svg
