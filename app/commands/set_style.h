// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"
#include "app/document/style_table.h"

#include <unordered_map>

namespace app {

/// Changes the styles of objects, one by one: `change` is called once for each style.
class StyleChanges {
public:
    explicit StyleChanges(std::function<void(Style&)> change) : change_(std::move(change)) {}
    void operator()(ObjectRow& object, StyleTable& styles);

private:
    std::function<void(Style&)> change_;
    std::unordered_map<StyleIndex, StyleEntry> known_; ///< the new style of each old style
};

/// Changes how objects are painted.
class SetStyle : public EditCommand {
public:
    static constexpr CommandKind row{"set-style", "Changes how objects are painted"};

    /// Calls `change` at least once for each style of the objects.
    SetStyle(EditedDocument& document, const ObjectRanges& objects,
             const std::function<void(Style&)>& change, const QString& text,
             Merging merging = Merging::Never);
};

/// Multiplies the lengths of a stroke: its width and its dashes.
inline void scaleStroke(Style& style, double scale)
{
    style.width *= scale;
    style.dashOffset *= scale;
    for (double& dash : style.dashes)
        dash *= scale;
}

} // namespace app
