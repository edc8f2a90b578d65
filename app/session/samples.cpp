// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/samples.h"

#include "app/base/text.h"

#include <QFile>

namespace app {

std::vector<Sample> samples()
{
    QFile index(QStringLiteral(":/samples/index.txt"));
    std::vector<Sample> all;
    if (!index.open(QIODevice::ReadOnly))
        return all;
    index.readLine(); // the header
    while (!index.atEnd()) {
        const QStringList fields = QString::fromUtf8(index.readLine()).trimmed().split(u'\t');
        if (fields.size() >= 3)
            all.push_back({fields[0], Text::tr(fields[1].toUtf8().constData()),
                           QStringLiteral(":/samples/") + fields[2]});
    }
    return all;
}

QImage samplePicture(const QString& file, const QSize& points, double pixelRatio,
                     const ThumbnailColours& colours)
{
    const auto imported = readFile(file);
    return imported ? thumbnail(imported.value->document, points, pixelRatio, colours) : QImage();
}

bool isUnchangedSample(const QString& key, const Document& document)
{
    for (const Sample& sample : samples())
        if (sample.key == key)
            if (const auto fresh = readFile(sample.file)) {
                Document known = fresh.value->document;
                known.apply({.windows = document.windows()});
                return known == document;
            }
    return false;
}

} // namespace app
