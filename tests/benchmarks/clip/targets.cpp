// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmarks/clip/targets.h"

#include <cstdio>
#include <optional>

#include "tests/benchmarks/clip/data.h"

namespace {

constexpr std::size_t million = 1'000'000;

/// The fastest of those that `counts` picks, or null.
template <class Counts>
const Contender* fastest(const Race& race, Counts counts)
{
    const Contender* best = nullptr;
    for (const Contender& who : race.contenders)
        if (counts(who.name) && (!best || median(who.seconds) < median(best->seconds)))
            best = &who;
    return best;
}

/// How many times as fast the second is.
std::optional<Ratio> quotient(const Contender* slow, const Contender* fast)
{
    return slow && fast ? std::optional(ratio(*slow, *fast)) : std::nullopt;
}
const Contender* exactOf(const Race& race) { return race.find(nameOf(fastestSet())); }

std::optional<Ratio> ofPlainRead(const Race& race)
{
    return quotient(race.find("plain read"), exactOf(race));
}
std::optional<Ratio> timesMatthesDrakopoulos(const Race& race)
{
    return quotient(race.find("Matthes-Drakopoulos"), exactOf(race));
}
std::optional<Ratio> timesOpenCv(const Race& race)
{
    return quotient(fastest(race, [](const auto& name) { return name.starts_with("OpenCV"); }),
                    exactOf(race));
}
std::optional<Ratio> chunksOfPlainRead(const Race& race)
{
    return quotient(race.find("plain read"), race.find("exact, chunk boxes"));
}

/// What clipping gains from two threads, divided by what plain reading gains, round by round.
std::optional<Ratio> threads(const Race& race)
{
    const Contender* const two = race.find("exact, 2 threads");
    if (!two)
        return {};
    auto gains = quotients(*exactOf(race), *two);
    const auto reading = quotients(*race.find("plain read"), *race.find("plain read, 2 threads"));
    for (std::size_t i = 0; i < gains.size(); ++i)
        gains[i] /= reading[i];
    return spread(gains);
}

struct Target {
    const char* what;
    std::optional<Ratio> (*measured)(const Race&);
    const char *scene, *numbers;
    std::size_t count;
    double least, aim;
};
constexpr Target targets[] = {
    {"speed of plain reading", ofPlainRead, "paper", "double", 10 * million, 0.40, 0.62},
    {"speed of plain reading", ofPlainRead, "paper", "float", 10 * million, 0.40, 0.62},
    {"times our scalar Matthes-Drakopoulos", timesMatthesDrakopoulos, "paper", "double",
     10 * million, 5, 7},
    {"times our scalar Matthes-Drakopoulos", timesMatthesDrakopoulos, "paper", "float",
     10 * million, 8, 15},
    {"times OpenCV's best `clipLine`", timesOpenCv, "paper", "double", million, 6, 9},
    {"times OpenCV's best `clipLine`", timesOpenCv, "paper", "float", million, 12, 20},
    {"two threads: their gain, of plain reading's", threads, "paper", "double", million, 0.85,
     0.95},
    {"two threads: their gain, of plain reading's", threads, "paper", "float", million, 0.85, 0.95},
    {"two threads: their gain, of plain reading's", threads, "paper", "double", 10 * million, 0.85,
     0.95},
    {"two threads: their gain, of plain reading's", threads, "paper", "float", 10 * million, 0.85,
     0.95},
    {"chunk boxes, times plain reading of all bytes", chunksOfPlainRead, "editor strokes", "double",
     million, 1, 4},
    {"chunk boxes, times plain reading of all bytes", chunksOfPlainRead, "editor strokes", "double",
     10 * million, 1, 4},
    {"chunk boxes, times plain reading of all bytes", chunksOfPlainRead, "editor strokes", "float",
     10 * million, 1, 4},
};

const Race* raceOf(std::span<const Race> races, const Target& target)
{
    const auto found = std::ranges::find_if(races, [&](const Race& race) {
        return race.scene == target.scene && race.numbers == target.numbers
               && race.count == target.count;
    });
    return found == races.end() ? nullptr : &*found;
}

const char* verdict(double measured, double least, double aim)
{
    return measured >= aim ? "**aim reached**" : measured >= least ? "met" : "**not met**";
}

} // namespace

void printTargets(std::span<const Race> races)
{
    std::printf("\n| `exact`, %s | scene | at least | aim | measured (middle half of the rounds) "
                "| |\n|---|---|---|---|---|---|\n",
                fastestSet().name.data());
    for (const Target& t : targets) {
        std::printf("| %s | %s, %zu M, %s | %.2f | %.2f |", t.what, t.scene, t.count / million,
                    t.numbers, t.least, t.aim);
        const Race* const race = raceOf(races, t);
        if (const auto r = race ? t.measured(*race) : std::nullopt)
            std::printf(" %.2f (%.2f-%.2f) | %s |\n", r->middle, r->low, r->high,
                        verdict(r->middle, t.least, t.aim));
        else
            std::printf(" not measured | |\n");
    }
}

void printScalars(std::span<const Race> races)
{
    std::printf("\n| scalar row | fastest peer with the same algorithm | times its speed (at least "
                "1.0, aim 1.2) | |\n|---|---|---|---|\n");
    const Target paper{"", nullptr, "paper", "double", million, 1, 1.2};
    const Race* const race = raceOf(races, paper);
    if (!race)
        return;
    for (const clipping::Algorithm& row : clipping::algorithms()) {
        const auto same = [&](const std::string& name) {
            for (const PeerLibrary& library : peerLibraries())
                if (library.peers)
                    for (const Peer& peer : library.peers())
                        if (peer.name == name && peer.algorithm == row.key)
                            return true;
            return false;
        };
        const Contender* const peer = fastest(*race, same);
        if (const auto r = quotient(peer, race->find(row.name)))
            std::printf("| %s | %s | %.2f (%.2f-%.2f) | %s |\n", row.name.data(),
                        peer->name.c_str(), r->middle, r->low, r->high, verdict(r->middle, 1, 1.2));
        else if (race->find(row.name))
            std::printf("| %s | none of them has it | | |\n", row.name.data());
    }
}
