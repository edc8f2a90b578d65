// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/change_paths.h"

namespace app {
namespace {

Edit edited(const Document& document, std::span<const ChangedPath> paths)
{
    Edit edit;
    edit.objects = document.objects().slice(0, 0);
    bool removes = false;
    for (const ChangedPath& changed : paths) {
        const bool stays = changed.path.subpathCount() > 0;
        edit.splices.push_back({std::uint32_t(changed.object), 1, std::uint32_t(stays)});
        removes = removes || !stays;
        if (!stays)
            continue;
        ObjectRow row = document.objects()[changed.object].row();
        row.path = changed.path;
        if (row.particulars->recipe != changed.recipe)
            row.particulars.own().recipe = changed.recipe;
        edit.objects.append(row);
    }
    if (removes)
        edit.containers = document.containers().spliced(edit.splices);
    return edit;
}

} // namespace

ChangePaths::ChangePaths(EditedDocument& document, std::span<const ChangedPath> paths,
                         const QString& text, Merging merging)
    : EditCommand(row, document, edited(document.now(), paths), text, merging)
{
}

} // namespace app
