// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/copy_selection.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/commands/add_and_remove.h"
#include "app/commands/move_objects.h"
#include "app/commands/set_containers.h"
#include "app/document/copies.h"
#include "app/document/hidden_objects.h"
#include "app/document/placed_images.h"
#include "app/export/drawn_box.h"
#include "app/session/image_room.h"
#include "app/session/units.h"

namespace app {
namespace {

constexpr double stepMillimetres = 5; // from one copy to the next

void pushCopies(Session& session, std::optional<Rearranged> copies, const QString& undoText)
{
    if (!copies) {
        emit session.refused(
            Text::tr("Nothing was copied: a drawing can have %1 layers and groups, and %2 layers.")
                .arg(countText(Containers::mostContainers), countText(Containers::mostLayers)));
        return;
    }
    if (copies->added.empty() && copies->edit.containers) // images alone
        session.history.push(
            new SetContainers(session.document, std::move(*copies->edit.containers), undoText));
    else
        session.history.push(new AddObjects(session.document, std::move(copies->edit), undoText));
    session.select(common(copies->added, editableObjects(session.now())));
}

Document movedBy(const Document& drawing, const Point& by)
{
    Document moved = withOwnStyles(drawing);
    const ObjectRanges all(ObjectRange{0, drawing.objects().size()});
    moved.apply(changed(drawing, all, [&](ObjectRow& object, StyleTable&) {
        place(object, {{1, 1}, by});
    }));
    moved.apply({.containers = withPlacedImages(drawing.containers(), {{1, 1}, by})});
    return moved;
}

/// What is copied within a drawing would lay its image on itself.
Document withNewImages(Document drawing, const Session& session)
{
    if (!drawing.objects().empty() && drawing.containers().isUnderlaid())
        drawing.apply(
            {.containers = withoutImagesOf(drawing.containers(), session.now().containers())});
    return drawing;
}

/// What was copied at another scale, or far away, would be looked for.
Point intoSight(const Document& drawing, const Point& by,
                const std::optional<clipping::Window>& seen)
{
    const auto box = drawnBox(drawing);
    if (!seen || !box)
        return by;
    const Point least = box->min + by, most = box->max + by;
    const bool outside = most.x < seen->min.x || least.x > seen->max.x || most.y < seen->min.y
                         || least.y > seen->max.y;
    return outside ? (seen->min + seen->max) * 0.5 - (box->min + box->max) * 0.5 : by;
}

} // namespace

void duplicateInPlace(Session& session)
{
    if (session.selection().empty())
        return;
    const std::vector<RowChange> once{[](ObjectRow&) {}};
    pushCopies(session, withCopies(session.now(), session.selection(), session.entered.id(), once),
               Text::tr("Duplicate"));
}

void paste(Session& session, const Document& copied, PastePlace place,
           const std::optional<clipping::Window>& seen)
{
    if (!mayAddObjects(session)) {
        emit session.refused(
            Text::tr("The layer %1 is locked or hidden, so nothing was pasted. Select "
                     "another layer, or unlock and show this one.")
                .arg(nameForNew(session)));
        return;
    }
    const Document drawing = withNewImages(copied, session);
    if (!hasRoomFor(imageFilesOf(drawing.containers()), session.now().containers())) {
        emit session.refused(Text::tr("Nothing was pasted. %1").arg(imageRoomText()));
        return;
    }
    const Point step(stepMillimetres / session.now().page().millimetresPerUnit());
    const Point by =
        place == PastePlace::InPlace
            ? Point(0)
            : intoSight(drawing, copyOffset(session.now(), drawing.objects(), step), seen);
    pushCopies(session, withDrawing(session.now(), movedBy(drawing, by), containerForNew(session)),
               Text::tr("Paste"));
}

} // namespace app
