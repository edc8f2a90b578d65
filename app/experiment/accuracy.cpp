// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/accuracy.h"

#include "app/base/progress.h"
#include "app/base/text.h"
#include "app/comparison/variants.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using clipping::Clipped;
using clipping::Segment;
using clipping::Window;

constexpr std::uint64_t accuracyBlockSize = 100'000;

/// A NaN counts as outside.
bool isInside(const Segment& s, const Window& w)
{
    const auto inside = [&](const glm::dvec2& p) {
        return p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y;
    };
    return inside(s.a) && inside(s.b);
}

/// Adds one block and returns the number of lines whose errors were measured. `meanUlps` holds
/// their sum meanwhile.
std::uint64_t add(Accuracy& to, std::span<const Segment> lines, std::span<const Clipped> found,
                  std::span<const Clipped> exactPieces, const Window& window)
{
    const Variant& who = to.variant;
    const Ends ends = endsOf(exactVariant(), {.algorithm = who.algorithm, .form = who.form});
    std::uint64_t agreed = 0, measured = 0;
    auto next = exactPieces.begin();
    for (const Clipped& line : found) {
        to.outside += !isInside(line.segment, window);
        while (next != exactPieces.end() && next->source < line.source)
            ++next;
        if (next == exactPieces.end() || next->source != line.source)
            continue;
        ++agreed;
        const double ulps =
            endsApart(line.segment, next->segment, ends) / ulpFor(lines[line.source], window);
        if (!std::isfinite(ulps))
            continue; // it counts as outside
        ++measured;
        to.meanUlps += ulps;
        to.mostUlps = std::max(to.mostUlps, ulps);
    }
    to.visible += exactPieces.size();
    to.lost += exactPieces.size() - agreed;
    to.shown += found.size() - agreed;
    return measured;
}

void clipInto(std::vector<Clipped>& out, const Variant& variant, std::span<const Segment> lines,
              const Window& window)
{
    out.resize(lines.size());
    out.resize(
        clipping::functionsOf(*variant.algorithm, variant.form)->clipAll(lines, window, out));
}

QStringList accuracyRow(const Accuracy& row)
{
    return {QString::fromUtf8(row.variant.algorithm->key),
            wordOf(row.variant.form),
            QString::number(row.visible),
            QString::number(row.lost),
            QString::number(row.shown),
            QString::number(row.outside),
            QString::number(row.meanUlps, 'g', 3),
            QString::number(row.mostUlps, 'g', 3)};
}

} // namespace

std::optional<std::vector<Accuracy>> accuracies(const ExperimentOptions& options,
                                                std::span<const Variant> variants,
                                                const Follower& follower)
{
    std::vector<Accuracy> all;
    for (const Variant& variant : variants)
        all.push_back({.variant = variant});
    const Variant exact{&clipping::exactAlgorithm(), clipping::Form::Corrected};
    const LineSource source = options.scene.begin(options.field, options.seed);
    const Window& window = options.field.window;
    const std::uint64_t blocks = (options.lines + accuracyBlockSize - 1) / accuracyBlockSize;
    TurnProgress turns(follower, double(blocks));
    std::vector<std::uint64_t> measured(all.size());
    std::vector<Segment> lines;
    std::vector<Clipped> exactPieces, found;
    for (std::uint64_t done = 0; done < options.lines; done += lines.size()) {
        if (turns.stopped())
            return std::nullopt;
        lines.resize(std::min(accuracyBlockSize, options.lines - done));
        source(lines);
        clipInto(exactPieces, exact, lines, window);
        for (Accuracy& row : all) {
            if (turns.stopped())
                return std::nullopt;
            clipInto(found, row.variant, lines, window);
            measured[std::size_t(&row - all.data())] += add(row, lines, found, exactPieces, window);
        }
        turns.turnDone();
    }
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i].meanUlps /= double(std::max<std::uint64_t>(measured[i], 1));
    return all;
}

Table accuracyTable(std::span<const Accuracy> accuracies, const ExperimentOptions& options)
{
    Table table{
        .names = {"algorithm", "form", "visible", "lost", "shown", "outside", "mean_ulps",
                  "most_ulps"},
        .title = Text::tr("Accuracy against exact arithmetic"),
        .key = QStringLiteral("accuracy"),
        .facts = factsOf(options),
        .notes = {Text::tr(
            "Lost: visible lines that the algorithm drops. Shown: invisible lines that it keeps. "
            "Outside: lines with an end that it leaves outside the window. Ulps: how far ends are "
            "off, in units in the last place of the largest coordinate of line and window.")}};
    for (const Accuracy& row : accuracies)
        table.rows.push_back(accuracyRow(row));
    return table;
}

} // namespace app
