// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/remembered_choice.h"

#include "app/base/number.h"
#include "app/base/text.h"
#include "app/formats/svg/colour.h"

#include <QFileInfo>

#include <algorithm>
#include <array>

namespace app {
namespace {

constexpr qsizetype longestPath = 4096; // characters
constexpr qsizetype mostDrawings = 20;  // whose exports are remembered
constexpr double mostDecimals = 12;
const QString choicesKey = QStringLiteral("export/choices");
const QString drawingsKey = QStringLiteral("export/drawings");

std::optional<double> numberIn(const QString& text, double least, double most)
{
    const auto number = parseNumber(text.toStdString());
    return number && *number >= least && *number <= most ? number : std::nullopt;
}

/// How a member of the choice is written and read.
struct Member {
    std::string_view key;
    QString (*text)(const ExportChoice& choice);
    void (*take)(const QString& text, ExportChoice& choice);
};

const std::array members{
    Member{"area",
           [](const ExportChoice& choice) {
               return latin(exportParts()[std::size_t(choice.area.part)].key);
           },
           [](const QString& text, ExportChoice& choice) {
               for (const ExportPartInfo& info : exportParts())
                   if (text == latin(info.key))
                       choice.area.part = info.part;
           }},
    Member{"paper",
           [](const ExportChoice& choice) {
               return choice.paper == ExportPaper::Page ? QStringLiteral("page")
                                                        : QStringLiteral("area");
           },
           [](const QString& text, ExportChoice& choice) {
               choice.paper =
                   text == QStringLiteral("page") ? ExportPaper::Page : ExportPaper::Area;
           }},
    Member{"dpi", [](const ExportChoice& choice) { return shortestText(choice.dpi); },
           [](const QString& text, ExportChoice& choice) {
               choice.dpi = numberIn(text, leastDpi, mostDpi).value_or(choice.dpi);
           }},
    Member{"precision",
           [](const ExportChoice& choice) { return QString::number(choice.precision); },
           [](const QString& text, ExportChoice& choice) {
               choice.precision = int(numberIn(text, -1, mostDecimals).value_or(-1));
           }},
    Member{"background",
           [](const ExportChoice& choice) {
               return choice.background
                          ? QString::fromStdString(svg::hexOf(*choice.background)).mid(1)
                          : QStringLiteral("usual");
           },
           [](const QString& text, ExportChoice& choice) {
               choice.background = svg::parseColour('#' + text.toStdString());
           }},
    Member{"dxf",
           [](const ExportChoice& choice) {
               return choice.dxf == DxfVersion::R12 ? QStringLiteral("r12")
                                                    : QStringLiteral("r2000");
           },
           [](const QString& text, ExportChoice& choice) {
               choice.dxf = text == QStringLiteral("r12") ? DxfVersion::R12 : DxfVersion::R2000;
           }},
    Member{"svg",
           [](const ExportChoice& choice) {
               return choice.plain ? QStringLiteral("plain") : QStringLiteral("clearcut");
           },
           [](const QString& text, ExportChoice& choice) {
               choice.plain = text == QStringLiteral("plain");
           }},
    Member{"projection",
           [](const ExportChoice& choice) { return latin(kindOf(choice.projection).key); },
           [](const QString& text, ExportChoice& choice) {
               for (const ProjectionKind& kind : projections())
                   if (text == latin(kind.key))
                       choice.projection = kind.projection;
           }},
};

QString field(const QString& text, int number) { return text.section(u'\t', number, number); }

bool isUsablePath(const QString& path)
{
    return path.size() <= longestPath && QFileInfo(path).isAbsolute()
           && std::ranges::none_of(path,
                                   [](QChar c) { return c.category() == QChar::Other_Control; });
}

} // namespace

QString textOf(const ExportChoice& choice)
{
    QStringList words{latin(choice.format)};
    for (const Member& member : members)
        words << latin(member.key) + u'=' + member.text(choice);
    return words.join(u' ');
}

std::optional<ExportChoice> choiceOf(const QString& text)
{
    const QStringList words = text.split(u' ');
    const Format* format = findFormat(words.front());
    if (!format || !format->write)
        return std::nullopt;
    ExportChoice choice{.format = std::string(format->key)};
    for (const QString& word : words)
        for (const Member& member : members)
            if (word.section(u'=', 0, 0) == latin(member.key))
                member.take(word.section(u'=', 1), choice);
    return choice;
}

std::optional<DrawingExport> lastExport(const QSettings& settings, const QString& drawing)
{
    if (drawing.isEmpty())
        return std::nullopt;
    for (const QString& text : settings.value(drawingsKey).toStringList().mid(0, mostDrawings)) {
        if (field(text, 0) != drawing || !isUsablePath(field(text, 1)))
            continue;
        if (const auto choice = choiceOf(field(text, 2)))
            return DrawingExport{drawing, field(text, 1), *choice};
    }
    return std::nullopt;
}

ExportChoice lastChoice(const QSettings& settings, std::string_view format)
{
    for (const QString& text : settings.value(choicesKey).toStringList().mid(0, mostDrawings))
        if (const auto choice = choiceOf(text); choice && choice->format == format)
            return *choice;
    return {.format = std::string(format)};
}

std::string lastFormat(const QSettings& settings)
{
    const QStringList texts = settings.value(choicesKey).toStringList();
    const auto choice = texts.isEmpty() ? std::nullopt : choiceOf(texts.front());
    return choice ? choice->format : std::string(exportFormats().front()->key);
}

void remember(QSettings& settings, const DrawingExport& made)
{
    QStringList choices{textOf(made.choice)};
    for (const Format* format : exportFormats())
        if (format->key != made.choice.format)
            choices << textOf(lastChoice(settings, format->key));
    settings.setValue(choicesKey, choices);
    if (!isUsablePath(made.drawing) || !isUsablePath(made.file))
        return;
    QStringList drawings{made.drawing + u'\t' + made.file + u'\t' + choices.front()};
    for (const QString& text : settings.value(drawingsKey).toStringList().mid(0, mostDrawings))
        if (field(text, 0) != made.drawing && drawings.size() < mostDrawings)
            drawings << text;
    settings.setValue(drawingsKey, drawings);
}

} // namespace app
