// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

namespace app {

/// What a gesture would keep if it ended now: a new object, or an object in its new form.
struct ObjectInHand : PendingObject {
    std::optional<std::size_t> replaces{}; ///< the object that is edited; empty: a new one

    ObjectInHand(PendingObject pending, std::optional<std::size_t> edited = std::nullopt)
        : PendingObject(std::move(pending)), replaces(edited)
    {
    }
    friend bool operator==(const ObjectInHand& a, const ObjectInHand& b)
    {
        return a.into == b.into && a.object == b.object && a.replaces == b.replaces;
    }
};

/// The edit that keeps it. A new object goes into the last layer if its container is gone, and so
/// does an object whose old form is gone.
Edit keeping(const Document& document, const ObjectInHand& inHand);

} // namespace app
