// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/fresh_ids.h"

namespace app {

QSet<QString> idsOf(const Document& document)
{
    QSet<QString> ids;
    document.objects().forEach(
        0, document.objects().size(),
        [&](std::size_t, const ObjectView& object) { ids.insert(object.particulars().id); });
    for (const ContainerId each : document.containers().inOrder())
        ids.insert(document.containers()[each].svgId);
    ids.remove(QString());
    return ids;
}

QString FreshIds::next(const QString& id)
{
    if (id.isEmpty())
        return {};
    if (!taken_)
        taken_ = idsOf(*document_);
    for (int number = 2;; ++number)
        if (const QString fresh = QStringLiteral("%1-%2").arg(id).arg(number);
            !taken_->contains(fresh)) {
            taken_->insert(fresh);
            return fresh;
        }
}

std::pair<Containers, ContainerId> withLayerAbove(const Document& document, const QString& name)
{
    const Containers& tree = document.containers();
    const auto layers = tree.childrenOf(0);
    const std::size_t end = document.objects().size();
    Container layer;
    layer.name = name;
    if (layers.size() < Containers::mostLayers)
        if (auto with = tree.inserted(layer, 0, layers.size(), {end, end}))
            return {std::move(*with), tree.nextId()};
    return {tree, layers.back()};
}

} // namespace app
