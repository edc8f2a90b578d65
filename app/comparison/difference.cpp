// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/difference.h"

#include "app/base/numbers.h"
#include "app/base/text.h"

#include <QStringList>

namespace app {

using clipping::Clipped;
using clipping::Segment;
using clipping::Window;
using Kind = Difference::Kind;

std::vector<Difference> differences(std::span<const Segment> lines, const Window& window,
                                    std::span<const Clipped> a, std::span<const Clipped> b,
                                    const Allowance& allowed)
{
    std::vector<Difference> found;
    const auto alone = [&](const Clipped& piece, Kind kind) {
        found.push_back(
            {piece.source, kind, extentOf(piece.segment) / ulpFor(lines[piece.source], window)});
    };
    auto other = b.begin();
    for (const Clipped& piece : a) {
        while (other != b.end() && other->source < piece.source)
            alone(*other++, Kind::OnlyB);
        if (other == b.end() || other->source != piece.source) {
            alone(piece, Kind::OnlyA);
            continue;
        }
        // Most pieces are equal, and then there is nothing to measure.
        if (piece.segment != other->segment) {
            const double ulps = endsApart(piece.segment, other->segment, allowed.ends)
                                / ulpFor(lines[piece.source], window);
            if (!(ulps <= allowed.ulps))
                found.push_back({piece.source, Kind::EndsApart, ulps});
        }
        ++other;
    }
    while (other != b.end())
        alone(*other++, Kind::OnlyB);
    return found;
}

std::vector<Difference> differences(std::span<const Segment> lines, const Window& window,
                                    const Variant& a, const Variant& b, double ulpsAllowed)
{
    return differences(lines, window, clipped(a, lines, window), clipped(b, lines, window),
                       {ulpsAllowed, endsOf(a, b)});
}

DifferenceCounts counted(std::span<const Difference> differences)
{
    DifferenceCounts counts;
    for (const Difference& difference : differences)
        ++(difference.kind == Kind::OnlyA   ? counts.onlyA
           : difference.kind == Kind::OnlyB ? counts.onlyB
                                            : counts.endsApart);
    return counts;
}

QString sentence(const Variant& a, const Variant& b, const DifferenceCounts& counts,
                 std::size_t lines)
{
    if (a == b)
        return Text::tr("A and B are the same: choose two different ones");
    if (lines == 0)
        return Text::tr("There are no lines to compare");
    if (counts.all() == 0)
        return lines == 1 ? Text::tr("They agree on the only line here")
                          : Text::tr("They agree on all %1 lines here").arg(countText(lines));
    // The judged variant comes first: never `exact`.
    if (a == exactVariant())
        return sentence(b, a, {counts.onlyB, counts.onlyA, counts.endsApart}, lines);
    const QString other = nameOf(b);
    QStringList faults;
    const auto add = [&](std::size_t count, const QString& one, const QString& many) {
        if (count != 0)
            faults << (count == 1 ? one.arg(other) : many.arg(countText(count), other));
    };
    add(counts.onlyB, Text::tr("loses 1 line that %1 keeps"),
        Text::tr("loses %1 lines that %2 keeps"));
    add(counts.onlyA, Text::tr("keeps 1 line that %1 drops"),
        Text::tr("keeps %1 lines that %2 drops"));
    add(counts.endsApart, Text::tr("places the ends of 1 line differently from %1"),
        Text::tr("places the ends of %1 lines differently from %2"));
    const QString last = faults.takeLast();
    const QString all = faults.isEmpty() ? last
                                         : Text::tr("%1 and %2", "what it does, and what else")
                                               .arg(faults.join(Text::tr(", ")), last);
    return Text::tr("%1 %2", "who, and what it does").arg(nameOf(a), all);
}

} // namespace app
