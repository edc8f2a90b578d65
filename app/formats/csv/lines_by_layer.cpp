// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/lines_by_layer.h"

#include "app/document/contents.h"
#include "app/document/document_builder.h"
#include "app/formats/csv/columns.h"

namespace app::csv {

void LinesByLayer::turnTo(std::string_view layer)
{
    if (!layers_.empty() && layer == name_)
        return;
    name_ = layer;
    layer_ = layerOf(layer);
    isBeyond_ = layers_[layer_].name != layer;
}

std::size_t LinesByLayer::layerOf(std::string_view name)
{
    if (const auto found = found_.find(name); found != found_.end())
        return found->second;
    if (layers_.size() == Containers::mostLayers)
        return layers_.size() - 1;
    layers_.push_back({std::string(name), none_});
    found_.emplace(name, layers_.size() - 1);
    return layers_.size() - 1;
}

void LinesByLayer::add(const clipping::Segment& line, const StyleEntry& style)
{
    Layer& layer = layers_[layer_];
    layer.objects.appendLine(line, style);
    layer.order.push_back(std::uint32_t(size_++));
    beyond_ += isBeyond_;
}

void LinesByLayer::add(std::span<const Subpath> lines, const StyleEntry& style)
{
    Layer& layer = layers_[layer_];
    if (!lines.empty()) {
        layer.objects.append(ObjectRow{Path(lines), style});
        layer.order.push_back(std::uint32_t(size_));
        beyond_ += isBeyond_;
    }
    ++size_;
}

Document LinesByLayer::take()
{
    DocumentBuilder builder;
    for (Layer& layer : layers_) {
        Container container;
        container.name = layer.name.empty() ? usualLayer() : QString::fromStdString(layer.name);
        builder.open(std::move(container));
        builder.add(std::exchange(layer.objects, {}));
        builder.close();
    }
    Page page = pageAround(builder.objects());
    if (size_ > 0) {
        page.width = {page.size.x, Unit::Px};
        page.height = {page.size.y, Unit::Px};
    }
    return builder.take(page);
}

std::vector<std::uint32_t> LinesByLayer::order()
{
    if (layers_.empty())
        return {};
    std::vector<std::uint32_t> all = std::move(layers_.front().order);
    all.reserve(size_);
    for (std::size_t i = 1; i < layers_.size(); ++i)
        all.insert(all.end(), layers_[i].order.begin(), layers_[i].order.end());
    return all;
}

} // namespace app::csv
