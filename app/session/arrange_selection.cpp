// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/arrange_selection.h"

#include "app/base/text.h"
#include "app/commands/add_and_remove.h"
#include "app/commands/outline_strokes.h"
#include "app/document/hidden_objects.h"
#include "app/scene/bounds.h"

#include <array>

namespace app {
namespace {

/// Whether all objects of the range are in the set: one of its ranges then holds them.
bool holds(const ObjectRanges& set, const ObjectRange& range)
{
    const auto after = std::ranges::upper_bound(set.ranges(), range.first, {}, &ObjectRange::first);
    return after != set.ranges().begin() && std::prev(after)->end >= range.end;
}

/// The objects of the outermost group around an object that is selected as a whole.
ObjectRange unitAt(std::size_t object, const Session& session)
{
    const Containers& tree = session.now().containers();
    ObjectRange unit{object, object + 1};
    for (ContainerId id = tree.containerOf(object); id != 0; id = tree.parentOf(id)) {
        const ObjectRange range = tree.rangeOf(id);
        if (tree[id].kind != Container::Kind::Group || !holds(session.selection(), range))
            break;
        unit = range;
    }
    return unit;
}

std::vector<clipping::Window> boxesOf(std::span<const ArrangedUnit> units)
{
    std::vector<clipping::Window> boxes;
    for (const ArrangedUnit& unit : units)
        boxes.push_back(unit.box);
    return boxes;
}

const ArrangedUnit& lastOf(std::span<const ArrangedUnit> units, const Session& session)
{
    if (const auto line = session.inspected()) {
        const std::size_t object = session.scene.lines().objectOf(*line);
        for (const ArrangedUnit& unit : units)
            if (unit.objects.contains(object))
                return unit;
    }
    return units.back();
}

/// One map for each unit.
void pushArranged(Session& session, std::span<const ArrangedUnit> units,
                  std::span<const AffineMap> maps, const QString& text,
                  StrokeScaling strokes = StrokeScaling::Keep)
{
    ObjectRanges objects;
    std::vector<AffineMap> each; // units ascend, so the maps are in the order of the objects
    bool changes = false;
    for (std::size_t i = 0; i < units.size(); ++i) {
        for (const ObjectRange& range : units[i].objects.ranges())
            objects.insert(range);
        each.insert(each.end(), units[i].objects.size(), maps[i]);
        changes = changes || maps[i] != AffineMap{.from = maps[i].from, .to = maps[i].from};
    }
    if (changes)
        session.history.push(new TransformObjects(session.document, objects, each, strokes, text));
}

std::vector<AffineMap> translations(std::span<const Point> ways)
{
    std::vector<AffineMap> maps;
    for (const Point& way : ways)
        maps.push_back(translation(way));
    return maps;
}

QString noWindow()
{
    return Text::tr(
        "There is no clip window to align to. Draw one, or choose something else in Object > "
        "Align.");
}

} // namespace

ObjectRanges justAdded(const Session& session)
{
    const History& history = session.history;
    if (!history.canUndo())
        return {};
    const UndoCommand& last = history.command(history.index() - 1);
    constexpr std::array adding{AddObjects::row.key, CopyObjects::row.key, OutlineStrokes::row.key};
    if (std::ranges::find(adding, last.kind().key) == adding.end())
        return {};
    ObjectRanges added;
    for (const Splice& s : static_cast<const EditCommand&>(last).next().splices) // undoes it
        added.insert(ObjectRange{s.first, std::size_t(s.first) + s.removed});
    return common(added, editableObjects(session.now()));
}

std::span<const AlignmentTarget> alignmentTargets()
{
    using Box = std::optional<clipping::Window>;
    using Units = std::span<const ArrangedUnit>;
    static const std::array all{
        AlignmentTarget{"to-selection", Text::tr("To the &selection"), Text::tr("to selection"),
                        false,
                        [](const Session& session, Units) { return session.selectionBounds(); }},
        AlignmentTarget{
            "to-last", Text::tr("To the object clicked l&ast"), Text::tr("to last clicked"), false,
            [](const Session& session, Units units) { return Box(lastOf(units, session).box); }},
        AlignmentTarget{
            "to-page", Text::tr("To the &page"), Text::tr("to page"), true,
            [](const Session& session, Units) { return Box(session.now().page().rectangle()); }},
        AlignmentTarget{"to-window", Text::tr("To the &clip window"), Text::tr("to clip window"),
                        true, [](const Session& session, Units) { return session.clipWindow(); }},
    };
    return all;
}

const AlignmentTarget& alignmentTarget(const Session& session)
{
    return *std::ranges::find(alignmentTargets(), session.arrange.alignTo, &AlignmentTarget::key);
}

std::size_t leastSpread(const Session& session)
{
    return alignmentTarget(session).isExtent ? 2 : 3;
}

void alignTo(Session& session, const AlignmentTarget& target)
{
    session.arrange.alignTo = target.key;
    emit session.displayChanged();
}

void scaleStrokes(Session& session, StrokeScaling strokes)
{
    session.arrange.strokes = strokes;
    emit session.displayChanged();
}

std::vector<ArrangedUnit> arrangedUnits(const Session& session)
{
    std::vector<ArrangedUnit> units;
    std::size_t next = 0; // after the last unit
    for (const std::size_t object : session.selection()) {
        if (object < next)
            continue;
        const ObjectRange range = unitAt(object, session);
        next = range.end;
        ObjectRanges objects(range);
        if (const auto box = boundsOf(session.scene.lines(), objects))
            units.push_back({std::move(objects), *box});
    }
    return units;
}

void align(Session& session, int axis, AlignTo side)
{
    const auto units = arrangedUnits(session);
    if (units.empty())
        return;
    if (const auto to = alignmentTarget(session).box(session, units))
        pushArranged(session, units, translations(aligned(boxesOf(units), *to, axis, side)),
                     Text::tr("Align selection"));
    else
        emit session.refused(noWindow());
}

void spreadEvenly(Session& session, int axis)
{
    const auto units = arrangedUnits(session);
    const AlignmentTarget& target = alignmentTarget(session);
    const auto over = target.isExtent ? target.box(session, units) : std::nullopt;
    if (units.size() < leastSpread(session))
        emit session.refused(
            Text::tr("Select more objects to spread: at least three, or two to spread "
                     "them over the page or the clip window."));
    else if (target.isExtent && !over)
        emit session.refused(noWindow());
    else
        pushArranged(session, units, translations(spread(boxesOf(units), axis, over)),
                     Text::tr("Spread selection"));
}

void makeSameSize(Session& session, bool width, bool height)
{
    const auto units = arrangedUnits(session);
    if (units.size() < 2)
        return;
    const clipping::Window model = lastOf(units, session).box;
    pushArranged(session, units, sameSize(boxesOf(units), model, width, height),
                 Text::tr("Make same size"), session.arrange.strokes);
}

bool repeatSelection(Session& session, std::span<const AffineMap> maps, const QString& undoText)
{
    const ObjectRanges& originals = session.selection();
    if (maps.empty() || originals.empty())
        return true;
    if (maps.size() > mostCopied / originals.size())
        return false;
    Edit edit = copying(session.now(), originals, maps, session.entered.id());
    const ObjectRanges added = addedBy(edit.splices);
    session.history.push(new CopyObjects(session.document, std::move(edit), undoText));
    session.select(united(session.selection(), common(added, editableObjects(session.now()))));
    return true;
}

} // namespace app
