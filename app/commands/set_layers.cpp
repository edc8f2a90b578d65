// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_layers.h"

#include <QCoreApplication>

#include <cassert>
#include <utility>

namespace app {

SetLayers::SetLayers(Drawing& drawing, std::vector<Layer> layers, const QString& text)
    : UndoCommand(row, text), drawing_(drawing), other_(std::move(layers))
{
    assert(other_.size() >= drawing.sheet().layers.size());
}

void SetLayers::exchange()
{
    std::vector<Layer> present = drawing_.sheet().layers;
    drawing_.setLayers(std::exchange(other_, std::move(present)));
}

RemoveLayer::RemoveLayer(Drawing& drawing, std::uint32_t layer)
    : UndoCommand(row, QCoreApplication::translate("Commands", "Remove layer %1")
                           .arg(drawing.sheet().layers[layer].name)),
      drawing_(drawing), layer_(layer), removed_(drawing.sheet().layers[layer]),
      first_(layer == 0 ? 0 : drawing.endOfLayer(layer - 1))
{
    assert(drawing.sheet().layers.size() > 1);
}

// The shapes above are on a layer with one number less (more): they are spliced together with those
// of the layer, so that no listener sees a shape on a layer that is not there.
void RemoveLayer::redo()
{
    const Sheet& sheet = drawing_.sheet();
    const auto at = [&](std::size_t i) { return sheet.shapes.begin() + std::ptrdiff_t(i); };
    const std::size_t end = drawing_.endOfLayer(layer_), count = sheet.shapes.size() - first_;
    std::vector<Shape> above(at(end), sheet.shapes.end());
    for (Shape& shape : above)
        --shape.layer;
    std::vector<Shape> old = drawing_.splice(first_, count, std::move(above));
    shapes_.assign(std::make_move_iterator(old.begin()),
                   std::make_move_iterator(old.begin() + std::ptrdiff_t(end - first_)));
    std::vector<Layer> layers = sheet.layers;
    layers.erase(layers.begin() + layer_);
    drawing_.setLayers(std::move(layers));
}

void RemoveLayer::undo()
{
    const Sheet& sheet = drawing_.sheet();
    std::vector<Layer> layers = sheet.layers;
    layers.insert(layers.begin() + layer_, removed_);
    drawing_.setLayers(std::move(layers));
    std::vector<Shape> all = std::move(shapes_);
    for (auto shape = sheet.shapes.begin() + std::ptrdiff_t(first_); shape != sheet.shapes.end();
         ++shape) {
        all.push_back(*shape);
        ++all.back().layer;
    }
    drawing_.splice(first_, sheet.shapes.size() - first_, std::move(all));
}

} // namespace app
