// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/library_file.h"

#include "app/base/text.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cstring>
#include <elf.h>

namespace app::plug_in {
namespace {

/// Quoted for a shell.
QString quoted(const QString& path)
{
    const auto isPlain = [](QChar c) {
        return (c.unicode() < 128 && c.isLetterOrNumber()) || QStringLiteral("/._-+").contains(c);
    };
    if (!path.startsWith(u'-') && std::ranges::all_of(path, isPlain))
        return path;
    QString inside = path;
    inside.replace(u'\'', QStringLiteral("'\\''"));
    return u'\'' + (path.startsWith(u'-') ? QStringLiteral("./") : QString()) + inside + u'\'';
}

/// One row of the catalogue of files from which a library is made.
struct Source {
    QStringList endings;
    QString name;    ///< the text after "is"
    QString command; ///< %1: the library, %2: the file
};

const std::vector<Source>& sources()
{
    static const std::vector<Source> all{
        {{"c"},
         Text::tr("C source code"),
         QStringLiteral("cc -std=c99 -O2 -shared -fPIC -o %1 %2 -lm")},
        {{"cpp", "cc", "cxx", "C", "c++"},
         Text::tr("C++ source code"),
         QStringLiteral("c++ -std=c++20 -O2 -shared -fPIC -o %1 %2")},
    };
    return all;
}

QString libraryBeside(const QFileInfo& file)
{
    return quoted(QDir(file.path()).filePath(file.completeBaseName() + QStringLiteral(".so")));
}

QString commandFor(const QString& command, const QFileInfo& file)
{
    return command.arg(libraryBeside(file), quoted(file.filePath()));
}

/// Without the header compilation would fail, so the command saves it first.
NoLibrary sourceCode(const Source& source, const QFileInfo& file)
{
    QString command = commandFor(source.command, file);
    if (!QFileInfo::exists(file.dir().filePath(QStringLiteral("clearcut_algorithm.h"))))
        command = QStringLiteral("clearcut judge --save-example %1 && ").arg(quoted(file.path()))
                  + command;
    return {Text::tr("%1 is %2: compile it first.").arg(file.filePath(), source.name), command};
}

NoLibrary textFile(const QFileInfo& file)
{
    for (const Source& source : sources())
        if (source.endings.contains(file.suffix()))
            return sourceCode(source, file);
    return {
        Text::tr(
            "%1 is a text file, not a shared library: give the .so file that your compiler wrote.")
            .arg(file.filePath())};
}

/// Rejects object files and programs with a fixed address, which cannot be loaded.
std::optional<NoLibrary> elfFile(const QByteArray& head, const QFileInfo& file)
{
    std::uint16_t type = ET_DYN;
    if (head.size() >= EI_NIDENT + qsizetype(sizeof type))
        std::memcpy(&type, head.constData() + EI_NIDENT, sizeof type);
    if (type == ET_REL)
        return NoLibrary{Text::tr("%1 is an object file: link it first; it must have been "
                                  "compiled with -fPIC.")
                             .arg(file.filePath()),
                         commandFor(QStringLiteral("cc -shared -o %1 %2 -lm"), file)};
    if (type == ET_EXEC)
        return NoLibrary{
            Text::tr("%1 is a program, not a shared library: compile it with -shared -fPIC.")
                .arg(file.filePath())};
    return std::nullopt;
}

} // namespace

std::optional<NoLibrary> whyNoLibrary(const QString& path)
{
    const QFileInfo file(path);
    QFile content(path);
    if (!content.open(QIODevice::ReadOnly))
        return std::nullopt;
    const QByteArray head = content.read(4096);
    if (head.isEmpty())
        return NoLibrary{Text::tr("%1 is empty: compile the library again.").arg(path)};
    if (head.startsWith(QByteArray(ELFMAG, SELFMAG)))
        return elfFile(head, file);
    if (head.startsWith("!<arch>\n"))
        return NoLibrary{Text::tr("%1 is a static library (an archive of object files): link a "
                                  "shared one from the same source with -shared -fPIC.")
                             .arg(path)};
    return head.contains('\0') ? std::nullopt : std::optional(textFile(file));
}

} // namespace app::plug_in
