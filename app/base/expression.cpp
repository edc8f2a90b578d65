// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/expression.h"

#include "app/base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace app {
namespace {

constexpr std::size_t longest = 200; // characters; also limits the nesting of brackets

/// A plain number, or a number of units.
struct Quantity {
    double number = 0;
    std::optional<double> unit{}; ///< the unit's size in the result's unit; empty: a plain number

    double length() const { return number * unit.value_or(1); }
};

/// Reads by the grammar  sum = term {(+|-) term};  term = factor {(*|/) factor};
/// factor = {+|-} (number [unit] | "(" sum ")").
class Reader {
public:
    Reader(std::string_view text, const Scale& scale) : text_(text), scale_(scale) {}

    /// Reads the whole text; error() says what is wrong.
    Quantity read()
    {
        const Quantity value = sum();
        if (!skipBlank().empty())
            refuse(Text::tr("“%1” is not expected there").arg(next()));
        return value;
    }
    const QString& error() const { return error_; }

private:
    std::string_view skipBlank()
    {
        text_.remove_prefix(std::min(text_.find_first_not_of(" \t"), text_.size()));
        return text_;
    }
    bool take(char sign)
    {
        if (!skipBlank().starts_with(sign))
            return false;
        text_.remove_prefix(1);
        return true;
    }
    /// The next word or character.
    QString next()
    {
        const std::string_view rest = skipBlank();
        const auto letter = [](char c) { // a letter, or a byte of a UTF-8 character
            return c < 0 || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        };
        const auto end = std::ranges::find_if_not(rest, letter);
        const auto size = std::max<std::ptrdiff_t>(end - rest.begin(), rest.empty() ? 0 : 1);
        return QString::fromUtf8(rest.data(), size);
    }
    void refuse(const QString& why)
    {
        if (error_.isEmpty()) // keep only the first error
            error_ = why;
        text_ = {};
    }

    Quantity sum()
    {
        Quantity value = term();
        for (;;) {
            const double sign = take('+') ? 1 : take('-') ? -1 : 0;
            if (sign == 0)
                return value;
            const Quantity other = term();
            if (value.unit == other.unit)
                value.number += sign * other.number;
            else // a plain number is in the unit of the result
                value = {value.length() + sign * other.length(), 1.0};
        }
    }
    Quantity term()
    {
        Quantity value = factor();
        for (;;)
            if (take('*'))
                value = product(value, factor());
            else if (take('/'))
                value = quotient(value, factor());
            else
                return value;
    }
    Quantity product(const Quantity& a, const Quantity& b)
    {
        if (a.unit && b.unit)
            refuse(Text::tr("a length times a length is an area"));
        return {a.number * b.number, a.unit ? a.unit : b.unit};
    }
    Quantity quotient(const Quantity& a, const Quantity& b)
    {
        if (b.number == 0)
            refuse(Text::tr("division by zero"));
        if (a.unit && b.unit)
            return {a.length() / b.length()};
        return {a.number / b.number, a.unit ? a.unit : b.unit}; // 1/2in: half a unit
    }
    Quantity factor()
    {
        if (take('+'))
            return factor();
        if (take('-')) {
            Quantity value = factor();
            value.number = -value.number;
            return value;
        }
        if (take('(')) {
            const Quantity value = sum();
            if (!take(')'))
                refuse(Text::tr("a “)” is missing"));
            return value;
        }
        return number();
    }
    Quantity number()
    {
        const std::string_view rest = skipBlank();
        if (rest.empty()) {
            refuse(Text::tr("the sum ends without a number"));
            return {};
        }
        Quantity value;
        const bool digits = (rest[0] >= '0' && rest[0] <= '9') || rest[0] == '.';
        const auto [end, wrong] =
            std::from_chars(rest.data(), rest.data() + rest.size(), value.number);
        if (!digits || wrong == std::errc::invalid_argument)
            refuse(Text::tr("“%1” is not a number").arg(next()));
        else if (wrong == std::errc::result_out_of_range)
            refuse(Text::tr("a number is too large"));
        else
            text_.remove_prefix(std::size_t(end - rest.data()));
        value.unit = unit();
        return value;
    }
    std::optional<double> unit()
    {
        const std::string_view rest = skipBlank();
        if (rest.empty() || std::string_view("+-*/()").find(rest[0]) != std::string_view::npos)
            return std::nullopt;
        const auto word = next().toStdString();
        const auto found = std::ranges::find(units(), word, &UnitInfo::suffix);
        if (found == units().end() || found->unit == Unit::Percent) {
            refuse(Text::tr("“%1” is not a unit of length here").arg(next()));
            return std::nullopt;
        }
        text_.remove_prefix(word.size());
        return found->unit == scale_.unit ? 1 : sizeOf(found->unit) / sizeOf(scale_.unit);
    }
    double sizeOf(Unit unit) const // in millimetres
    {
        const double size = infoOf(unit).millimetres;
        return size > 0 ? size : scale_.millimetresPerUnit;
    }

    std::string_view text_;
    Scale scale_;
    QString error_;
};

} // namespace

Result<double> evaluated(std::string_view text, const Scale& scale)
{
    if (text.size() > longest)
        return Result<double>::failure(Text::tr("it is longer than %1 characters").arg(longest));
    Reader reader(text, scale);
    const double length = reader.read().length();
    if (!reader.error().isEmpty())
        return Result<double>::failure(reader.error());
    if (!std::isfinite(length))
        return Result<double>::failure(Text::tr("its result is too large"));
    return Result<double>::of(length);
}

} // namespace app
