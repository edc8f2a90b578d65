// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

namespace app {

using ChangeStyle = std::function<void(Style&)>;

/// The style of new objects: of the current layer if it has one, else the pen's.
Style newStyle(const Session& session);
/// The style that the current layer gives to new objects; empty: it leaves that to the pen.
std::optional<Style> layerStyle(const Session& session);
/// Gives the current layer a style for new objects, or takes it away, as one undo step.
void setLayerStyle(Session& session, const std::optional<Style>& style);

/// The styles of the selected objects, each once; if nothing is selected, that of new objects.
std::vector<Style> shownStyles(const Session& session);

/// What `property` gives for all styles; empty: it differs.
template <class Property>
auto common(std::span<const Style> styles, const Property& property)
    -> std::optional<std::decay_t<std::invoke_result_t<Property, const Style&>>>
{
    auto first = std::invoke(property, styles.front());
    for (const Style& style : styles.subspan(1))
        if (!(std::invoke(property, style) == first))
            return std::nullopt;
    return first;
}

/// Changes the selected objects as one undo step; if nothing is selected, the style of new objects.
/// Does nothing if nothing changes.
void restyle(Session& session, const ChangeStyle& change, const QString& text,
             Merging merging = Merging::Never);

/// The stroke's colour, or the fill's: &Style::stroke, &Style::fill.
using PaintPart = std::optional<Colour> Style::*;
/// restyle() for a colour; none removes the stroke or the fill. Refused, with a sentence, if an
/// object would be left with neither.
std::optional<QString> setColour(Session& session, PaintPart part,
                                 const std::optional<Colour>& colour);

/// The style that a person copied. It belongs to no drawing, so it holds the size of its unit.
struct CopiedStyle {
    Style style;
    double millimetresPerUnit = 1;
};
/// The style of the first selected object; if nothing is selected, that of new objects.
CopiedStyle copiedStyle(const Session& session);
/// Gives the selected objects this style at its size on paper, as one undo step; if nothing is
/// selected, new objects.
void pasteStyle(Session& session, const CopiedStyle& copied);

} // namespace app
