// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/arrangements.h"

#include "app/base/text.h"
#include "app/session/arrange_selection.h"

namespace app {
namespace {

/// Transforms the selection; `map` takes its pivot, which stays where a person put it.
template <typename Map>
void transformSelection(Session& session, Map map, const QString& undoText)
{
    if (!session.selectionBounds())
        return;
    const bool moved = session.pivot.isMoved();
    const Point pivot = session.pivot.at();
    session.history.push(new TransformObjects(session.document, session.selection(), map(pivot),
                                              StrokeScaling::Keep, undoText));
    if (moved)
        session.pivot.put(pivot);
}

template <int degrees>
void rotate(Session& session)
{
    const auto map = [](const Point& pivot) { return rotation(degrees, pivot); };
    transformSelection(session, map, Text::tr("Rotate selection"));
}

template <int x, int y>
void flip(Session& session)
{
    const auto map = [](const Point& pivot) { return scaling({x, y}, pivot); };
    transformSelection(session, map, Text::tr("Flip selection"));
}

template <int axis, AlignTo side>
void alignOn(Session& session)
{
    align(session, axis, side);
}
template <int axis>
void spreadOn(Session& session)
{
    spreadEvenly(session, axis);
}
template <bool width, bool height>
void sameSizeOn(Session& session)
{
    makeSameSize(session, width, height);
}

} // namespace

std::span<const Arrangement> arrangements()
{
    using enum Arrangement::Kind;
    // THE CATALOGUE, in the order of the buttons.
    static const std::vector<Arrangement> all{
        {.kind = Align,
         .key = "align-left",
         .text = Text::tr("Align &left sides"),
         .name = Text::tr("Align left sides"),
         .run = alignOn<0, AlignTo::Least>},
        {.kind = Align,
         .key = "align-centre",
         .text = Text::tr("Align &middles, side by side"),
         .name = Text::tr("Align middles, side by side"),
         .run = alignOn<0, AlignTo::Middle>},
        {.kind = Align,
         .key = "align-right",
         .text = Text::tr("Align &right sides"),
         .name = Text::tr("Align right sides"),
         .run = alignOn<0, AlignTo::Most>},
        {.kind = Align,
         .key = "align-top",
         .text = Text::tr("Align &tops"),
         .name = Text::tr("Align tops"),
         .run = alignOn<1, AlignTo::Least>},
        {.kind = Align,
         .key = "align-middle",
         .text = Text::tr("Align m&iddles, one above the other"),
         .name = Text::tr("Align middles, one above the other"),
         .run = alignOn<1, AlignTo::Middle>},
        {.kind = Align,
         .key = "align-bottom",
         .text = Text::tr("Align &bottoms"),
         .name = Text::tr("Align bottoms"),
         .run = alignOn<1, AlignTo::Most>},
        {.kind = Turn,
         .key = "rotate-left",
         .text = Text::tr("Rotate 90° &left"),
         .name = Text::tr("Rotate 90° left"),
         .shortcut = "Shift+O",
         .run = rotate<90>},
        {.kind = Turn,
         .key = "rotate-right",
         .text = Text::tr("Rotate 90° r&ight"),
         .name = Text::tr("Rotate 90° right"),
         .shortcut = "Alt+Shift+O",
         .run = rotate<-90>},
        {.kind = Turn,
         .key = "flip-horizontal",
         .text = Text::tr("Flip &horizontally"),
         .name = Text::tr("Flip horizontally"),
         .shortcut = "Shift+H",
         .run = flip<-1, 1>},
        {.kind = Turn,
         .key = "flip-vertical",
         .text = Text::tr("Flip &vertically"),
         .name = Text::tr("Flip vertically"),
         .shortcut = "Shift+V",
         .run = flip<1, -1>},
        {.kind = Spread,
         .key = "spread-horizontally",
         .text = Text::tr("Spread &horizontally"),
         .name = Text::tr("Spread evenly across"),
         .least = 3,
         .run = spreadOn<0>},
        {.kind = Spread,
         .key = "spread-vertically",
         .text = Text::tr("Spread &vertically"),
         .name = Text::tr("Spread evenly down"),
         .least = 3,
         .run = spreadOn<1>},
        {.kind = SameSize,
         .key = "same-width",
         .text = Text::tr("Make same &width"),
         .name = Text::tr("Make same width"),
         .least = 2,
         .button = false,
         .run = sameSizeOn<true, false>},
        {.kind = SameSize,
         .key = "same-height",
         .text = Text::tr("Make same hei&ght"),
         .name = Text::tr("Make same height"),
         .least = 2,
         .button = false,
         .run = sameSizeOn<false, true>},
        {.kind = SameSize,
         .key = "same-size",
         .text = Text::tr("Make same width an&d height"),
         .name = Text::tr("Make same size"),
         .least = 2,
         .button = false,
         .run = sameSizeOn<true, true>},
    };
    return all;
}

QString refusal(const Arrangement& how, const Session& session)
{
    const bool spreads = how.kind == Arrangement::Kind::Spread;
    const std::size_t least = spreads ? leastSpread(session) : how.least;
    if (session.selection().size() >= least)
        return {};
    return least == 1   ? Text::tr("Nothing is selected. Select an object first.")
           : least == 2 ? Text::tr("Select several objects first.")
                        : Text::tr("Select at least three objects first: the outer two stay.");
}

} // namespace app
