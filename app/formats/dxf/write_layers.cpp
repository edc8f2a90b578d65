// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/write_layers.h"

#include "app/formats/dxf/write_text.h"

namespace app::dxf::writing {

DxfLayers::DxfLayers(const Document& document, DxfVersion version) : document_(document)
{
    addLayers(version);
    addLooks();
}

void DxfLayers::addLayers(DxfVersion version)
{
    const Containers& tree = document_.containers();
    const QString ofEveryFile = QStringLiteral("0");
    LayerNames names(version);
    names.legal(ofEveryFile);
    bool isTaken = false; // by a layer of the drawing
    places_.resize(tree.nextId());
    for (const ContainerId id : tree.inOrder()) {
        const Container& container = tree[id];
        if (container.kind == Container::Kind::Group) {
            const Place& around = places_[tree.parentOf(id)];
            places_[id] = {around.entry, around.hidden || !container.visible};
            continue;
        }
        LayerEntry entry{"0", {}, tree.shown(id), tree.locked(id)};
        if (container.name == ofEveryFile && !isTaken) {
            isTaken = true;
            entries_.front() = std::move(entry);
            continue; // at place 0
        }
        entry.name = names.legal(container.name);
        places_[id].entry = entries_.size();
        entries_.push_back(std::move(entry));
    }
}

void DxfLayers::addLooks()
{
    const double millimetres = document_.page().millimetresPerUnit();
    const Objects& objects = document_.objects();
    std::vector<bool> known(entries_.size());
    objects.forEach(0, objects.size(), [&](std::size_t i, const ObjectView& object) {
        const std::size_t entry = placeOf(i).entry;
        const auto look = known[entry] ? std::nullopt : lookOf(object, millimetres);
        if (!look)
            return;
        entries_[entry].look = *look;
        known[entry] = true;
    });
}

DxfLayers::Place DxfLayers::placeOf(std::size_t object) const
{
    return places_[document_.containers().containerOf(object)];
}

} // namespace app::dxf::writing
