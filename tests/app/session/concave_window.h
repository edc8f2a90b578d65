// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

/// A concave clip window in a box: an arrow head that points right.
inline app::ClipWindow concaveWindow(const QString& name, const clipping::Window& box)
{
    const app::Point middle = (box.min + box.max) * 0.5;
    const app::Subpath outline{
        box.min, {{{box.max.x, middle.y}}, {{box.min.x, box.max.y}}, {middle}}, true};
    return {.name = name, .shape = app::PathShape{app::Path({&outline, 1})}};
}

inline void setWindows(app::Session& session, std::vector<app::ClipWindow> list,
                       app::Keep keep = app::Keep::Inside)
{
    app::Edit edit;
    edit.windows = app::ClipWindows{std::move(list), keep};
    session.document.apply(edit);
}
