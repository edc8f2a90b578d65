// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/record.h"

#include "app/base/number.h"
#include "app/formats/dxf/limits.h"

#include <algorithm>
#include <cmath>

namespace app::dxf {

double numberOf(std::string_view text)
{
    const auto number = parseNumber(text);
    if (!number || std::abs(*number) > largestCoordinate)
        throw BadValue{};
    return *number;
}

int integerOf(std::string_view text)
{
    constexpr double largest = 2e9;       // so that its negative is a number, too
    const double number = numberOf(text); // some programs write 1.0
    if (std::abs(number) > largest)
        throw BadValue{};
    return int(number);
}

const Pair* Record::find(int code) const
{
    const auto found = std::ranges::find(pairs, code, &Pair::code);
    return found == pairs.end() ? nullptr : &*found;
}

std::string_view Record::text(int code, std::string_view otherwise) const
{
    const Pair* const pair = find(code);
    return pair ? pair->value : otherwise;
}

double Record::number(int code, double otherwise) const
{
    const Pair* const pair = find(code);
    return pair ? numberOf(pair->value) : otherwise;
}

int Record::integer(int code, int otherwise) const
{
    const Pair* const pair = find(code);
    return pair ? integerOf(pair->value) : otherwise;
}

glm::dvec3 Record::point(int code, const glm::dvec3& otherwise) const
{
    return {number(code, otherwise.x), number(code + 10, otherwise.y),
            number(code + 20, otherwise.z)};
}

std::vector<glm::dvec3> pointsOf(const Record& record, int code)
{
    std::vector<glm::dvec3> points;
    for (const auto& [found, value] : record.pairs)
        if (found == code)
            points.emplace_back(numberOf(value), 0, 0);
        else if (!points.empty() && found == code + 10)
            points.back().y = numberOf(value);
        else if (!points.empty() && found == code + 20)
            points.back().z = numberOf(value);
    return points;
}

std::vector<double> numbersOf(const Record& record, int code)
{
    std::vector<double> numbers;
    for (const auto& [found, value] : record.pairs)
        if (found == code)
            numbers.push_back(numberOf(value));
    return numbers;
}

Records::Records(std::string_view text) : pairs_(text)
{
    Pair pair{};
    while (take(pair) && pair.code != 0) {
    }
}

// The pair, or the beginning of the next record.
bool Records::take(Pair& pair)
{
    type_ = {};
    if (!pairs_.next(pair)) {
        damaged_ = pairs_.damaged();
        return false;
    }
    ++read_;
    if (pair.code == 0) {
        damaged_ = pair.value.empty();
        type_ = pair.value;
        lineOfType_ = pairs_.line();
    }
    return true;
}

bool Records::next(Record& record)
{
    constexpr int embedded = 101; // what follows repeats the codes with other meanings
    record.pairs.clear();
    if (type_.empty())
        return false;
    record.type = type_;
    record.line = lineOfType_;
    Pair pair{};
    bool kept = true;
    while (take(pair) && pair.code != 0) {
        kept = kept && pair.code != embedded;
        if (kept)
            record.pairs.push_back(pair);
    }
    return true;
}

} // namespace app::dxf
