// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/catalogue.h"

#include "app/commands/add_and_remove.h"
#include "app/commands/change_paths.h"
#include "app/commands/crop_to_window.h"
#include "app/commands/move_objects.h"
#include "app/commands/name_object.h"
#include "app/commands/outline_strokes.h"
#include "app/commands/rearrange_objects.h"
#include "app/commands/resize_objects.h"
#include "app/commands/set_containers.h"
#include "app/commands/set_hidden.h"
#include "app/commands/set_page_parts.h"
#include "app/commands/set_style.h"
#include "app/commands/transform_objects.h"

#include <array>

namespace app {

// THE CATALOGUE. To add a command, write its file in app/commands/ and name its row here.
std::span<const CommandKind> commandKinds()
{
    // clang-format off
    static constexpr std::array all{
        AddObjects::row,
        RemoveObjects::row,
        MoveObjects::row,
        ResizeObjects::row,
        TransformObjects::row,
        CopyObjects::row,
        ChangePaths::row,
        OutlineStrokes::row,
        RearrangeObjects::row,
        SetStyle::row,
        SetHidden::row,
        NameObject::row,
        SetWindows::row,
        SetGuides::row,
        SetSheets::row,
        ChangePage::row,
        SetContainers::row,
        RemoveLayer::row,
        CropToWindow::row,
    };
    // clang-format on
    return all;
}

} // namespace app
