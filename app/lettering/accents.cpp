// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/accents.h"

#include <algorithm>
#include <array>

namespace app {

const Accent* findAccent(char32_t mark)
{
    // THE CATALOGUE: the Hershey fonts have no letters with accents.
    static const std::array accents{
        Accent{0x300, {{{-3, -2}, {1, 2}}}},                                     // grave
        Accent{0x301, {{{3, -2}, {-1, 2}}}},                                     // acute
        Accent{0x302, {{{-3, 2}, {0, -1}, {3, 2}}}},                             // circumflex
        Accent{0x303, {{{-4, 1}, {-3, -1}, {-1, -1}, {1, 1}, {3, 1}, {4, -1}}}}, // tilde
        Accent{0x304, {{{-3, 0}, {3, 0}}}},                                      // macron
        Accent{0x306, {{{-3, -1}, {-2, 1}, {2, 1}, {3, -1}}}},                   // breve
        Accent{0x308, {{{-3, -1}, {-3, 1}}, {{3, -1}, {3, 1}}}},                 // diaeresis
        Accent{0x30a, {{{0, -2}, {2, 0}, {0, 2}, {-2, 0}, {0, -2}}}},            // ring
        Accent{0x30b, {{{0, -2}, {-3, 2}}, {{4, -2}, {1, 2}}}},                  // two acutes
        Accent{0x30c, {{{-3, -1}, {0, 2}, {3, -1}}}},                            // caron
        Accent{0x327, {{{0, -2}, {2, 0}, {1, 2}, {-2, 2}}}, true},               // cedilla
        Accent{0x328, {{{2, -2}, {0, 0}, {1, 2}, {3, 2}}}, true},                // ogonek
        Accent{0x342, {{{-4, 1}, {-3, -1}, {-1, -1}, {1, 1}, {3, 1}, {4, -1}}}}, // perispomeni
    };
    const auto found = std::ranges::find(accents, mark, &Accent::mark);
    return found == accents.end() ? nullptr : &*found;
}

} // namespace app
