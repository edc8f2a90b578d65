// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/drawn_layers.h"

#include "app/document/contents.h"
#include "app/document/document_builder.h"

#include <utility>

namespace app::dxf {

DrawnLayers::DrawnLayers(const Tables& tables, const Header& header) : header_(header)
{
    none_.styles();
    for (const LayerEntry& layer : tables.layers)
        if (std::string capitals = inCapitals(layer.name); !found_.contains(capitals))
            added(layer, std::move(capitals));
}

std::size_t DrawnLayers::added(const LayerEntry& entry, std::string capitals)
{
    if (layers_.size() < Containers::mostLayers)
        layers_.push_back({entry, none_});
    else
        ++beyond_;
    found_.emplace(std::move(capitals), layers_.size() - 1);
    return layers_.size() - 1;
}

std::size_t DrawnLayers::indexOf(std::string_view name)
{
    if (!layers_.empty() && name == name_)
        return index_;
    std::string capitals = inCapitals(name);
    const auto found = found_.find(capitals);
    name_ = name;
    index_ = found != found_.end() ? found->second
                                   : added(LayerEntry{.name = name}, std::move(capitals));
    return index_;
}

void DrawnLayers::addLine(std::size_t layer, const clipping::Segment& line, const StyleEntry& style)
{
    layers_[layer].objects.appendLine(line, style);
}

void DrawnLayers::add(std::size_t layer, const ObjectRow& object)
{
    layers_[layer].objects.append(object);
}

Document DrawnLayers::take()
{
    DocumentBuilder builder;
    for (Layer& layer : layers_) {
        Container container;
        container.name = textOf(layer.entry.name, header_);
        container.visible = !layer.entry.off && !layer.entry.frozen;
        container.locked = layer.entry.locked;
        builder.open(std::move(container));
        builder.add(std::exchange(layer.objects, {}));
        builder.close();
    }
    Page page = pageAround(builder.objects());
    if (builder.size() > 0) {
        const double millimetres = header_.millimetres();
        const Unit shown = header_.unit ? header_.unit->shown : Unit::Mm;
        const double unit = millimetres / infoOf(shown).millimetres;
        page.width = {page.size.x * unit, shown};
        page.height = {page.size.y * unit, shown};
    }
    return builder.take(page);
}

} // namespace app::dxf
