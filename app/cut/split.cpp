// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/split.h"

#include "app/base/progress.h"
#include "app/base/text.h"
#include "app/cut/fresh_ids.h"
#include "app/cut/outside_layers.h"

namespace app {
namespace {

Cut cutKeeping(const Document& document, CutOptions options, Keep keep, const Follower& follower)
{
    options.region = withKeep(options.region, keep);
    options.leaveImages = true;
    return cut(document, options, follower);
}

ObjectRanges changedBy(const Cut& cut)
{
    ObjectRanges changed;
    for (const Splice& splice : cut.edit.splices)
        changed.insert(ObjectRange{splice.first, std::size_t(splice.first) + splice.removed});
    return changed;
}

// Of the parts outside the windows, those of objects that the inner cut changes; no other object
// has a part there. Their ids differ from those inside.
Document outsideParts(const Document& document, const Cut& outer, const Cut& inside)
{
    Document inner = document, all = document;
    inner.apply(inside.edit);
    all.apply(outer.edit);
    const QSet<QString> insideIds = idsOf(inner);
    FreshIds ids(idsOf(document) + insideIds + idsOf(all));
    const ObjectRanges changed = changedBy(inside);
    DocumentParts parts{.page = all.page(), .objects = all.objects().slice(0, 0)};
    std::vector<Splice> others;
    std::uint32_t number = 0;
    for (const std::uint32_t source : sourcesOf(outer, document.objects().size())) {
        if (!changed.contains(source)) {
            others.push_back({number++, 1, 0});
            continue;
        }
        ObjectRow row = all.objects()[number++].row();
        if (insideIds.contains(row.particulars->id))
            row.particulars.own().id = ids.next(document.objects()[source].particulars().id);
        parts.objects.append(row);
    }
    parts.containers = all.containers().spliced(others);
    return Document(std::move(parts));
}

// All that is outside on one layer.
Edit withOneLayer(const Document& document, Edit inside, const Document& outside)
{
    Document inner = document;
    inner.apply(inside);
    const auto [tree, layer] = withLayerAbove(inner, Text::tr("Outside"));
    inside.splices.push_back(
        {std::uint32_t(document.objects().size()), 0, std::uint32_t(outside.objects().size())});
    inside.objects.append(outside.objects());
    inside.containers = tree.spliced(inner.objects().size(), 0, outside.objects().size(), layer);
    return inside;
}

} // namespace

Cut split(const Document& document, const CutOptions& options, const Follower& follower)
{
    PhasedProgress phases(follower, {1, 1});
    Cut result = cutKeeping(document, options, Keep::Inside, phases.next());
    const Cut outer = cutKeeping(document, options, Keep::Outside, phases.next());
    if (follower.stop.stop_requested())
        return {};
    const Document outside = outsideParts(document, outer, result);
    if (outside.objects().empty())
        return result;
    result.counts.whole += result.counts.gone;
    result.counts.gone = 0;
    auto edit = withOutsideLayers(document, result.edit, outside);
    result.edit = edit ? std::move(*edit) : withOneLayer(document, result.edit, outside);
    return result;
}

} // namespace app
