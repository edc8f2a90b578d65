// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editing/editing.h"

#include "app/commands/add_objects.h"
#include "app/commands/move_objects.h"
#include "app/commands/remove_objects.h"
#include "app/document/copy_place.h"
#include "app/document/editable.h"
#include "app/session/clipboard.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QMimeData>

namespace ui {

namespace {

// Offset of a copy from its original and from the previous copy.
constexpr double stepMillimetres = 5;

QString tr(const char* text) { return QCoreApplication::translate("Editing", text); }

/// Adds copies in one undo step, each to its container, offset from its original, and selects them.
void add(app::Session& session, std::vector<app::PendingObject> copies, const QString& text)
{
    const app::Document& document = session.now();
    app::Objects all;
    for (const app::PendingObject& copy : copies)
        all.append(copy.object);
    const app::Point step(stepMillimetres / document.page().millimetresPerUnit());
    const app::Placement where{{1, 1}, app::copyOffset(document, all, step)};
    for (auto& [object, into] : copies) {
        object.path = object.path.placed(where);
        object.particulars.id.clear(); // ids are unique
        object.particulars.recipe = placed(object.particulars.recipe, where);
    }
    app::Edit edit = app::adding(document, copies);
    app::ObjectRanges added = app::addedBy(edit.splices);
    session.history.push(new app::AddObjects(session.document, std::move(edit), text));
    session.select(std::move(added));
}

std::vector<app::PendingObject> selected(const app::Session& session)
{
    std::vector<app::PendingObject> copies;
    copies.reserve(session.selection().size());
    for (const std::size_t object : session.selection())
        copies.push_back({session.now().objects()[object].copy(),
                          session.now().containers().containerOf(object)});
    return copies;
}

} // namespace

void copySelection(const app::Session& session)
{
    if (!session.selection().empty())
        QGuiApplication::clipboard()->setMimeData(
            // The clipboard takes ownership.
            app::copied(session.now(), session.selection()).release());
}

void cutSelection(app::Session& session)
{
    if (session.selection().empty())
        return;
    copySelection(session);
    session.history.push(new app::RemoveObjects(session.document, session.selection(), tr("Cut")));
    session.select({});
}

QString nothingToPaste() { return tr("The clipboard holds no drawing. Copy lines first."); }

bool paste(app::Session& session)
{
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    const app::Objects objects = data ? app::pasted(*data, session.now().page()) : app::Objects();
    std::vector<app::PendingObject> copies;
    objects.forEach(0, objects.size(), [&](std::size_t, const app::ObjectView& object) {
        copies.push_back({object.copy(), session.pen.layer});
    });
    if (copies.empty())
        return false;
    add(session, std::move(copies), tr("Paste"));
    return true;
}

void duplicateSelection(app::Session& session)
{
    if (!session.selection().empty())
        add(session, selected(session), tr("Duplicate"));
}

void deleteSelection(app::Session& session)
{
    if (session.selection().empty())
        return;
    session.history.push(new app::RemoveObjects(session.document, session.selection()));
    session.select({});
}

void selectAll(app::Session& session) { session.select(app::editableObjects(session.now())); }

} // namespace ui
