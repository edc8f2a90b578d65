// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/outside_layers.h"

#include "app/base/text.h"
#include "app/cut/fresh_ids.h"

#include <unordered_map>

namespace app {
namespace {

using Marks = std::span<const ContainerMark>;

Document after(const Document& document, const Edit& edit)
{
    Document made = document;
    made.apply(edit);
    return made;
}

// The marks of each layer of the first level, from its opening to its closing one.
std::vector<Marks> layersOf(Marks marks)
{
    std::vector<Marks> layers;
    std::size_t first = 1; // after that of the document
    for (std::size_t i = 1; i + 1 < marks.size(); ++i)
        if (marks[i].closes && marks[i].id == marks[first].id) {
            layers.push_back(marks.subspan(first, i + 1 - first));
            first = i + 1;
        }
    return layers;
}

class OutsideLayers {
public:
    OutsideLayers(const Document& document, const Edit& inside, const Document& outside)
        : document_(document), inside_(inside), outside_(outside),
          insideIds_(idsOf(after(document, inside))),
          ids_(idsOf(document) + insideIds_ + idsOf(outside))
    {
        edit_.objects = document.objects().slice(0, 0);
    }

    std::optional<Edit> made()
    {
        const Containers& before = document_.containers();
        const Containers::Parts inner = inside_.containers.value_or(before).parts();
        const Containers::Parts outer = outside_.containers().parts();
        const auto insideLayers = layersOf(inner.marks), outsideLayers = layersOf(outer.marks);
        parts_ = {{inner.marks.front()}, inner.containers, inner.nextId};
        for (std::size_t i = 0; i < insideLayers.size(); ++i) {
            const ContainerId layer = insideLayers[i].front().id;
            parts_.marks.insert(parts_.marks.end(), insideLayers[i].begin(), insideLayers[i].end());
            mirror(outsideLayers[i]);
            addObjects(before.rangeOf(layer).end, outside_.containers().rangeOf(layer));
        }
        parts_.marks.push_back(inner.marks.back());
        edit_.containers = Containers::of(parts_);
        if (!edit_.containers || edit_.containers->childrenOf(0).size() > Containers::mostLayers)
            return std::nullopt;
        return std::move(edit_);
    }

private:
    // Containers without objects are left out.
    void mirror(Marks layer)
    {
        for (const ContainerMark& mark : layer) {
            if (outside_.containers().rangeOf(mark.id).empty())
                parts_.marks.back().objects += mark.objects;
            else
                parts_.marks.push_back({idOf(mark.id), mark.closes, mark.objects});
        }
    }

    ContainerId idOf(ContainerId id)
    {
        const auto [at, isNew] = made_.try_emplace(id, parts_.nextId);
        if (isNew) {
            Container container = outside_.containers()[id];
            container.id = parts_.nextId++;
            container.underlay = {}; // it stays below what is inside
            if (container.kind == Container::Kind::Layer)
                container.name = Text::tr("%1, outside").arg(container.name);
            if (insideIds_.contains(container.svgId))
                container.svgId = ids_.next(container.svgId);
            parts_.containers.push_back(std::move(container));
        }
        return at->second;
    }

    // The objects inside up to `end`, in the old numbering; then those outside.
    void addObjects(std::size_t end, const ObjectRange& objects)
    {
        addInside(end);
        if (objects.empty())
            return;
        edit_.splices.push_back({std::uint32_t(end), 0, std::uint32_t(objects.size())});
        edit_.objects.append(outside_.objects().slice(objects.first, objects.size()));
    }

    void addInside(std::size_t end)
    {
        for (; next_ < inside_.splices.size(); ++next_) {
            Splice splice = inside_.splices[next_];
            splice.removed -= taken_;
            splice.first += taken_;
            if (splice.first >= end)
                return;
            if (splice.first + splice.removed > end) { // removed objects of several layers
                edit_.splices.push_back({splice.first, std::uint32_t(end) - splice.first, 0});
                taken_ += std::uint32_t(end) - splice.first;
                return;
            }
            taken_ = 0;
            edit_.splices.push_back(splice);
            edit_.objects.append(inside_.objects.slice(added_, splice.added));
            added_ += splice.added;
        }
    }

    const Document& document_;
    const Edit& inside_;
    const Document& outside_;
    const QSet<QString> insideIds_;
    FreshIds ids_;
    Containers::Parts parts_;
    std::unordered_map<ContainerId, ContainerId> made_;
    Edit edit_;
    std::size_t next_ = 0, added_ = 0; ///< of the splices and objects inside
    std::uint32_t taken_ = 0;          ///< objects of the next splice that are removed already
};

} // namespace

std::optional<Edit> withOutsideLayers(const Document& document, const Edit& inside,
                                      const Document& outside)
{
    return OutsideLayers(document, inside, outside).made();
}

} // namespace app
