// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/example_files.h"

#include "app/base/replace_file.h"
#include "app/base/text.h"

#include <QDir>
#include <QFile>

namespace app::plug_in {
namespace {

QByteArray ours(const QString& name)
{
    QFile file(QStringLiteral(":/plug_in/") + name);
    [[maybe_unused]] const bool there = file.open(QIODevice::ReadOnly);
    return file.readAll();
}

bool differs(const QString& path, const QByteArray& text)
{
    QFile file(path);
    return file.exists() && (!file.open(QIODevice::ReadOnly) || file.readAll() != text);
}

} // namespace

QStringList exampleNames()
{
    return {QStringLiteral("clearcut_algorithm.h"), QStringLiteral("skeleton.c"),
            QStringLiteral("cohen_sutherland.c"), QStringLiteral("example.c")};
}

Result<WrittenExample> writeExample(const QString& folder, Existing existing)
{
    WrittenExample all;
    for (const QString& name : exampleNames()) {
        const QByteArray text = ours(name);
        const QString path = QDir(folder).filePath(name);
        if (existing == Existing::Keep && differs(path, text)) {
            all.kept << path;
            continue;
        }
        const auto error = replaceFile(path, [&](QIODevice& out) {
            return out.write(text) == text.size() ? std::nullopt
                                                  : std::optional(out.errorString() + u'.');
        });
        if (error)
            return Result<WrittenExample>::failure(
                Text::tr("Cannot write %1: %2").arg(path, *error));
        all.written << path;
    }
    return Result<WrittenExample>::of(all);
}

} // namespace app::plug_in
