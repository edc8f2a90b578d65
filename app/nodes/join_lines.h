// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

namespace app {

/// Joins all lines and other open paths of a drawing whose ends are at most `tolerance` (user
/// units) apart, within their layer or group and their style; see end_joining.h. Objects of several
/// subpaths and shapes that are edited as such (texts) stay as they are. Returns the number of
/// joints.
std::size_t joinLines(Document& document, double tolerance);

} // namespace app
