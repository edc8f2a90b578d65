// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/child_race.h"

#include "app/base/progress.h"
#include "app/base/text.h"
#include "app/experiment/class_profile.h"
#include "app/judge/race_check.h"
#include "app/judge/times.h"

#include <unistd.h>

namespace app::plug_in {
namespace {

using clipping::Clipped;
using clipping::Segment;
using clipping::Window;

/// Each row needs a `clipAll` of its own that calls line by line; there are at most this many.
constexpr std::size_t mostRows = 32;

Clip own;                   ///< global, because a function pointer has no context
RaceCheck* check = nullptr; ///< for the same reason

std::optional<Segment> clipOwn(const Segment& line, const Window& window)
{
    Segment piece;
    return own(&line.a.x, &window.min.x, &piece.a.x) != 0 ? std::optional(piece) : std::nullopt;
}

template <class One>
std::size_t oneByOne(std::span<const Segment> in, const Window& window, std::span<Clipped> out,
                     One clip)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < in.size(); ++i)
        if (const auto piece = clip(in[i], window))
            out[count++] = {*piece, std::uint32_t(i), 0};
    return count;
}

std::size_t clipAllOwn(std::span<const Segment> in, const Window& window, std::span<Clipped> out)
{
    const std::size_t count = oneByOne(in, window, out, &clipOwn);
    check->turn(in, window, out.first(count));
    return count;
}

template <std::size_t row>
std::size_t clipAllOf(std::span<const Segment> in, const Window& window, std::span<Clipped> out)
{
    return oneByOne(in, window, out, clipping::algorithms()[row].corrected.clip);
}

/// The library first, then the algorithms of the catalogue.
template <std::size_t... row>
std::vector<clipping::Algorithm> contenders(std::index_sequence<row...>)
{
    constexpr std::array calls{&clipAllOf<row>...};
    const auto rows = clipping::algorithms();
    std::vector<clipping::Algorithm> all{rows.front()};
    all.insert(all.end(), rows.begin(), rows.end());
    for (std::size_t i = 0; i < rows.size() && i < calls.size(); ++i)
        all[i + 1].corrected.clipAll = calls[i];
    all.front().key = ownKey;
    all.front().corrected = {&clipOwn, &clipAllOwn, nullptr, nullptr};
    return all;
}

void tell(int out, const QByteArray& line)
{
    const QByteArray whole = line + '\n';
    for (qsizetype at = 0; at < whole.size();) {
        const auto wrote = ::write(out, whole.constData() + at, std::size_t(whole.size() - at));
        if (wrote <= 0)
            return;
        at += wrote;
    }
}

Contender contender(const Timing& timing, std::size_t i, const ClassProfile& profile)
{
    Contender one{latin(timing.variant.algorithm->key), timing.clip, {}, timing.found};
    for (std::size_t c = 0; c < profile.classes.size(); ++c)
        if (const Record& record = profile.classes[c].record; !record.timings.empty())
            one.byClass[c] = summaryOf(record.timings[i].clip).median;
    return one;
}

Times timesOfRecord(const Record& record, const ClassProfile& profile)
{
    Times times{{}, {}, factsOf(record)};
    for (std::size_t i = 0; i < record.timings.size(); ++i)
        times.contenders.push_back(contender(record.timings[i], i, profile));
    for (std::size_t c = 0; c < profile.classes.size(); ++c)
        times.shares[c] = profile.classes[c].of.share;
    return times;
}

} // namespace

void race(int out, const Library& library, const QStringList& arguments)
{
    own = library.clip;
    static const auto rows = contenders(std::make_index_sequence<mostRows>());
    std::vector<Variant> variants;
    variants.reserve(rows.size());
    for (const clipping::Algorithm& row : rows)
        variants.push_back({&row, clipping::Form::Corrected});
    const Follower follower{
        {}, [out](const Progress& progress) { tell(out, QByteArray::number(progress.share)); }};
    ExperimentOptions options;
    options.lines = arguments.value(0).toULongLong();
    options.runs = arguments.value(1).toULongLong();
    options.seed = arguments.value(2).toULongLong();
    options.sameLines = true; // RaceCheck compares the runs
    RaceCheck checking({.strictness = strictnessOf(arguments.value(3))});
    check = &checking;
    options.clock = checking.clock();
    PhasedProgress phases(follower, {1, 2});
    const auto record = recorded(options, variants, phases.next());
    const auto profile = classProfile(options, variants, phases.next());
    if (!record || !profile)
        return;
    tell(out, jsonOf(checking.found()));
    tell(out, jsonOf(timesOfRecord(*record, *profile)));
}

} // namespace app::plug_in
