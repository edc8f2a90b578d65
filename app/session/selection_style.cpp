// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/selection_style.h"

#include "app/base/text.h"
#include "app/commands/set_containers.h"
#include "app/commands/set_style.h"
#include "app/document/styles_in_use.h"
#include "app/formats/svg/style_text.h"
#include "app/session/units.h"

#include <algorithm>

namespace app {
namespace {

Style scaledStyle(Style style, double factor)
{
    scaleStroke(style, factor);
    return style;
}

} // namespace

Style newStyle(const Session& session) { return layerStyle(session).value_or(session.pen.style); }

std::optional<Style> layerStyle(const Session& session)
{
    // Asked for at every frame of a gesture.
    static thread_local std::pair<QString, std::optional<Style>> last;
    const QString& text = session.now().containers()[layerForNew(session)].newStyle;
    if (text.isEmpty())
        return std::nullopt;
    if (text != last.first)
        last = {text, svg::styleOf(text)};
    return last.second;
}

void setLayerStyle(Session& session, const std::optional<Style>& style)
{
    Container layer = session.now().containers()[layerForNew(session)];
    const QString text = style ? svg::declarations(*style) : QString();
    if (layer.newStyle == text)
        return;
    layer.newStyle = text;
    session.history.push(new SetContainers(session.document, session.now().containers().with(layer),
                                           Text::tr("Style of new objects")));
}

std::vector<Style> shownStyles(const Session& session)
{
    if (session.selection().empty())
        return {newStyle(session)};
    const Objects& objects = session.now().objects();
    std::vector<Style> styles;
    for (const StyleIndex style : stylesOf(objects, session.selection()))
        styles.push_back(objects.styles()[style]);
    return styles;
}

namespace {

/// Whether the change leaves all shown styles as they are.
bool changesNothing(const Session& session, const ChangeStyle& change)
{
    return std::ranges::all_of(shownStyles(session), [&change](const Style& style) {
        Style changed = style;
        change(changed);
        return changed == style;
    });
}

} // namespace

void restyle(Session& session, const ChangeStyle& change, const QString& text, Merging merging)
{
    if (changesNothing(session, change))
        return;
    if (!session.selection().empty()) {
        session.history.push(
            new SetStyle(session.document, session.selection(), change, text, merging));
        return;
    }
    if (auto style = layerStyle(session)) {
        change(*style);
        setLayerStyle(session, style);
        return;
    }
    change(session.pen.style);
    emit session.displayChanged(); // bars and panels show it
}

std::optional<QString> setColour(Session& session, PaintPart part,
                                 const std::optional<Colour>& colour)
{
    const bool stroke = part == &Style::stroke;
    const auto other = stroke ? &Style::fill : &Style::stroke;
    const auto leavesNothing = [&](const Style& style) { return !colour && !(style.*other); };
    if (std::ranges::any_of(shownStyles(session), leavesNothing))
        return stroke ? Text::tr(
                   "Without a stroke and without a fill nothing would be visible. Choose a "
                   "fill first.")
                      : Text::tr(
                          "Without a stroke and without a fill nothing would be visible. Choose a "
                          "stroke colour first.");
    restyle(
        session, [&](Style& style) { style.*part = colour; },
        stroke ? Text::tr("Stroke colour") : Text::tr("Fill colour"));
    return std::nullopt;
}

CopiedStyle copiedStyle(const Session& session)
{
    const Style style = session.selection().empty()
                            ? newStyle(session)
                            : session.now().objects()[session.selection().first()].style();
    return {style, session.now().page().millimetresPerUnit()};
}

void pasteStyle(Session& session, const CopiedStyle& copied)
{
    const double factor = copied.millimetresPerUnit / session.now().page().millimetresPerUnit();
    const Style style = factor == 1 ? copied.style : scaledStyle(copied.style, factor);
    restyle(
        session, [&style](Style& each) { each = style; }, Text::tr("Paste style"));
}

} // namespace app
