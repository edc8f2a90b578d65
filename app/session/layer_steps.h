// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/stacking.h"
#include "app/session/session.h"

namespace app {

// Undoable steps on layers. A step that is impossible changes nothing; if it is not plain to see
// why, Session::refused says so. The selection stays.

enum class LayerStep : std::uint8_t {
    Up,     ///< above the next layer; out of the layer around it, from the top there
    Down,   ///< below the next layer
    Inward, ///< into the layer that is above it, as its lowest
    Outward ///< out of the layer around it, below that
};
/// Where the step leads; empty: nowhere.
std::optional<ContainerPlace> placeAfter(const Containers& tree, ContainerId layer, LayerStep step);
/// The place directly below a layer in a list of all layers: with layers in it, on top of them.
ContainerPlace placeBelow(const Containers& tree, ContainerId layer);
void moveLayer(Session& session, ContainerId layer, const ContainerPlace& place);
void moveLayer(Session& session, ContainerId layer, LayerStep step);

/// Hides all other layers, except those around it and in it; if they are hidden already, shows all
/// layers.
void showOnlyLayer(Session& session, ContainerId layer);

/// Rows of the tree of objects: layers and groups, and objects by themselves.
struct TreeRows {
    std::vector<ContainerId> containers{};
    ObjectRanges objects{};

    std::size_t size() const { return containers.size() + objects.size(); }
};
/// Shows or hides them all, as one step. Objects that are locked stay.
void show(Session& session, const TreeRows& rows, bool visible);
/// Locks or unlocks the layers and groups, as one step.
void lock(Session& session, const TreeRows& rows, bool locked);

} // namespace app

// Undoable steps that fail if the document already has as many layers as it may have. Then nothing
// changes, and `Session::refused` says why.

namespace app {

/// Adds an empty layer above all others; returns whether there was room.
bool addLayer(Session& session, const QString& name);

} // namespace app
