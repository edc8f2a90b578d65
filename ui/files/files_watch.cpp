// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/files.h"
#include "ui/look/text.h"

#include <QFileInfo>

// What other programs do to the open drawing's file.

namespace ui {

void Files::watchFile()
{
    connect(&watch_, &app::FileWatch::changed, this, [this] {
        emit told(
            {Message::Kind::Warning,
             Text::tr("Another program changed %1. After reloading it, the steps so far cannot be "
                      "undone.")
                 .arg(name()),
             Text::tr("Reload file"), [this] { reload(); }});
    });
    // The drawing is only in this program now: closing it has to ask.
    connect(&watch_, &app::FileWatch::removed, this, [this] {
        session_.history.resetClean();
        emit told({Message::Kind::Warning,
                   Text::tr("%1 was deleted or moved. Save the drawing to keep it.").arg(name()),
                   Text::tr("Save drawing"), [this] { save(); }});
    });
}

void Files::reload()
{
    background_.inTurn([this, path = session_.path()](const Turn& turn) {
        using Changed = Questions::ChangedFile;
        emit documentWanted();
        const auto answer =
            session_.history.isClean() ? Changed::Reload : questions_->aboutChangedFile(path);
        if (answer == Changed::Reload)
            read(path, turn);
        else if (answer == Changed::Overwrite)
            write(path, [turn](bool) {});
        else
            emit watch_.changed(); // it is still so
    });
}

} // namespace ui
