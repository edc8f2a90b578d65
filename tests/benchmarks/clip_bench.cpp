// SPDX-License-Identifier: GPL-3.0-or-later
//
// How fast `exact` clips many segments, beside plain reading and copying of the same bytes, beside
// the other rows and beside other libraries. Prints Markdown; peers.md keeps what it printed.
//   clip_bench                          everything, in about five minutes
//   clip_bench SCENE MILLIONS [ROUNDS]  one scene (or "all")
//   clip_bench few                      from 1 to 100 segments a call
//   clip_bench check                    little data; fails where results differ
#include <cstdio>
#include <cstdlib>
#include <iterator>

#include "tests/benchmarks/clip/contenders.h"
#include "tests/benchmarks/clip/few.h"
#include "tests/benchmarks/clip/machine.h"
#include "tests/benchmarks/clip/map_scene.h"
#include "tests/benchmarks/clip/report.h"
#include "tests/benchmarks/clip/targets.h"

namespace {

/// What is raced. With much data, of the scalar rows only Matthes-Drakopoulos runs, and of the
/// peers, on the paper's scene, those that do not allocate every segment.
struct Plan {
    std::string scene; ///< or "all"
    std::size_t count;
    int rounds;
    static constexpr std::size_t many = 1'000'000, bytesOfAPeer = 1'000'000'000;

    bool admits(const Peer& peer, const std::string& raced) const
    {
        return (count <= many || raced == "paper") && count * peer.bytes <= bytesOfAPeer;
    }
    bool admits(const Contender& scalar) const
    {
        return count <= many || scalar.name == "Matthes-Drakopoulos";
    }
};

/// The peers' data live as long as the race.
struct PeerInRace {
    const Peer* peer;
    std::unique_ptr<PeerData> data;
};
using PeerField = std::vector<PeerInRace>;

template <class T>
PeerField peersOf(const Data<T>& data, const Plan& plan)
{
    PeerField field;
    const auto segments = data.doubles();
    for (const PeerLibrary& library : peerLibraries())
        if (library.peers)
            for (const Peer& peer : library.peers())
                if (plan.admits(peer, data.scene.name)
                    && (sizeof(T) == sizeof(double) || peer.numbers != "double"))
                    field.push_back({&peer, peer.prepare(segments, data.doubleWindow())});
    return field;
}

void append(std::vector<Contender>& to, std::vector<Contender> more)
{
    std::ranges::move(more, std::back_inserter(to));
}

template <class T>
Race raced(Data<T>& data, const Plan& plan)
{
    const auto counts = clipWith(fastestSet(), data.batch(0, data.in().size()));
    Race result{data.scene.name, numbers<T>, data.in().size(), counts.pieces, counts.unsettled};
    const PeerField peers = peersOf(data, plan);
    auto& all = result.contenders;
    append(all, memoryContenders(data));
    append(all, exactContenders(data));
    for (Contender& scalar : scalarContenders(data))
        if (plan.admits(scalar))
            all.push_back(std::move(scalar));
    for (const auto& [peer, theirs] : peers) {
        const std::string name(peer->name);
        result.agreements.push_back(
            {name, agreementOf(*theirs, data.doubleWindow(), Plan::many), peer->endsWithin});
        all.push_back({name, [p = theirs.get()] { return p->clipAll(); }});
    }
#ifdef WITH_THREADS
    append(all, threadContenders(data));
#endif
    race(all, plan.rounds);
    for (Contender& who : all)
        who.run = {}; // its data go now
    return result;
}

template <class T>
std::vector<Race> racesOf(const Plan& plan)
{
    std::vector<Race> races;
    for (const auto& maker : scenesWithMap<T>())
        if (plan.scene == "all" || plan.scene == maker.name) {
            Data<T> data(maker.make(plan.count));
            if (!data.in().empty())
                races.push_back(raced(data, plan));
        }
    return races;
}

/// Prints all tables but the targets, which need more than one plan.
std::vector<Race> printed(std::vector<Race> races)
{
    if (races.empty())
        return races;
    std::printf("\n## %zu segments, %s\n", races[0].count, races[0].numbers.c_str());
    printTimes(races);
    printFallbacks(races);
    printAgreements(races);
    std::fflush(stdout);
    return races;
}

/// Names whoever claims to be `exact` and counts otherwise, and peers that are off too far.
bool agrees(std::span<const Race> races)
{
    std::vector<std::string> wrong;
    for (const Race& race : races) {
        const std::string where = ", " + race.scene + ", " + race.numbers;
        for (const Contender& who : race.contenders)
            if (who.name.starts_with("exact") && who.answer != race.visible)
                wrong.push_back(who.name + where);
        for (const NamedAgreement& peer : race.agreements)
            if (!peer.plausible())
                wrong.push_back(peer.name + where);
    }
    for (const std::string& who : wrong)
        std::printf("\nDISAGREES: %s\n", who.c_str());
    return wrong.empty();
}

bool run(std::span<const Plan> plans)
{
    std::vector<Race> all;
    for (const Plan& plan : plans) {
        for (auto& races : {printed(racesOf<double>(plan)), printed(racesOf<float>(plan))})
            all.insert(all.end(), races.begin(), races.end());
    }
    std::printf("\n## Targets\n");
    printTargets(all);
    printScalars(all);
    return agrees(all);
}

} // namespace

int main(int argc, char** argv)
{
    printMachine();
    std::printf("- map: %s\n", realMap().source.c_str());
    const std::string scene = argc > 1 ? argv[1] : "";
    if (scene == "few")
        return printFew(9) ? EXIT_SUCCESS : EXIT_FAILURE;
    if (scene == "check" && !printFew(1))
        return EXIT_FAILURE;
    std::vector<Plan> plans{{"all", 1'000'000, 5}, {"all", 10'000'000, 5}};
    if (scene == "check")
        plans = {{"all", 20'000, 1}};
    else if (!scene.empty()) {
        const double millions = argc > 2 ? std::atof(argv[2]) : 1;
        plans = {
            {scene, static_cast<std::size_t>(millions * 1e6), argc > 3 ? std::atoi(argv[3]) : 9}};
    }
    return run(plans) ? EXIT_SUCCESS : EXIT_FAILURE;
}
