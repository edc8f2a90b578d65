// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/editor_application.h"

#include "ui/look/text.h"
#include "ui/window/main_window.h"

#include <QScopedValueRollback>
#include <QUnhandledException>

#include <cstdio>
#include <new>

namespace ui {
namespace {

/// Whether work in the background, which passes its exceptions on, ran out of memory.
bool isTooLittleMemory(const QUnhandledException& passedOn)
{
    try {
        if (passedOn.exception())
            std::rethrow_exception(passedOn.exception());
    } catch (const std::bad_alloc&) {
        return true;
    } catch (...) {
    }
    return false;
}

} // namespace

// Qt passes exceptions on, but not through the loop of events. All that was done before is undone
// by those who did it: an edit, for example, is done or not (app/document/edited_document.h).
bool EditorApplication::notify(QObject* receiver, QEvent* event)
{
    const auto revision = [this] { return window_ ? window_->session().document.revision() : 0; };
    const std::uint64_t before = revision();
    try {
        return QApplication::notify(receiver, event);
    } catch (const std::bad_alloc&) {
    } catch (const QUnhandledException& passedOn) {
        if (!isTooLittleMemory(passedOn))
            throw;
    }
    sayTooLittle(revision() != before);
    return true;
}

void EditorApplication::sayTooLittle(bool changed) noexcept
{
    if (saying_)
        return;
    const QScopedValueRollback saying(saying_, true);
    try {
        const QString sentence =
            changed
                ? Text::tr(
                    "The step was done, but there is not enough memory to show all of it. Save "
                    "the drawing, and close other programs.")
                : Text::tr("There is not enough memory for this, and the drawing was not changed. "
                           "Select less, or close other programs.");
        if (window_ && window_->message() != sentence) // otherwise painting it might go on for ever
            window_->tell({Message::Kind::Warning, sentence});
    } catch (const std::bad_alloc&) {
        std::fputs("clearcut: There is not enough memory.\n", stderr);
    }
}

} // namespace ui

#include "moc_editor_application.cpp"
