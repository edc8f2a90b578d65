// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/teller.h"

namespace app {

// Each is defined in the file of its algorithm.
extern const Teller cohenSutherlandTeller;
extern const Teller liangBarskyTeller;
extern const Teller cyrusBeckTeller;
extern const Teller nichollLeeNichollTeller;
extern const Teller skalaTeller;
extern const Teller kodituwakkuWijeweeraChamikaraTeller;
extern const Teller matthesDrakopoulosTeller;
extern const Teller midpointSubdivisionTeller;
extern const Teller sobkowPospisilYangTeller;
extern const Teller slaterBarskyTeller;
extern const Teller exactTeller;

// THE CATALOGUE. An algorithm without a row is told in general words.
std::span<const Teller> tellers()
{
    static const std::array rows{
        cohenSutherlandTeller,
        liangBarskyTeller,
        cyrusBeckTeller,
        nichollLeeNichollTeller,
        skalaTeller,
        kodituwakkuWijeweeraChamikaraTeller,
        matthesDrakopoulosTeller,
        midpointSubdivisionTeller,
        sobkowPospisilYangTeller,
        slaterBarskyTeller,
        exactTeller,
    };
    return rows;
}

} // namespace app
