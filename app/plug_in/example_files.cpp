// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/plug_in/example_files.h"

#include "app/formats/replace_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>

namespace app::plug_in {

QStringList exampleNames()
{
    return {QStringLiteral("clearcut_algorithm.h"), QStringLiteral("cohen_sutherland.c"),
            QStringLiteral("example.c")};
}

Result<QStringList> writeExample(const QString& folder)
{
    QStringList paths;
    for (const QString& name : exampleNames()) {
        QFile ours(QStringLiteral(":/plug_in/") + name);
        [[maybe_unused]] const bool there = ours.open(QIODevice::ReadOnly);
        const QByteArray text = ours.readAll();
        paths << QDir(folder).filePath(name);
        const auto error = replaceFile(paths.back(), [&](QIODevice& out) {
            return out.write(text) == text.size() ? std::nullopt : std::optional(out.errorString());
        });
        if (error)
            return Result<QStringList>::failure(
                QCoreApplication::translate("PlugIn", "Cannot write %1: %2")
                    .arg(paths.back(), *error));
    }
    return Result<QStringList>::of(paths);
}

} // namespace app::plug_in
