// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/layers.h"

#include "app/formats/svg/limits.h"
#include "app/formats/svg/refused.h"

namespace app::svg {

Layers::Layers(Sheet& sheet) : sheet_(sheet), open_{{{Text::tr("Drawing")}, {}}}
{
    sheet_.layers.clear();
}

void Layers::open(const Layer& layer)
{
    const Layer& around = open_.back().layer;
    const bool nested = open_.size() > 1;
    open_.push_back({{layer.name, layer.visible && (!nested || around.visible),
                      layer.locked || (nested && around.locked), layer.id},
                     {}});
    begin(open_.back());
}

void Layers::close() { open_.pop_back(); }

void Layers::begin(Open& open)
{
    if (sheet_.layers.size() + 1 < mostLayers) {
        Layer layer = open.layer;
        if (open.parts++ > 0) {
            layer.name = QStringLiteral("%1 (%2)").arg(layer.name).arg(open.parts);
            layer.id.clear(); // an id is there once
        }
        sheet_.layers.push_back(layer);
    } else if (!merged_) {
        sheet_.layers.push_back({Text::tr("All further layers")});
        merged_ = true;
    }
    open.index = sheet_.layers.size() - 1;
}

void Layers::add(Shape shape)
{
    Open& open = open_.back();
    if (!open.index || *open.index + 1 != sheet_.layers.size())
        begin(open);
    shape.layer = std::uint32_t(*open.index);
    if (merged_ && !open.layer.visible)
        shape.hidden = true;
    sheet_.shapes.push_back(std::move(shape));
}

void Layers::finish()
{
    if (sheet_.layers.empty())
        sheet_.layers.push_back(open_.front().layer);
}

} // namespace app::svg
