// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/replace_file.h"
#include "app/base/text.h"

#include <QFileInfo>
#include <QStringList>

#include <algorithm>
#include <span>
#include <type_traits>

namespace app {

/// A type of file in which something is written: a row of a list of them.
template <class... Content>
struct FileKind {
    std::string_view key; ///< "svg": the file name's ending
    QString name;         ///< "SVG drawing", translated
    /// Empty, or why it failed.
    std::optional<QString> (*write)(const Content&... content, QIODevice& out);
};

/// The row of a key or ending, in any case; null: there is none. All kinds of files have a `key`.
template <class Kinds>
const auto* kindOf(const Kinds& kinds, QStringView key)
{
    const auto found = std::ranges::find_if(kinds, [&](const auto& kind) {
        return key.compare(latin(kind.key), Qt::CaseInsensitive) == 0;
    });
    return found == kinds.end() ? nullptr : &*found;
}

/// ".svg, .pdf or .png".
template <class Kinds>
QString endingsOf(const Kinds& kinds)
{
    QStringList endings;
    for (const auto& kind : kinds)
        endings << u'.' + latin(kind.key);
    const QString last = endings.takeLast();
    return endings.isEmpty() ? last : endings.join(QStringLiteral(", ")) + Text::tr(" or ") + last;
}

/// Writes a file of the kind that its ending says; replaces an existing file only by a complete new
/// one. Empty, or a sentence that names the file and says what to do.
template <class... Content>
std::optional<QString> writeAs(std::span<const FileKind<Content...>> kinds, const QString& path,
                               const std::type_identity_t<Content>&... content)
{
    const auto failure = [&](const QString& why) {
        return Text::tr("Cannot write %1: %2").arg(path, why);
    };
    const auto* kind = kindOf(kinds, QFileInfo(path).suffix());
    if (!kind)
        return failure(Text::tr("end its name with %1.").arg(endingsOf(kinds)));
    const auto error =
        replaceFile(path, [&](QIODevice& out) { return kind->write(content..., out); });
    return error ? std::optional(failure(*error)) : std::nullopt;
}

} // namespace app
