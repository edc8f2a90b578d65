// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/arrangements.h"

#include "app/session/arrange_selection.h"

#include <QCoreApplication>

namespace app {
namespace {

struct ArrangementsText {
    Q_DECLARE_TR_FUNCTIONS(Arrange)
};

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
    transformSelection(session, map, ArrangementsText::tr("Rotate selection"));
}

template <int x, int y>
void flip(Session& session)
{
    const auto map = [](const Point& pivot) { return scaling({x, y}, pivot); };
    transformSelection(session, map, ArrangementsText::tr("Flip selection"));
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
    const QString aligns = ArrangementsText::tr("&Align"),
                  spreads = ArrangementsText::tr("Spread eve&nly"),
                  sizes = ArrangementsText::tr("Make same si&ze");
    // THE CATALOGUE, in the order of the buttons.
    static const std::vector<Arrangement> all{
        {.kind = Align,
         .key = "align-left",
         .text = ArrangementsText::tr("&Left sides"),
         .name = ArrangementsText::tr("Align left sides"),
         .submenu = aligns,
         .run = alignOn<0, AlignTo::Least>},
        {.kind = Align,
         .key = "align-centre",
         .text = ArrangementsText::tr("&Middles, side by side"),
         .name = ArrangementsText::tr("Align middles, side by side"),
         .submenu = aligns,
         .run = alignOn<0, AlignTo::Middle>},
        {.kind = Align,
         .key = "align-right",
         .text = ArrangementsText::tr("&Right sides"),
         .name = ArrangementsText::tr("Align right sides"),
         .submenu = aligns,
         .run = alignOn<0, AlignTo::Most>},
        {.kind = Align,
         .key = "align-top",
         .text = ArrangementsText::tr("&Tops"),
         .name = ArrangementsText::tr("Align tops"),
         .submenu = aligns,
         .run = alignOn<1, AlignTo::Least>},
        {.kind = Align,
         .key = "align-middle",
         .text = ArrangementsText::tr("M&iddles, one above the other"),
         .name = ArrangementsText::tr("Align middles, one above the other"),
         .submenu = aligns,
         .run = alignOn<1, AlignTo::Middle>},
        {.kind = Align,
         .key = "align-bottom",
         .text = ArrangementsText::tr("&Bottoms"),
         .name = ArrangementsText::tr("Align bottoms"),
         .submenu = aligns,
         .run = alignOn<1, AlignTo::Most>},
        {.kind = Turn,
         .key = "rotate-left",
         .text = ArrangementsText::tr("Rotate 90° &left"),
         .name = ArrangementsText::tr("Rotate 90° left"),
         .shortcut = "Shift+O",
         .run = rotate<90>},
        {.kind = Turn,
         .key = "rotate-right",
         .text = ArrangementsText::tr("Rotate 90° r&ight"),
         .name = ArrangementsText::tr("Rotate 90° right"),
         .shortcut = "Alt+Shift+O",
         .run = rotate<-90>},
        {.kind = Turn,
         .key = "flip-horizontal",
         .text = ArrangementsText::tr("Flip &horizontally"),
         .name = ArrangementsText::tr("Flip horizontally"),
         .shortcut = "Shift+H",
         .run = flip<-1, 1>},
        {.kind = Turn,
         .key = "flip-vertical",
         .text = ArrangementsText::tr("Flip &vertically"),
         .name = ArrangementsText::tr("Flip vertically"),
         .shortcut = "Shift+V",
         .run = flip<1, -1>},
        {.kind = Spread,
         .key = "spread-horizontally",
         .text = ArrangementsText::tr("&Horizontally"),
         .name = ArrangementsText::tr("Spread evenly across"),
         .submenu = spreads,
         .least = 3,
         .run = spreadOn<0>},
        {.kind = Spread,
         .key = "spread-vertically",
         .text = ArrangementsText::tr("&Vertically"),
         .name = ArrangementsText::tr("Spread evenly down"),
         .submenu = spreads,
         .least = 3,
         .run = spreadOn<1>},
        {.kind = SameSize,
         .key = "same-width",
         .text = ArrangementsText::tr("&Width"),
         .name = ArrangementsText::tr("Make same width"),
         .submenu = sizes,
         .least = 2,
         .button = false,
         .run = sameSizeOn<true, false>},
        {.kind = SameSize,
         .key = "same-height",
         .text = ArrangementsText::tr("&Height"),
         .name = ArrangementsText::tr("Make same height"),
         .submenu = sizes,
         .least = 2,
         .button = false,
         .run = sameSizeOn<false, true>},
        {.kind = SameSize,
         .key = "same-size",
         .text = ArrangementsText::tr("&Both"),
         .name = ArrangementsText::tr("Make same size"),
         .submenu = sizes,
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
    return least == 1 ? ArrangementsText::tr("Nothing is selected. Select an object first.")
           : least == 2
               ? ArrangementsText::tr("Select several objects first.")
               : ArrangementsText::tr("Select at least three objects first: the outer two stay.");
}

} // namespace app
