// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/export_area.h"
#include "app/session/session.h"

namespace app {

/// What exports of an open drawing are made of now: its document, selection and algorithm.
inline ExportSource exportSourceOf(const Session& session)
{
    return {session.now(), session.selection(), session.uses().clipAll, session.display().cutting};
}

} // namespace app
