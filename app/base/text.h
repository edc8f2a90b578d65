// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include <string_view>

namespace app {

/// The program's texts, for translators: `Text::tr("Open")`. All are in this one context, so that a
/// word is translated once; where it has two meanings, the second argument tells them apart.
struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

/// A key or a name from a catalogue, as a QString.
inline QString latin(std::string_view text)
{
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

} // namespace app
