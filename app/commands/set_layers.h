// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/patch.h"

namespace app {

/// Shows, hides, locks, renames layers, or adds one on top: the shapes stay on the layers they are
/// on.
class SetLayers : public UndoCommand {
public:
    static constexpr CommandKind row{"set-layers", "Changes or adds layers"};

    /// At least as many layers as there are.
    SetLayers(Drawing& drawing, std::vector<Layer> layers, const QString& text);

    void redo() override { exchange(); }
    void undo() override { exchange(); }
    std::size_t bytes() const override { return heapBlock(sizeof *this) + heapBytes(other_); }

private:
    void exchange();

    Drawing& drawing_;
    std::vector<Layer> other_;
};

/// Removes a layer with what is on it. There must be another one.
class RemoveLayer : public UndoCommand {
public:
    static constexpr CommandKind row{"remove-layer", "Removes a layer with its shapes"};

    RemoveLayer(Drawing& drawing, std::uint32_t layer);

    void redo() override;
    void undo() override;
    std::size_t bytes() const override
    {
        return heapBlock(sizeof *this) + heapBytes(removed_) + heapBytes(shapes_);
    }

private:
    Drawing& drawing_;
    std::uint32_t layer_;
    Layer removed_;
    std::vector<Shape> shapes_; ///< in force: those that were on it
    std::size_t first_;
};

} // namespace app
