// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/variants.h"

#include "app/base/text.h"

namespace app {

using clipping::Clipped;
using clipping::Form;
using clipping::Segment;
using clipping::Window;

std::vector<Variant> variants()
{
    std::vector<Variant> all;
    for (const clipping::Algorithm& algorithm : clipping::algorithms())
        for (const Form form : {Form::Corrected, Form::Published})
            if (clipping::functionsOf(algorithm, form))
                all.push_back({&algorithm, form});
    for (const Misprint& misprint : misprints())
        all.push_back(variantOf(misprint));
    return all;
}

Variant exactVariant() { return {&clipping::exactAlgorithm(), Form::Corrected}; }

QString nameOf(const Variant& variant)
{
    if (variant.misprint)
        return variant.misprint->name;
    const clipping::Algorithm& row = *variant.algorithm;
    const QString name = latin(variant == exactVariant() ? row.key : row.abbreviation);
    return variant.form == Form::Corrected ? name : Text::tr("%1 as published").arg(name);
}

QString titleOf(const Variant& variant)
{
    if (variant.misprint)
        return variant.misprint->name;
    const QString both = latin(variant.algorithm->abbreviation) + QStringLiteral("  ")
                         + latin(variant.algorithm->name);
    return variant.form == Form::Corrected ? both : Text::tr("%1, as published").arg(both);
}

static const QString publishedSuffix = QStringLiteral(":published");

QString keyOf(const Variant& variant)
{
    if (variant.misprint)
        return variant.misprint->key;
    const QString key = latin(variant.algorithm->key);
    return variant.form == Form::Corrected ? key : key + publishedSuffix;
}

std::optional<Variant> findVariant(const QString& key)
{
    for (const Misprint& misprint : misprints())
        if (misprint.key == key)
            return variantOf(misprint);
    const bool published = key.endsWith(publishedSuffix);
    const QString name = published ? key.chopped(publishedSuffix.size()) : key;
    const auto* algorithm = clipping::findAlgorithm(name.toStdString());
    const Form form = published ? Form::Published : Form::Corrected;
    if (!algorithm || !clipping::functionsOf(*algorithm, form))
        return std::nullopt;
    return Variant{algorithm, form};
}

Variant variantOf(const Misprint& misprint) { return {misprint.meant, Form::Published, &misprint}; }

const clipping::Algorithm& rowOf(const Variant& variant)
{
    return variant.misprint ? variant.misprint->row : *variant.algorithm;
}

const clipping::Functions<Segment, Window>& functionsOf(const Variant& variant)
{
    return *clipping::functionsOf(rowOf(variant), variant.form);
}

std::size_t clipAll(const Variant& variant, std::span<const Segment> in, const Window& window,
                    std::span<Clipped> out)
{
    return functionsOf(variant).clipAll(in, window, out);
}

std::vector<Clipped> clipped(const Variant& variant, std::span<const Segment> in,
                             const Window& window)
{
    std::vector<Clipped> out(in.size());
    out.resize(clipAll(variant, in, window, out));
    return out;
}

std::optional<Segment> clipped(const Variant& variant, const Segment& line, const Window& window)
{
    Clipped piece{};
    if (clipAll(variant, {&line, 1}, window, {&piece, 1}) == 0)
        return std::nullopt;
    return piece.segment;
}

Ends endsOf(const Variant& one, const Variant& other)
{
    const bool both = one.form == Form::Corrected && other.form == Form::Corrected;
    return both ? Ends::InOrder : Ends::EitherWay;
}

double contractUlps(const Variant& one, const Variant& other)
{
    return one.algorithm->ulps + other.algorithm->ulps;
}

} // namespace app
