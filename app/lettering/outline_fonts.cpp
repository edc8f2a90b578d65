// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/outline_fonts.h"

#include "app/lettering/stroke_fonts.h"

#include <QFontDatabase>
#include <QFontInfo>
#include <QGuiApplication>

#include <algorithm>

namespace app {
namespace {

QStringList installed()
{
    QStringList families;
    for (const QString& family : QFontDatabase::families())
        if (!QFontDatabase::isPrivateFamily(family) && QFontDatabase::isSmoothlyScalable(family)
            && !findStrokeFont(family))
            families << family;
    families.sort(Qt::CaseInsensitive);
    return families;
}

} // namespace

const QStringList& outlineFonts()
{
    static const QStringList none;
    if (!qobject_cast<const QGuiApplication*>(QCoreApplication::instance()))
        return none; // without it Qt ends the program
    static const QStringList families = installed();
    return families;
}

bool hasFont(const QString& name) { return findStrokeFont(name) || outlineFonts().contains(name); }

QString fontInsteadOf(const QString& name)
{
    const QStringList& fonts = outlineFonts();
    if (fonts.isEmpty())
        return strokeFonts().front().name;
    const QString nearest = QFontInfo(QFont(name)).family();
    return fonts.contains(nearest) ? nearest : fonts.front();
}

} // namespace app
