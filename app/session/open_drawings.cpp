// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/open_drawings.h"

#include "app/settings/remembered.h"

namespace app {

namespace {

const QString filesKey = QStringLiteral("drawings/open"),
              shownKey = QStringLiteral("drawings/shown"),
              reopensKey = QStringLiteral("drawings/reopen");

} // namespace

OpenDrawings openDrawings(const QSettings& settings, int most)
{
    OpenDrawings drawings;
    if (!reopensDrawings(settings))
        return drawings;
    const QString shown = settings.value(shownKey).toString();
    for (const QString& path : settings.value(filesKey).toStringList())
        if (drawings.files.size() < most && isUsablePath(path) && !drawings.files.contains(path)) {
            if (path == shown)
                drawings.shown = int(drawings.files.size());
            drawings.files << path;
        }
    return drawings;
}

void keepOpenDrawings(QSettings& settings, const OpenDrawings& drawings)
{
    settings.setValue(filesKey, drawings.files);
    settings.setValue(shownKey, drawings.files.value(drawings.shown));
}

bool reopensDrawings(const QSettings& settings)
{
    return settings.value(reopensKey, true).toBool();
}

void setReopensDrawings(QSettings& settings, bool on)
{
    settings.setValue(reopensKey, on);
    if (!on)
        for (const QString& key : {filesKey, shownKey})
            settings.remove(key);
}

} // namespace app
