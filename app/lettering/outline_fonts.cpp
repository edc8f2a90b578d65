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

FontFace faceOf(const QString& family, const FontFace& wanted)
{
    if (!outlineFonts().contains(family))
        return {};
    const QStringList styles = QFontDatabase::styles(family);
    for (const FontFace& face :
         {wanted, FontFace{wanted.bold, false}, FontFace{false, wanted.italic}})
        if (std::ranges::any_of(styles, [&](const QString& style) {
                return QFontDatabase::bold(family, style) == face.bold
                       && QFontDatabase::italic(family, style) == face.italic;
            }))
            return face;
    return {};
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
