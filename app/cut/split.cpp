// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/split.h"

#include "app/cut/fresh_ids.h"
#include "app/cut/layer_above.h"

#include <QCoreApplication>

namespace app {
namespace {

Cut cutKeeping(const Document& document, CutOptions options, Keep keep)
{
    options.region = withKeep(options.region, keep);
    return cut(document, options);
}

// What is outside the windows, of the objects that the inner cut changes; no other has a part
// there.
Objects outsideParts(const Document& document, const Cut& inside, const Cut& outside)
{
    Objects parts = document.objects().slice(0, 0);
    FreshIds ids(document);
    std::size_t next = 0, added = 0; // of the outer cut's splices and objects
    const auto& splices = outside.edit.splices;
    for (const Splice& removed : inside.edit.splices) {
        for (std::size_t i = removed.first; i < removed.first + removed.removed; ++i) {
            while (next < splices.size() && splices[next].first + splices[next].removed <= i)
                added += splices[next++].added;
            if (next == splices.size() || splices[next].first > i) {
                parts.append(document.objects()[i].copy()); // wholly outside
                continue;
            }
            for (std::size_t k = 0; k < splices[next].added; ++k) {
                Object part = outside.edit.objects[added + k].copy();
                part.particulars.id = ids.next(document.objects()[i].particulars().id);
                parts.append(part);
            }
        }
    }
    return parts;
}

} // namespace

Cut split(const Document& document, const CutOptions& options)
{
    Cut result = cutKeeping(document, options, Keep::Inside);
    const Cut outside = cutKeeping(document, options, Keep::Outside);
    const Objects parts = outsideParts(document, result, outside);
    result.counts.whole += result.counts.gone;
    result.counts.gone = 0;
    if (parts.size() == 0)
        return result;
    auto [tree, layer] =
        withLayerAbove(document, QCoreApplication::translate("PermanentCuts", "Outside"));
    std::vector<ContainerId> into;
    for (const Splice& splice : result.edit.splices)
        into.push_back(tree.containerOf(splice.first));
    const auto end = std::uint32_t(document.objects().size());
    result.edit.splices.push_back({end, 0, std::uint32_t(parts.size())});
    into.push_back(layer);
    result.edit.objects.append(parts);
    result.edit.containers = tree.spliced(result.edit.splices, into);
    return result;
}

} // namespace app
