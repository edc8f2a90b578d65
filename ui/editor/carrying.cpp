// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/carrying.h"

#include "app/commands/add_and_remove.h"
#include "app/formats/loss_text.h"
#include "app/session/clipboard.h"
#include "app/session/copy_selection.h"
#include "ui/files/files.h"
#include "ui/look/text.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QDrag>
#include <QPointer>

namespace ui {
namespace {

std::unique_ptr<QMimeData> selected(const app::Session& session)
{
    return app::copied(session.now(), session.selection(), session.entered.id());
}

} // namespace

void giveSelection(MainWindow& from, MainWindow& to, Leaves leaves)
{
    const std::shared_ptr<QMimeData> data = selected(from.session());
    const auto step = from.session().document.revision();
    to.files().whenIdle([from = QPointer(&from), &to, data, leaves, step] {
        app::Session& target = to.session();
        const std::size_t before = target.now().objects().size();
        const app::Pasted given = app::pasted(*data, target.now().page());
        app::paste(target, given.drawing, app::PastePlace::InPlace);
        const bool isGiven = target.now().objects().size() > before;
        if (const QString lost = app::lossSentence(given.losses); isGiven && !lost.isEmpty())
            to.tell({Message::Kind::Warning, lost});
        if (leaves == Leaves::No || !isGiven || !from
            || from->session().document.revision() != step)
            return;
        app::Session& giver = from->session();
        giver.history.push(new app::RemoveObjects(giver.document, giver.selection(),
                                                  Text::tr("Move to %1").arg(to.files().name())));
        giver.select({});
    });
}

void dragOut(MainWindow& from)
{
    // Asked for at each move of the pointer: it was released meanwhile, or is dragged already.
    if (QApplication::mouseButtons() != Qt::LeftButton || from.findChild<QDrag*>())
        return;
    from.canvas().cancelGesture();
    auto* drag = new QDrag(&from);
    drag->setMimeData(selected(from.session()).release());
    drag->exec(Qt::CopyAction);
}

} // namespace ui
