// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/formulas/cursor.h"

#include "app/teaching/formulas/expression.h"

namespace app::formulas {

bool Cursor::sees(std::string_view text, std::size_t further) const
{
    return at_ + further < tokens_.size() && tokens_[at_ + further].text == text;
}

bool Cursor::takes(std::string_view text)
{
    const bool seen = sees(text);
    at_ += seen ? 1 : 0;
    return seen;
}

void Cursor::expect(std::string_view text)
{
    if (!takes(text))
        fail("'" + std::string(text) + "'");
}

void Cursor::fail(const std::string& wanted) const
{
    throw Unreadable(atEnd() ? wanted + " is missing at the end"
                             : wanted + " is missing before '" + std::string(tokens_[at_].text)
                                   + "' at column " + std::to_string(tokens_[at_].at + 1));
}

std::string Cursor::word()
{
    if (atEnd() || !isWord(tokens_[at_]))
        fail("A name");
    return std::string(tokens_[at_++].text);
}

std::vector<std::string> Cursor::rest()
{
    std::vector<std::string> words;
    for (; !atEnd(); ++at_)
        words.emplace_back(tokens_[at_].text);
    return words;
}

} // namespace app::formulas
