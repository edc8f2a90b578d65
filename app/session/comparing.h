// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

namespace app {

// What is only compared does not cut: neither the pane that is clicked nor the row that is chosen
// may change what an export or a permanent cut does, unless the person says so.

/// Begins or ends comparing. While it lasts, `Display::variant` is what the active pane shows, and
/// `Display::cuts` what cuts. At its end the drawing shows again what cuts.
void setComparing(Session& session, bool comparing);

/// Shows this variant, and lets it cut.
void useVariant(Session& session, const Variant& variant);

/// Who cuts, if another variant is shown: "EX cuts; KWC as published is only compared". Else empty.
QString onlyComparedText(const Session& session);

} // namespace app
