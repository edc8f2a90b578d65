// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/number_runs.h"
#include "app/document/object_ranges.h"
#include "app/document/objects.h"

#include <span>
#include <vector>

namespace app {

/// Objects that stay together when the order of all objects changes.
struct MovedRun {
    ObjectRange objects; ///< of the document or, if `added`, of the added objects
    bool added = false;
};

/// The change of order as splices.
struct MovedObjects {
    std::vector<Splice> splices{};
    Objects objects{};  ///< that the splices add
    NumberRuns moved{}; ///< see Edit::moved
    ObjectRanges chosen{}, added{};
};

/// The change that gives the objects the order of `runs`, which name each of them at most once;
/// the others are removed. As many objects as possible keep their places. `chosen` are followed,
/// and so are the added ones. O(runs · log runs).
MovedObjects objectsMoved(const Objects& objects, const Objects& added,
                          std::span<const MovedRun> runs, const ObjectRanges& chosen);

/// Whether one of the objects is in the range. O(log ranges).
bool meets(const ObjectRanges& objects, const ObjectRange& range);
/// Those of the objects that are in the range. O(log ranges + ranges of the result).
ObjectRanges within(const ObjectRanges& objects, const ObjectRange& range);

} // namespace app
