// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

namespace app {

// What a person selects as one: an object, or the outermost group around it that is not entered.

/// The group that a click on the object selects; 0: the object alone.
ContainerId groupAt(const Session& session, std::size_t object);
/// The objects that a click on this object selects: those of its group that may be edited.
ObjectRanges unitAt(const Session& session, std::size_t object);
/// The same for objects found in a box. Groups that are not found as a whole are selected (`Any`),
/// or not (`Whole`). While a group is entered, objects outside it are left out.
enum class FoundGroups : std::uint8_t { Whole, Any };
ObjectRanges unitsOf(const Session& session, const ObjectRanges& found, FoundGroups groups);
/// Where new objects go: the entered group, or the current layer.
ContainerId containerForNew(const Session& session);
ContainerId layerForNew(const Session& session); ///< the layer around it
/// Whether objects may be added there: it is neither locked nor hidden.
bool mayAddObjects(const Session& session);
QString nameForNew(const Session& session); ///< of the entered group or layer, for people
/// All objects that may be selected: those of the entered group, or of the drawing.
ObjectRanges selectableObjects(const Session& session);

/// The short name of an object, for places that show its kind by an icon: its id, or else its kind
/// and its number ("Rectangle 3").
QString objectName(const Session& session, std::size_t object);
/// The same in a sentence or a title, always with the kind: "Rectangle 3", "Path “roof”".
QString objectText(const Session& session, std::size_t object);
/// Whether a part of the name is what was typed, be the digits of its number grouped or not.
bool objectNameHas(const Session& session, std::size_t object, const QString& typed);
/// The selection in words: "Path “roof”", "3 objects", "Kitchen, group of 3 objects", "2 nodes",
/// "nothing selected".
QString selectionText(const Session& session);
QString groupName(const Container& group); ///< for people; "Group" if it has no name

/// Whether a group is selected as a whole. Quick, for menus: of a selection in many pieces, only
/// some are looked at, and `true` is assumed.
bool someGroupSelected(const Session& session);
/// The groups that are selected as a whole, from bottom to top.
std::vector<ContainerId> selectedGroups(const Session& session);

} // namespace app
