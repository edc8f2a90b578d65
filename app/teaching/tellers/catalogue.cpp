// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/teller.h"

namespace app {

// Each is defined in the file of its algorithm.
extern const Teller matthesDrakopoulosTeller;

// THE CATALOGUE. An algorithm without a row is told in general words.
std::span<const Teller> tellers()
{
    static const std::array rows{
        matthesDrakopoulosTeller,
    };
    return rows;
}

} // namespace app
