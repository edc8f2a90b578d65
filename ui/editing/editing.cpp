// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editing/editing.h"

#include "app/commands/add_and_remove.h"
#include "app/commands/history.h"
#include "app/formats/loss_text.h"
#include "app/session/clipboard.h"
#include "app/session/selection_style.h"
#include "app/session/units.h"
#include "app/settings/remembered.h"
#include "ui/look/text.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>
#include <QSettings>

namespace ui {

void copySelection(const app::Session& session)
{
    if (!session.selection().empty())
        QGuiApplication::clipboard()->setMimeData(
            // The clipboard takes ownership.
            app::copied(session.now(), session.selection(), session.entered.id()).release());
}

void cutSelection(app::Session& session)
{
    if (session.selection().empty())
        return;
    copySelection(session);
    session.history.push(
        new app::RemoveObjects(session.document, session.selection(), Text::tr("Cut")));
    session.select({});
}

bool canPaste(const QMimeData& data)
{
    return data.hasFormat(QStringLiteral("image/svg+xml")) || data.hasText()
           || app::offersImage(data);
}

QString paste(app::Session& session, const QMimeData* data, app::PastePlace place,
              app::PastedText text, app::ImagePlacing& placing,
              const std::optional<clipping::Window>& seen)
{
    const app::Pasted pasted = data ? app::pasted(*data, session.now().page()) : app::Pasted();
    const QString lost = app::lossSentence(pasted.losses);
    if (pasted.holdsDrawing()) {
        const auto before = session.document.revision();
        app::paste(session, pasted.drawing, place, seen);
        return session.document.revision() == before ? QString() : lost;
    }
    if (!pasted.fault.isEmpty())
        return Text::tr("The drawing on the clipboard cannot be read: %1").arg(pasted.fault);
    if (!lost.isEmpty())
        return Text::tr("%1 Nothing was pasted.").arg(lost);
    text.text = data ? data->text() : QString();
    if (text.text.trimmed().isEmpty()) {
        if (!data || !app::offersImage(*data))
            return Text::tr("The clipboard holds no drawing, no text and no image. Copy lines "
                            "first.");
        placing.place(*data);
        return {};
    }
    const auto written = app::drawingOf(session, text);
    if (written)
        app::paste(session, *written.value, app::PastePlace::InPlace);
    return written.error;
}

void deleteSelection(app::Session& session)
{
    if (session.selection().empty())
        return;
    session.history.push(new app::RemoveObjects(session.document, session.selection()));
    session.select({});
}

void selectAll(app::Session& session) { session.select(app::selectableObjects(session)); }

namespace {

std::optional<app::CopiedStyle>& copied()
{
    static std::optional<app::CopiedStyle> copied;
    return copied;
}

} // namespace

void copyStyle(const app::Session& session) { copied() = app::copiedStyle(session); }

bool hasCopiedStyle() { return copied().has_value(); }

void pasteStyle(app::Session& session)
{
    if (copied())
        app::pasteStyle(session, *copied());
}

namespace {

QString key() { return QStringLiteral("undoMegabytes"); }

} // namespace

int undoMegabytes()
{
    constexpr int least = 1, most = 1'000'000;
    return app::rememberedNumber(key(), least, most, int(app::History::usualLimit / bytesOf(1)));
}

void setUndoMegabytes(int megabytes) { QSettings().setValue(key(), megabytes); }

} // namespace ui
