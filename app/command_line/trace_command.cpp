// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/base/variant.h"
#include "app/command_line/command.h"
#include "app/command_line/parsed_arguments.h"
#include "app/command_line/terminal.h"
#include "app/command_line/window_forms.h"
#include "app/document/window_shape.h"
#include "app/scene/region.h"
#include "app/teaching/trace_file.h"

#include <QDir>
#include <QFileInfo>

#include <glm/trigonometric.hpp>

#include <cmath>

namespace app {
namespace {

constexpr quint64 leastWidth = 64, mostWidth = 8192;

/// The paper's window, the default.
constexpr clipping::Window usualWindow{{-100, -75}, {100, 75}};

QStringList formatKeys()
{
    QStringList keys;
    for (const TraceFormat& format : traceFormats())
        keys << latin(format.key);
    return keys;
}

/// A window without a drawing: a circle or convex polygon in the line's coordinates.
void takePolygon(const GivenValue& value, TracedLine& tracedLine)
{
    const QString form = value.text.section(u':', 0, 0);
    if (form != u"circle" && form != u"polygon")
        throw WrongUsage{Text::tr("--window %1: steps are shown at rectangles, circle:… and "
                                  "polygon:… only.")
                             .arg(value.text)};
    const ClipRegion region = regionOf({windowsOf(value, {})}, Page{});
    const ClipRegion::Step& step = region.steps.front();
    if (step.polygon.corners.empty())
        throw WrongUsage{Text::tr("--window %1: this polygon is not convex. Steps are shown at "
                                  "rectangles and convex polygons only.")
                             .arg(value.text)};
    tracedLine.corners = step.polygon.corners;
    tracedLine.window = step.box;
}

// XMIN,YMIN,XMAX,YMAX[@DEGREES], counterclockwise as seen.
WindowFrame frameOf(const GivenValue& value, YAxis y)
{
    const QString edges = QStringLiteral("XMIN,YMIN,XMAX,YMAX");
    const QStringList parts = value.text.split(u'@');
    bool isAngle = true;
    const double degrees = parts.size() < 2 ? 0 : parts[1].trimmed().toDouble(&isAngle);
    if (parts.size() > 2 || !isAngle || !std::isfinite(degrees))
        refuse(value, Text::tr("a rectangle %1, and @DEGREES after it to rotate it").arg(edges));
    const auto [xmin, ymin, xmax, ymax] = fourNumbers(value, parts.front(), edges);
    const double angle = glm::radians(std::remainder(degrees, 360));
    const RectangleShape box{{{xmin, ymin}, {xmax, ymax}}};
    return std::get<RectangleShape>(rotated(box, y == YAxis::Up ? angle : -angle));
}

void takeTracedWindow(const GivenValue& value, TracedLine& tracedLine)
{
    if (value.text.contains(u':'))
        return takePolygon(value, tracedLine);
    const WindowFrame frame = frameOf(value, tracedLine.y);
    tracedLine.window = frame.box;
    tracedLine.line = {intoFrame(frame, tracedLine.line.a), intoFrame(frame, tracedLine.line.b)};
    if (frame.angle != 0)
        say(Text::tr("The window is rotated: the line and its steps are in the window's own "
                     "directions, turned about its centre."));
}

TracedLine tracedLineOf(const ParsedArguments& arguments)
{
    const auto line = arguments.numbers(QStringLiteral("line"), QStringLiteral("X1,Y1,X2,Y2"));
    if (!line)
        throw WrongUsage{Text::tr("Give the line with --line X1,Y1,X2,Y2.")};
    const auto& [x1, y1, x2, y2] = *line;
    TracedLine tracedLine{
        .variant =
            arguments.variant(QStringLiteral("algorithm")).value_or(Variant{&usualAlgorithm()}),
        .line = {{x1, y1}, {x2, y2}},
        .window = usualWindow,
        .y = arguments.choice(QStringLiteral("y-axis"), {"up", "down"}) == 0 ? YAxis::Up
                                                                             : YAxis::Down,
        .origin = {}};
    if (const auto text = arguments.text(QStringLiteral("window")))
        takeTracedWindow({QStringLiteral("window"), *text}, tracedLine);
    return tracedLine;
}

TraceExport exportOf(const ParsedArguments& arguments)
{
    TraceExport trace{.tracedLine = tracedLineOf(arguments), .narration = {}};
    trace.narration = narrationOf(trace.tracedLine);
    if (!trace.narration.refusal.isEmpty())
        throw WrongUsage{trace.narration.refusal};
    if (const auto step = arguments.count(QStringLiteral("step"), 1, trace.narration.steps.size()))
        trace.only = *step - 1;
    if (arguments.choice(QStringLiteral("theme"), {"light", "dark"}) == 1)
        trace.ground = Ground::Dark;
    if (arguments.has(QStringLiteral("picture-only")))
        trace.parts = SlideParts::Picture;
    if (const auto width = arguments.count(QStringLiteral("width"), leastWidth, mostWidth))
        trace.scale = double(*width) / slideWidth;
    return trace;
}

/// The format of --format, or of the name's ending; text by default.
const TraceFormat& traceFormat(const ParsedArguments& arguments, const QString& output)
{
    if (arguments.has(QStringLiteral("format")))
        return *findTraceFormat(
            formatKeys()[qsizetype(arguments.choice(QStringLiteral("format"), formatKeys()))]);
    const QString ending = QFileInfo(output).suffix();
    if (const TraceFormat* format = findTraceFormat(ending))
        return *format;
    if (!output.isEmpty() && output != QStringLiteral("-"))
        throw WrongUsage{Text::tr("%1: give the format with --format: %2.")
                             .arg(output, formatKeys().join(QStringLiteral(", ")))};
    return *findTraceFormat(u"text");
}

std::vector<QByteArray> bytesOf(const TraceExport& trace, const TraceFormat& format)
{
    auto bytes = traceBytes(trace, format);
    if (!bytes)
        throw Failure{Text::tr("There is not enough memory for the pictures; give a smaller "
                               "--width.")};
    return *std::move(bytes);
}

/// Throws if one of several files exists already, unless replacing is requested.
void refuseOverwriting(const ParsedArguments& arguments, const QStringList& paths)
{
    const QStringList existing = existingOf(paths);
    if (paths.size() < 2 || existing.isEmpty() || arguments.has(QStringLiteral("overwrite")))
        return;
    throw Failure{existing.size() == 1
                      ? Text::tr("%1 already exists. Give another name, or --overwrite.")
                            .arg(existing.front())
                  : existing.size() == 2
                      ? Text::tr("%1 and 1 more file already exist. Give another name, or "
                                 "--overwrite.")
                            .arg(existing.front())
                      : Text::tr("%1 and %2 more files already exist. Give another name, or "
                                 "--overwrite.")
                            .arg(existing.front())
                            .arg(existing.size() - 1)};
}

void write(const ParsedArguments& arguments, const TraceExport& trace, const TraceFormat& format,
           const QString& output)
{
    if (output.endsWith(u'/') && !QDir().mkpath(output))
        throw Failure{Text::tr("Cannot make the folder %1.").arg(output)};
    const QStringList paths = tracePaths(trace, format, output);
    const QString folder = QFileInfo(paths.front()).path();
    if (!QFileInfo(folder).isDir())
        throw Failure{Text::tr("Cannot write %1: there is no folder %2; a name that ends with "
                               "/ makes one.")
                          .arg(paths.front(), folder)};
    refuseOverwriting(arguments, paths);
    if (const auto error = writeTrace(paths, bytesOf(trace, format)))
        throw Failure{*error};
    if (!arguments.has(QStringLiteral("quiet")))
        say(paths.size() == 1 ? Text::tr("Wrote %1").arg(paths.front())
                              : Text::tr("Wrote %1 to %2, %3 files")
                                    .arg(paths.front(), paths.back())
                                    .arg(paths.size()));
}

void trace(const ParsedArguments& arguments)
{
    const QString output = arguments.text(QStringLiteral("output")).value_or(QString());
    const TraceFormat& format = traceFormat(arguments, output);
    const bool toTerminal = output.isEmpty() || output == QStringLiteral("-");
    if (toTerminal && format.forPeople)
        throw WrongUsage{Text::tr("Name a file or a folder for the pictures with -o.")};
    const TraceExport trace = exportOf(arguments);
    if (toTerminal)
        print(QString::fromUtf8(bytesOf(trace, format).front()));
    else
        write(arguments, trace, format, output);
}

} // namespace

Command traceCommand()
{
    return {
        "trace",
        "--line X1,Y1,X2,Y2 [OPTIONS]",
        Text::tr("Shows step by step how an algorithm clips one line, as text, data, slides, a web "
                 "page or an animated picture."),
        {{{"a", "algorithm"},
          "A",
          Text::tr("Key or abbreviation of the algorithm; KEY:published is the form that "
                   "its authors printed (%1).")
              .arg(latin(usualAlgorithm().key))},
         {{"line"}, "X1,Y1,X2,Y2", Text::tr("The line, from End 1 to End 2.")},
         {{"w", "window"},
          "WINDOW",
          Text::tr("The window (-100,-75,100,75, the paper's): XMIN,YMIN,XMAX,YMAX. With @DEGREES "
                   "it is rotated counterclockwise about its centre, and the steps are in its own "
                   "directions. Or a convex window, for algorithms that clip there: “polygon:X,Y "
                   "X,Y …” or circle:X,Y,R.")},
         {{"f", "format"},
          formatKeys().join(u'|'),
          Text::tr("Format of the output (by the ending of the name in -o, otherwise text).")},
         {{"o", "output"},
          "FILE|FOLDER/",
          Text::tr("Where to write. For svg and png there is a file for each step: "
                   "FILE-01.svg and so on.")},
         {{"step"}, "N", Text::tr("Write only this step.")},
         {{"y", "y-axis"},
          "up|down",
          Text::tr("Direction in which y grows, in pictures and sentences (up).")},
         {{"theme"},
          "light|dark",
          Text::tr("Theme of the pictures (light); a web page follows "
                   "the desktop.")},
         {{"picture-only"}, {}, Text::tr("Pictures without sentence, pseudo-code and variables.")},
         {{"width"},
          "PIXELS",
          Text::tr("Width of png and gif in pixels, %1 to %2; they are 16:9 (1280).")
              .arg(leastWidth)
              .arg(mostWidth)},
         {{"overwrite"}, {}, Text::tr("Replace numbered files that exist.")},
         {{"q", "quiet"}, {}, Text::tr("Do not report the files written.")}},
        {"clearcut trace -a md --line -160,-30,70,130",
         "clearcut trace -a cb --line -160,-30,70,130 -w 'polygon:-100,-75 100,-75 0,90'",
         "clearcut trace -a cs:published --line 1,1,-1,-1 -w 0.1,0.1,3,3 -f json",
         "clearcut trace -a lb --line -160,-30,70,130 -o slides.pdf",
         "clearcut trace -a lb --line -160,-30,70,130 -o steps.html",
         "clearcut trace -a nln --line -160,-30,70,130 -f svg -o frames/ --theme dark"},
        0,
        trace,
        Paints::Pictures};
}

} // namespace app
