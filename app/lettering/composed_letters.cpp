// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/composed_letters.h"

#include <algorithm>
#include <array>

namespace app {
namespace {

constexpr double small = 0.6, raised = 21 * (1 - small); // to the height of capitals

ComposedLetter power(char32_t character, char32_t digit)
{
    return {character, {{digit, small, raised}}};
}

ComposedLetter fraction(char32_t character, char32_t above, char32_t below)
{
    return {character, {{above, small, raised}, {U'/', 1, 0, 6}, {below, small, 0, 6}}};
}

} // namespace

const ComposedLetter* findComposed(char32_t character)
{
    // THE CATALOGUE: signs of plans and tables, and letters of Europe, that the Hershey fonts lack.
    static const std::array all{
        ComposedLetter{U'±', {{U'+'}}, {{{-9, 4}, {9, 4}}}},
        power(U'¹', U'1'),
        power(U'²', U'2'),
        power(U'³', U'3'),
        fraction(U'½', U'1', U'2'),
        fraction(U'¼', U'1', U'4'),
        fraction(U'¾', U'3', U'4'),
        ComposedLetter{U'Ø', {{U'O'}}, {{{-9, 2}, {9, -23}}}},
        ComposedLetter{U'ø', {{U'o'}}, {{{-7, 2}, {7, -16}}}},
        ComposedLetter{U'⌀', {{U'O'}}, {{{-9, 2}, {9, -23}}}},
        ComposedLetter{U'∅', {{U'O'}}, {{{-9, 2}, {9, -23}}}},
        ComposedLetter{U'Æ', {{U'A'}, {U'E', 1, 0, 9}}},
        ComposedLetter{U'æ', {{U'a'}, {U'e', 1, 0, 4}}},
        ComposedLetter{U'Œ', {{U'O'}, {U'E', 1, 0, 7}}},
        ComposedLetter{U'œ', {{U'o'}, {U'e', 1, 0, 4}}},
        ComposedLetter{U'ß', {{U'β'}}},
        ComposedLetter{U'Ł', {{U'L'}}, {{{-9, -7}, {1, -13}}}},
        ComposedLetter{U'ł', {{U'l'}}, {{{-4, -8}, {4, -13}}}},
        ComposedLetter{U'Đ', {{U'D'}}, {{{-10, -10}, {1, -10}}}},
        ComposedLetter{U'đ', {{U'd'}}, {{{0, -17}, {9, -17}}}},
        ComposedLetter{U'…', {{U'.'}, {U'.'}, {U'.'}}},
        ComposedLetter{U'€', {{U'C'}}, {{{-12, -13}, {3, -13}}, {{-12, -8}, {3, -8}}}},
        ComposedLetter{U'£', {{U'L'}}, {{{-10, -10}, {2, -10}}}},
        ComposedLetter{U'§', {{U'S', 0.7, 7}, {U'S', 0.7, -1, 14}}},
        ComposedLetter{U'©', {{U'O'}, {U'C', 0.45, 6, 16}}},
        ComposedLetter{U'®', {{U'O'}, {U'R', 0.45, 6, 16}}},
        ComposedLetter{U'≤', {{U'<'}}, {{{-8, 4}, {8, 4}}}},
        ComposedLetter{U'≥', {{U'>'}}, {{{-8, 4}, {8, 4}}}},
        ComposedLetter{U'≠', {{U'='}}, {{{-5, 1}, {5, -19}}}},
        ComposedLetter{U'≈', {{U'~', 1, 3}, {U'~', 1, -3, 24}}},
        ComposedLetter{U'√', {{U'/'}}, {{{-9, -9}, {-6, -10}, {-9, 6}}, {{9, -25}, {17, -25}}}},
    };
    const auto found = std::ranges::find(all, character, &ComposedLetter::character);
    return found == all.end() ? nullptr : &*found;
}

} // namespace app
