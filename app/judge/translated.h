// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace app::plug_in {

/// The texts of this room, for translators: `PlugIn::tr("Text")`.
struct PlugIn {
    Q_DECLARE_TR_FUNCTIONS(PlugIn)
};

} // namespace app::plug_in
