// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/clipper.h"

#include "app/latin.h"

#include <QCoreApplication>

namespace app {

using clipping::Clipped;
using clipping::Form;
using clipping::Segment;
using clipping::Window;

std::vector<Clipper> clippers()
{
    std::vector<Clipper> all;
    for (const clipping::Algorithm& algorithm : clipping::algorithms())
        for (const Form form : {Form::Corrected, Form::Published})
            if (clipping::usesOf(algorithm, form))
                all.push_back({&algorithm, form});
    for (const Exhibit& exhibit : exhibits())
        all.push_back({exhibit.meant, Form::Published, &exhibit});
    return all;
}

Clipper exactClipper() { return {&clipping::exactAlgorithm(), Form::Corrected}; }

QString nameOf(const Clipper& clipper)
{
    if (clipper.exhibit)
        return clipper.exhibit->name;
    const clipping::Algorithm& row = *clipper.algorithm;
    const QString name = latin(clipper == exactClipper() ? row.key : row.abbreviation);
    return clipper.form == Form::Corrected
               ? name
               : QCoreApplication::translate("Clipper", "%1 as published").arg(name);
}

QString titleOf(const Clipper& clipper)
{
    if (clipper.exhibit)
        return clipper.exhibit->name;
    const QString both = latin(clipper.algorithm->abbreviation) + QStringLiteral("  ")
                         + latin(clipper.algorithm->name);
    return clipper.form == Form::Corrected
               ? both
               : QCoreApplication::translate("Clipper", "%1, as published").arg(both);
}

static const QString publishedSuffix = QStringLiteral(":published");

QString keyOf(const Clipper& clipper)
{
    if (clipper.exhibit)
        return clipper.exhibit->key;
    const QString key = latin(clipper.algorithm->key);
    return clipper.form == Form::Corrected ? key : key + publishedSuffix;
}

std::optional<Clipper> findClipper(const QString& key)
{
    for (const Exhibit& exhibit : exhibits())
        if (exhibit.key == key)
            return Clipper{exhibit.meant, Form::Published, &exhibit};
    const bool published = key.endsWith(publishedSuffix);
    const QString name = published ? key.chopped(publishedSuffix.size()) : key;
    const auto* algorithm = clipping::findAlgorithm(name.toStdString());
    const Form form = published ? Form::Published : Form::Corrected;
    if (!algorithm || !clipping::usesOf(*algorithm, form))
        return std::nullopt;
    return Clipper{algorithm, form};
}

std::size_t clipAll(const Clipper& clipper, std::span<const Segment> in, const Window& window,
                    std::span<Clipped> out)
{
    return clipper.exhibit
               ? clipper.exhibit->clipAll(in, window, out)
               : clipping::usesOf(*clipper.algorithm, clipper.form)->clipAll(in, window, out);
}

std::vector<Clipped> clipped(const Clipper& clipper, std::span<const Segment> in,
                             const Window& window)
{
    std::vector<Clipped> out(in.size());
    out.resize(clipAll(clipper, in, window, out));
    return out;
}

std::optional<Segment> clipped(const Clipper& clipper, const Segment& line, const Window& window)
{
    Clipped piece{};
    if (clipAll(clipper, {&line, 1}, window, {&piece, 1}) == 0)
        return std::nullopt;
    return piece.segment;
}

Ends endsOf(const Clipper& one, const Clipper& other)
{
    const bool both = one.form == Form::Corrected && other.form == Form::Corrected;
    return both ? Ends::InOrder : Ends::EitherWay;
}

double contractUlps(const Clipper& one, const Clipper& other)
{
    return one.algorithm->ulps + other.algorithm->ulps;
}

} // namespace app
