// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmarks/clip/report.h"

#include <cstdio>
#include <string>

namespace {

void printHead(const char* first, std::span<const Race> races)
{
    std::printf("\n| %s |", first);
    for (const Race& race : races)
        std::printf(" %s |", race.scene.c_str());
    std::printf("\n|---|");
    for (std::size_t i = 0; i < races.size(); ++i)
        std::printf("---|");
    std::printf("\n");
}

std::vector<std::string> contendersOf(std::span<const Race> races)
{
    std::vector<std::string> names;
    for (const Race& race : races)
        for (const Contender& who : race.contenders)
            if (std::ranges::find(names, who.name) == names.end())
                names.push_back(who.name);
    return names;
}

double share(std::size_t part, std::size_t whole)
{
    return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string text(const Agreement& a)
{
    char seen[64] = "", outside[32] = "", difference[16] = "same";
    if (a.onlyPeer + a.onlyExact > 0)
        std::snprintf(seen, sizeof seen, "+%zu -%zu, ", a.onlyPeer, a.onlyExact);
    if (a.outside > 0)
        std::snprintf(outside, sizeof outside, "%zu out, ", a.outside);
    if (a.largest > 0)
        std::snprintf(difference, sizeof difference, "%.1g", a.largest);
    return std::string(seen) + outside + difference;
}

} // namespace

void printTimes(std::span<const Race> races)
{
    printHead("ns a segment (speed of plain read)", races);
    for (const std::string& name : contendersOf(races)) {
        std::printf("| %s |", name.c_str());
        for (const Race& race : races)
            if (const Contender* who = race.find(name))
                std::printf(" %.2f (%.2f) |",
                            median(who->seconds) * 1e9 / static_cast<double>(race.count),
                            ratio(*race.find("plain read"), *who).middle);
            else
                std::printf(" |");
        std::printf("\n");
    }
}

void printFallbacks(std::span<const Race> races)
{
    printHead("%", races);
    std::printf("| visible |");
    for (const Race& race : races)
        std::printf(" %.2f |", share(race.visible, race.count));
    std::printf("\n| left to the scalar algorithm |");
    for (const Race& race : races)
        std::printf(" %.5f |", share(race.unsettled, race.count));
    std::printf("\n");
}

void printAgreements(std::span<const Race> races)
{
    printHead("against `exact` on the same numbers", races);
    for (const NamedAgreement& peer : races[0].agreements) {
        std::printf("| %s |", peer.name.c_str());
        for (const Race& race : races) {
            const auto found = std::ranges::find(race.agreements, peer.name, &NamedAgreement::name);
            std::printf(" %s |",
                        found == race.agreements.end() ? "" : text(found->agreement).c_str());
        }
        std::printf("\n");
    }
    std::printf("\n(*+a -b*: a are seen by it alone, b by `exact` alone; *c out*: so many pieces "
                "leave the window; then the largest difference of ends in the drawing's units; of "
                "%zu segments)\n",
                races[0].agreements.empty() ? 0 : races[0].agreements[0].agreement.compared);
}
