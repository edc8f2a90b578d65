// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/teaching.h"

#include <algorithm>

namespace app {

// Each is defined in the file of its algorithm.
extern const Teaching cohenSutherlandTeaching;
extern const Teaching liangBarskyTeaching;
extern const Teaching cyrusBeckTeaching;
extern const Teaching nichollLeeNichollTeaching;
extern const Teaching skalaTeaching;
extern const Teaching kodituwakkuWijeweeraChamikaraTeaching;
extern const Teaching matthesDrakopoulosTeaching;
extern const Teaching midpointSubdivisionTeaching;
extern const Teaching sobkowPospisilYangTeaching;
extern const Teaching slaterBarskyTeaching;
extern const Teaching exactTeaching;

// THE CATALOGUE. An algorithm without a row uses the defaults.
std::span<const Teaching> teachings()
{
    // clang-format off
    static const std::array rows{
        cohenSutherlandTeaching,
        liangBarskyTeaching,
        cyrusBeckTeaching,
        nichollLeeNichollTeaching,
        skalaTeaching,
        kodituwakkuWijeweeraChamikaraTeaching,
        matthesDrakopoulosTeaching,
        midpointSubdivisionTeaching,
        sobkowPospisilYangTeaching,
        slaterBarskyTeaching,
        exactTeaching,
    };
    // clang-format on
    return rows;
}

Teaching teachingOf(const clipping::Algorithm& algorithm)
{
    const auto rows = teachings();
    const auto row = std::ranges::find(rows, algorithm.key, &Teaching::key);
    return row == rows.end() ? Teaching{.key = algorithm.key} : *row;
}

QString sentenceOf(const Teaching& teaching, const SentenceContext& context)
{
    const QString own = teaching.sentence(context);
    return own.isEmpty() ? generalSentence(context) : own;
}

} // namespace app
