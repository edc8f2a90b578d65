// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/scanner.h"

#include "app/base/text.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/refused.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace app::svg {
namespace {

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; }

[[noreturn]] void refuse(std::string_view text)
{
    const auto end = std::min(text.find_first_of(" ,;()\t\r\n"), std::size_t(20));
    throw Refused{Text::tr("has %1 where a finite number should be.")
                      .arg(QString::fromUtf8(text.substr(0, end)))};
}

// Whether a number out of range is too small rather than too large, which std::from_chars does not
// tell. Only small numbers have a negative exponent or start with zeros.
bool vanishes(std::string_view number)
{
    const auto e = number.find_first_of("eE");
    return e != number.npos ? number.substr(e + 1).starts_with('-')
                            : number.find_first_of("123456789") > number.find('.');
}

bool saysNotFinite(std::string_view text)
{
    if (text.starts_with('+') || text.starts_with('-'))
        text.remove_prefix(1);
    return equalsIgnoringCase(text.substr(0, 3), "nan")
           || equalsIgnoringCase(text.substr(0, 3), "inf");
}

} // namespace

std::string_view trimmed(std::string_view text)
{
    const auto first = std::min(text.find_first_not_of(blanks), text.size());
    text.remove_prefix(first);
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

bool equalsIgnoringCase(std::string_view a, std::string_view b)
{
    return std::ranges::equal(a, b, {}, lower, lower);
}

bool isNameCharacter(char c)
{
    return isLetter(c) || isDigit(c) || c == '-' || c == '_'
           || (static_cast<unsigned char>(c) & 0x80);
}

std::string_view takeWord(std::string_view& text, std::string_view separators)
{
    text.remove_prefix(std::min(text.find_first_not_of(separators), text.size()));
    int depth = 0;
    std::size_t end = 0;
    for (; end < text.size() && (depth > 0 || separators.find(text[end]) == separators.npos); ++end)
        depth += (text[end] == '(') - (text[end] == ')');
    const auto word = text.substr(0, end);
    text.remove_prefix(end);
    return word;
}

std::vector<std::string_view> wordsOf(std::string_view text)
{
    std::vector<std::string_view> words;
    for (auto word = takeWord(text, blanks); !word.empty(); word = takeWord(text, blanks))
        words.push_back(word);
    return words;
}

void Scanner::skipBlanks()
{
    rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
}

void Scanner::skipSeparator()
{
    skipBlanks();
    if (take(','))
        skipBlanks();
}

bool Scanner::take(char c)
{
    if (peek() != c || rest_.empty())
        return false;
    rest_.remove_prefix(1);
    return true;
}

std::string_view Scanner::word()
{
    const auto end = std::ranges::find_if_not(rest_, isLetter);
    const auto found = rest_.substr(0, std::size_t(end - rest_.begin()));
    rest_.remove_prefix(found.size());
    return found;
}

std::optional<double> Scanner::number()
{
    const char* first = rest_.data();
    const char* const last = first + rest_.size();
    const bool plus = peek() == '+';
    first += plus;
    const char* digit = first;
    if (!plus && digit != last && *digit == '-')
        ++digit;
    if (digit != last && *digit == '.')
        ++digit;
    if (digit == last || !isDigit(*digit)) {
        if (saysNotFinite(rest_))
            refuse(rest_);
        return std::nullopt;
    }
    double value = 0;
    const auto [end, error] = std::from_chars(first, last, value);
    if (error == std::errc::result_out_of_range) {
        if (!vanishes({first, std::size_t(end - first)}))
            refuse(rest_);
        value = 0;
    }
    if (!(std::abs(value) <= largestCoordinate))
        refuse(rest_);
    rest_.remove_prefix(std::size_t(end - rest_.data()));
    return value;
}

std::optional<bool> Scanner::flag()
{
    if (take('0'))
        return false;
    if (take('1'))
        return true;
    return std::nullopt;
}

} // namespace app::svg
