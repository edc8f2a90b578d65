// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"

namespace app {

/// Shows, hides, locks, renames or adds layers and groups. The painting order of objects does not
/// change.
class SetContainers : public EditCommand {
public:
    static constexpr CommandKind row{"set-containers", "Changes or adds layers and groups"};

    /// `containers` must span exactly the document's objects.
    SetContainers(EditedDocument& document, Containers containers, const QString& text);
};

/// Removes a layer with its content. It must not be the last layer of the first level.
class RemoveLayer : public EditCommand {
public:
    static constexpr CommandKind row{"remove-layer", "Removes a layer with its objects"};

    RemoveLayer(EditedDocument& document, ContainerId layer);
};

} // namespace app
