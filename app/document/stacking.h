// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/tree_draft.h"

#include <functional>

namespace app {

// Changes of the painting order, within the layer or group of each object, and between layers.
// `objects` and `entered` are as in regrouping.h.

enum class Stacking : std::uint8_t { Raise, Lower, ToFront, ToBack };

/// Whether an object, or a group as a whole, overlaps the chosen objects.
using Overlaps = std::function<bool(const ObjectRange& objects)>;

/// Raise and Lower pass the next object that overlaps; without one they change nothing.
std::optional<Rearranged> stacked(const Document& document, const ObjectRanges& objects,
                                  ContainerId entered, Stacking how, const Overlaps& overlaps);

/// Puts the objects on top of a layer.
std::optional<Rearranged> movedTo(const Document& document, const ObjectRanges& objects,
                                  ContainerId entered, ContainerId layer);

/// Puts the objects into a layer or group, above what ends at or below the object `at` there.
/// Changes nothing if that is in a group that is moved.
std::optional<Rearranged> movedBetween(const Document& document, const ObjectRanges& objects,
                                       ContainerId entered, ContainerId into, std::size_t at);

/// A place in a layer, a group or the document (0).
struct ContainerPlace {
    ContainerId parent = 0;
    /// The container there that is directly below the place; 0: it is below everything else; empty:
    /// it is above everything else.
    std::optional<ContainerId> below{};
};
/// Why a place cannot hold a layer or group.
enum class MoveFault : std::uint8_t { None, Removed, IntoItself, LayerIntoGroup, GroupOutOfLayer };
MoveFault faultOf(const Containers& tree, ContainerId id, const ContainerPlace& place);

/// Puts a layer or group into another place. `objects` are followed. Empty also if the place cannot
/// hold it.
std::optional<Rearranged> movedContainer(const Document& document, ContainerId id,
                                         const ContainerPlace& place,
                                         const ObjectRanges& objects = {});

} // namespace app
