// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editing/undo_memory.h"

#include "app/commands/history.h"
#include "app/settings/remembered.h"

#include <QSettings>

namespace ui {

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
