// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/pairs.h"

#include <charconv>

namespace app::dxf {

std::string_view withoutBlanks(std::string_view text)
{
    constexpr std::string_view blanks = " \t\r";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string_view::npos
               ? std::string_view()
               : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

static std::string_view withoutReturn(std::string_view text)
{
    return text.ends_with('\r') ? text.substr(0, text.size() - 1) : text;
}

// Parts of a long text end anywhere, also at a blank.
static bool isText(int code) { return code == 1 || code == 3; }

std::string_view Pairs::takeLine()
{
    const std::size_t end = rest_.find('\n');
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++lines_;
    return line;
}

bool Pairs::next(Pair& pair)
{
    constexpr int comment = 999;
    do {
        const std::string_view code = withoutBlanks(takeLine());
        line_ = lines_;
        if (rest_.empty()) { // an end without a value; a last empty line is no damage
            damaged_ = !code.empty();
            return false;
        }
        const char* const last = code.data() + code.size();
        const auto [end, error] = std::from_chars(code.data(), last, pair.code);
        damaged_ = error != std::errc{} || end != last;
        if (damaged_) {
            rest_ = {};
            return false;
        }
        pair.value = isText(pair.code) ? withoutReturn(takeLine()) : withoutBlanks(takeLine());
    } while (pair.code == comment);
    return true;
}

} // namespace app::dxf
