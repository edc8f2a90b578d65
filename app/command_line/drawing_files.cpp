// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/drawing_files.h"

#include "app/base/text.h"
#include "app/base/unfinished.h"
#include "app/command_line/command.h"
#include "app/command_line/terminal.h"
#include "app/document/flatten.h"
#include "app/formats/held.h"
#include "app/formats/loss_text.h"
#include "app/formats/map_edge.h"
#include "app/formats/read_open_file.h"
#include "app/formats/svg/colour.h"
#include "app/lettering/texts_as_strokes.h"
#include "app/nodes/join_lines.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cstdio>

namespace app {
namespace {

const QString standardStream = QStringLiteral("-");
constexpr quint64 mostDecimals = 30;

bool sameFile(const QString& a, const QString& b)
{
    const QString canonical = QFileInfo(a).canonicalFilePath();
    return !canonical.isEmpty() && QFileInfo(a).isFile()
           && canonical == QFileInfo(b).canonicalFilePath();
}

// The types that can be read, or written: "svg, csv".
template <class Function>
QString typesWith(Function Format::*can)
{
    QStringList keys;
    for (const Format& format : formats())
        if (format.*can)
            keys << QLatin1StringView(format.key);
    return keys.join(QStringLiteral(", "));
}

template <class Function>
const Format& drawingFormat(const ParsedArguments& arguments, const QString& option,
                            const QString& path, Function Format::*can, const Format* ofName)
{
    const Format* asked = arguments.format(option);
    const Format* format = asked ? asked : ofName;
    if (format && format->*can)
        return *format;
    const bool writes = option == QStringLiteral("to");
    const QString stream =
        writes ? Text::tr("-o - (standard output)") : Text::tr("- (standard input)");
    const QString type = asked
                             ? QString::fromLatin1(asked->key.data(), qsizetype(asked->key.size()))
                             : QFileInfo(path).suffix();
    const QString types = typesWith(can);
    if (path == standardStream && !asked)
        throw WrongUsage{
            Text::tr("%1: give its type with --%2 and one of %3.").arg(stream, option, types)};
    if (type.isEmpty())
        throw WrongUsage{Text::tr("%1: its name does not show its type. Give it with --%2 and "
                                  "one of %3.")
                             .arg(path, option, types)};
    throw WrongUsage{(writes ? Text::tr("%1: Clearcut does not write files of the type %2. It "
                                        "writes %3; --to says which if the name does not.")
                             : Text::tr("%1: Clearcut does not read files of the type %2. It "
                                        "reads %3; --from says which if the name does not."))
                         .arg(path == standardStream ? stream : path, type, types)};
}

std::optional<Unit> unitOf(const ParsedArguments& arguments)
{
    const QString option = QStringLiteral("unit");
    const auto text = arguments.text(option);
    if (!text)
        return std::nullopt;
    const auto unit = std::ranges::find(units(), text->toStdString(), &UnitInfo::suffix);
    if (unit == units().end() || !(unit->millimetres > 0))
        refuse({option, *text}, Text::tr("a unit such as mm, m or in"));
    return unit->unit;
}

QString projectionKeys(const QString& between)
{
    QStringList keys;
    for (const ProjectionKind& kind : projections())
        keys << latin(kind.key);
    return keys.join(between);
}

Projection projectionOf(const ParsedArguments& arguments)
{
    const QString option = QStringLiteral("projection");
    const auto text = arguments.text(option);
    if (!text)
        return projections().front().projection;
    const auto kind = std::ranges::find(projections(), text->toStdString(), &ProjectionKind::key);
    if (kind == projections().end())
        refuse({option, *text}, projectionKeys(Text::tr(" or ")));
    return kind->projection;
}

/// If none of the files can be a map.
void refuseProjection(const ParsedArguments& arguments, std::initializer_list<const Format*> files)
{
    const auto isMap = [](const Format* format) { return format->takes.projection; };
    if (arguments.has(QStringLiteral("projection")) && std::ranges::none_of(files, isMap))
        throw WrongUsage{Text::tr("--projection is for geojson maps. Leave out the option.")};
}

constexpr auto clipPaths = "clip-paths";

bool keepsClipPaths(const ParsedArguments& arguments)
{
    const QString option = QLatin1StringView(clipPaths);
    return arguments.knows(option) && arguments.choice(option, {"cut", "keep"}) == 1;
}

/// If one of the files has no clip paths.
void refuseKeptClipPaths(const ParsedArguments& arguments,
                         std::initializer_list<const Format*> files)
{
    const auto hasThem = [](const Format* format) { return format->takes.clipPaths; };
    if (keepsClipPaths(arguments) && !std::ranges::all_of(files, hasThem))
        throw WrongUsage{Text::tr("--clip-paths keep: only svg files have clip paths. Leave out "
                                  "the option, or read and write svg files.")};
}

ReadOptions readOptionsOf(const ParsedArguments& arguments)
{
    return {unitOf(arguments), projectionOf(arguments), keepsClipPaths(arguments)};
}

} // namespace

const Format& readFormatOf(const ParsedArguments& arguments, const QString& path)
{
    const bool there = QFileInfo::exists(path) && !QFileInfo(path).isDir();
    if (path != standardStream && !there) {
        const Format* const named = formatToRead(path);
        return named && named->read ? *named : formats()[0];
    }
    const Format& format =
        drawingFormat(arguments, QStringLiteral("from"), path, &Format::read, formatToRead(path));
    if (unitOf(arguments) && !format.takes.unit)
        throw WrongUsage{
            Text::tr("--unit: a file of type %1 is in its own unit. Leave out the option.")
                .arg(QLatin1StringView(format.key))};
    return format;
}

std::vector<Option> readingOptions()
{
    return {{{"from"},
             "TYPE",
             Text::tr("Type of the input (%1), if its name does not show it.")
                 .arg(typesWith(&Format::read))},
            {{"unit"},
             "UNIT",
             Text::tr("Unit of a dxf file that does not say it, or says it wrongly: mm, cm, m, in "
                      "or ft (mm).")},
            {{"projection"},
             projectionKeys(QStringLiteral("|")),
             Text::tr("How degrees of geojson maps become a plane, in the input and in the output "
                      "(plate-carree).")},
            {{"text"},
             "outlines|strokes",
             Text::tr("Letters of texts as outlines of their font (the default), or as single "
                      "strokes for plotters, in the same places.")}};
}

Option clipPathsOption()
{
    return {{clipPaths},
            "cut|keep",
            Text::tr("Clip paths of svg files: cut at them (the default), or write them again into "
                     "an svg file.")};
}

Option joinOption()
{
    return {{"join"},
            "LENGTH",
            Text::tr("Join lines of the same layer and style whose ends are no farther apart.")};
}

std::vector<Option> writingOptions()
{
    return {
        {{"o", "output"}, "FILE", Text::tr("Where to write; - is standard output.")},
        {{"to"},
         "TYPE",
         Text::tr("Type of the output (%1), if its name does not show it.")
             .arg(typesWith(&Format::write))},
        {{"in-place"}, {}, Text::tr("Overwrite the input.")},
        {{"precision"},
         "N",
         Text::tr(
             "Decimals of written coordinates, 0 to %1 (as many as are needed to read the same "
             "number back). Coordinates that rounding puts outside the window are moved into it; "
             "lines that it makes points are left out.")
             .arg(mostDecimals)},
        {{"dpi"}, "N", Text::tr("Pixels per inch of a picture (96).")},
        {{"background"},
         "COLOUR",
         Text::tr("What is behind the drawing: a name, #rrggbb, or none. Pictures are white, and "
                  "with none transparent; PDF files have none. Other "
                  "files cannot have one.")},
        {{"dxf"},
         "r2000|r12",
         Text::tr("Version of a DXF file (r2000). r12, for old programs and machines, has no "
                  "splines, true colours and line widths.")},
        {{"plain"},
         {},
         Text::tr("Write nothing but SVG into an svg file: texts, shapes and layers are drawn, but "
                  "no longer edited as such.")},
    };
}

Option toleranceOption()
{
    return {{"tolerance"},
            "LENGTH",
            Text::tr("Largest distance between a curve and the lines that replace it (0.05mm).")};
}

double toleranceOf(const ParsedArguments& arguments, const Page& page)
{
    const auto length = arguments.length(QStringLiteral("tolerance"));
    if (!length)
        return usualTolerance(page);
    const double tolerance = toUserUnits(*length, page.millimetresPerUnit());
    if (!(tolerance > 0))
        throw WrongUsage{Text::tr("--tolerance must be greater than 0.")};
    return tolerance;
}

void sayHiddenLeftOut(std::size_t count, const Format& format)
{
    if (count > 0)
        say(Text::tr("Hidden shapes: %1 left out; a file of type %2 cannot hide them.")
                .arg(count)
                .arg(QLatin1StringView(format.key)));
}

namespace {

template <class Chosen>
QStringList limitsOf(Chosen chosen)
{
    QStringList sentences;
    for (const Format& format : formats())
        if (!format.limits.isEmpty() && chosen(format))
            sentences
                << Text::tr("%1: at most %2.").arg(QLatin1StringView(format.key), format.limits);
    return sentences;
}

} // namespace

QStringList readingLimits()
{
    return limitsOf([](const Format& format) { return format.read != nullptr; });
}

QStringList readingAndWritingLimits()
{
    return limitsOf([](const Format&) { return true; });
}

static Imported readAs(const QString& path, const Format& format, const ReadOptions& options)
{
    auto imported = readFile(path, &format, options);
    if (!imported)
        throw Failure{imported.error};
    return std::move(*imported.value);
}

Imported readDrawing(const QString& path)
{
    const Format* format = formatToRead(path);
    return readAs(path, format ? *format : formats()[0], {});
}

// Lines that are joined have no rows of a table any more.
void joinAsAsked(const ParsedArguments& arguments, Imported& imported)
{
    const QString option = QStringLiteral("join");
    const auto distance = arguments.length(option);
    if (!distance)
        return;
    const double tolerance = toUserUnits(*distance, imported.document.page().millimetresPerUnit());
    if (!(tolerance >= 0))
        throw WrongUsage{Text::tr("--join must not be negative.")};
    if (joinLines(imported.document, tolerance) > 0)
        imported.rows.clear();
}

static Imported readAsItIs(const ParsedArguments& arguments, const QString& path)
{
    const Format& format = readFormatOf(arguments, path);
    if (!arguments.knows(QStringLiteral("output")))
        refuseProjection(arguments, {&format});
    if (path != standardStream)
        return readAs(path, format, readOptionsOf(arguments));
    QFile in;
    if (!in.open(stdin, QIODevice::ReadOnly))
        throw Failure{Text::tr("Cannot read standard input: %1.").arg(in.errorString())};
    auto imported = readOpenFile(in, format, readOptionsOf(arguments));
    if (!imported)
        throw Failure{Text::tr("Cannot read standard input: %1").arg(imported.error)};
    return std::move(*imported.value);
}

Imported readDrawing(const ParsedArguments& arguments, const QString& path)
{
    const bool strokes = arguments.choice(QStringLiteral("text"), {"outlines", "strokes"}) == 1;
    Imported imported = readAsItIs(arguments, path);
    if (strokes)
        imported.document.apply(textsAsStrokes(imported.document));
    return imported;
}

static std::optional<Colour> backgroundOf(const ParsedArguments& arguments, const Format& format)
{
    const QString option = QStringLiteral("background");
    const auto text = arguments.text(option);
    if (!text)
        return std::nullopt;
    if (!format.takes.background)
        throw WrongUsage{
            Text::tr("--background: a file of type %1 has no background. Leave out the "
                     "option, or write a png or pdf file.")
                .arg(QLatin1StringView(format.key))};
    const std::optional<Colour> colour = *text == QStringLiteral("none")
                                             ? Colour{255, 255, 255, 0}
                                             : svg::parseColour(text->toStdString());
    if (!colour)
        refuse({option, *text}, Text::tr("a colour such as #8a5a2b or teal, or none"));
    return colour;
}

Output outputOf(const ParsedArguments& arguments, const QString& input)
{
    const bool inPlace = arguments.has(QStringLiteral("in-place"));
    Output output{
        arguments.text(QStringLiteral("output")).value_or(inPlace ? input : QString()), {}, {}};
    if (output.path.isEmpty())
        throw WrongUsage{Text::tr("Name the output: -o FILE, or -o - for standard output.")};
    if (!inPlace && sameFile(output.path, input))
        throw WrongUsage{
            Text::tr("%1 is also the input. Give another name, or --in-place to overwrite it.")
                .arg(output.path)};
    output.format = &drawingFormat(arguments, QStringLiteral("to"), output.path, &Format::write,
                                   formatOfFile(output.path));
    if (const auto decimals = arguments.count(QStringLiteral("precision"), 0, mostDecimals))
        output.options.precision = int(*decimals);
    output.options.background = backgroundOf(arguments, *output.format);
    output.options.dxf = arguments.choice(QStringLiteral("dxf"), {"r2000", "r12"}) == 1
                             ? DxfVersion::R12
                             : DxfVersion::R2000;
    if (arguments.has(QStringLiteral("dxf")) && !output.format->takes.dxf)
        throw WrongUsage{Text::tr("--dxf: a file of type %1 is no DXF file. Leave out the option, "
                                  "or write a dxf file.")
                             .arg(QLatin1StringView(output.format->key))};
    output.options.projection = projectionOf(arguments);
    const Format& inputFormat = readFormatOf(arguments, input);
    refuseProjection(arguments, {output.format, &inputFormat});
    refuseKeptClipPaths(arguments, {output.format, &inputFormat});
    output.options.plain = arguments.has(QStringLiteral("plain"));
    if (output.options.plain && !output.format->takes.plain)
        throw WrongUsage{Text::tr("--plain: a file of type %1 is no SVG file. Leave out the "
                                  "option, or write an svg file.")
                             .arg(QLatin1StringView(output.format->key))};
    output.options.dpi = arguments.positive(QStringLiteral("dpi")).value_or(output.options.dpi);
    return output;
}

void sayPoints(std::size_t count)
{
    if (count > 0)
        say(Text::tr("Lines that --precision would make points are left out: %1.").arg(count));
}

void takePage(Output& output, const Imported& imported)
{
    output.options.paged = imported.paged;
    output.options.wholePage = imported.document.page().rectangle();
}

void sayNotHeld(const Document& document, const ObjectRanges& objects, const Output& output)
{
    if (output.format->holds != Holds::Outlines && output.format->holds != Holds::Polygons)
        return;
    for (const QString& loss : lossesOf(document, objects, *output.format, output.options))
        say(loss + u'.');
}

void sayOutsideMap(const Document& written, const Output& output)
{
    for (const QString& sentence : outsideMap(written, *output.format, output.options))
        say(sentence + u'.');
}

void writeDrawing(const Document& document, const Output& output)
{
    if (output.path != standardStream) {
        const Unfinished guard(output.path);
        if (const auto error = writeFile(document, output.path, output.options, output.format))
            throw Failure{*error};
        return;
    }
    printWith([&](QIODevice& out) { return output.format->write(document, out, output.options); });
}

void writeWith(const Filling& write, const QString& path)
{
    if (path == standardStream)
        return printAtOnce(write);
    const Unfinished guard(path);
    if (const auto error = replaceFile(path, write))
        throw Failure{Text::tr("Cannot write %1: %2").arg(path, *error)};
}

QStringList losses(const std::vector<Loss>& report)
{
    QStringList lines;
    for (const Loss& loss : report) {
        QStringList more;
        if (!loss.remark)
            more << Text::tr("not kept");
        for (const QString& text : {loss.remark ? QString() : loss.instead, whereText(loss)})
            if (!text.isEmpty())
                more << text;
        const QString text = QStringLiteral("%1 × %2").arg(loss.count).arg(loss.what);
        lines << (more.isEmpty() ? text : Text::tr("%1 (%2)").arg(text, more.join(Text::tr("; "))));
    }
    return lines;
}

void refuseLossInPlace(const ParsedArguments& arguments, const Imported& imported,
                       const QString& input, const Output& output)
{
    if (mustSaveAs(imported.report) && arguments.has(QStringLiteral("in-place"))
        && sameFile(output.path, input))
        throw Failure{Text::tr("Cannot overwrite %1: it has content that would be lost (%2). "
                               "Give another name with -o.")
                          .arg(input, losses(imported.report).join(QStringLiteral(", ")))};
}

void sayLosses(const std::vector<Loss>& report)
{
    const QStringList lost = losses(report);
    for (const QString& line : lost)
        say(line);
}

} // namespace app
