// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/name_match.h"
#include "app/session/session.h"

#include <chrono>
#include <vector>

namespace app {

/// A clip window, a layer, a group or an object of the drawing.
struct NamedThing {
    enum class Kind : std::uint8_t { Window, Layer, Group, Object };
    Kind kind;
    std::size_t number; ///< of the window or the object; the ContainerId of a layer or group
    QString name;
    QString what;   ///< "layer, 64 objects", "object in Garden"
    QString remark; ///< "hidden", "locked"; empty: it can be chosen
    NameMatch match;
};

/// Those whose names fit the text, at most `most`, windows first. Objects are found by a part of
/// their id or title or, if a number is typed, of what they are called ("Line 12"), for at most the
/// given time: `isAll` says whether all were looked at.
struct NamedThings {
    std::vector<NamedThing> list{};
    bool isAll = true;
};
NamedThings thingsNamed(const Session& session, const QString& typed, std::size_t most,
                        std::chrono::microseconds time);

/// Chooses the window, or selects the objects; what is hidden or locked is refused with a sentence.
/// False: it is refused, or gone.
bool chooseThing(Session& session, const NamedThing& thing);

} // namespace app
