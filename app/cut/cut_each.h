// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/cut_object.h"
#include "app/document/objects.h"

namespace app {

/// What remains of each of some objects that are in no document yet, as `cut` would leave it in one
/// with this page. All are cut, hidden ones too, and no group is made of an area and its lines:
/// objects made of one have the same particulars. Options about a document do not count.
std::vector<CutObject> cutEach(const Objects& objects, const Page& page, const CutOptions& options);

} // namespace app
