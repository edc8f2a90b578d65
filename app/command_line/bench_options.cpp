// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/bench_options.h"

#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/terminal.h"
#include "app/command_line/window_forms.h"
#include "app/command_line/window_options.h"
#include "app/document/window_shape.h"
#include "app/experiment/choice.h"
#include "app/experiment/one_by_one.h"
#include "app/experiment/threads.h"
#include "app/formats/format.h"
#include "app/scene/compared_window.h"
#include "app/scene/scene.h"

#include <QFileInfo>

#include <algorithm>
#include <array>
#include <limits>

namespace app {
namespace {

const QStringList precisions{"double", "single"};

template <class Row>
QStringList keysOf(const std::vector<Row>& rows)
{
    QStringList keys;
    for (const Row& row : rows)
        keys << row.key;
    return keys;
}

QString allMeasures()
{
    return (keysOf(measures()) + keysOf(analyses())).join(QStringLiteral(", "));
}

/// A rectangle in the scene's own units.
std::optional<clipping::Window> plainRectangle(const ParsedArguments& arguments,
                                               const QString& option)
{
    const auto lengths = arguments.rectangle(option);
    if (!lengths)
        return std::nullopt;
    for (const Length& length : *lengths)
        if (length.unit != Unit::User)
            throw WrongUsage{Text::tr("--%1 %2: give four numbers without units.")
                                 .arg(option, *arguments.text(option))};
    const auto& l = *lengths;
    return clipping::Window{{l[0].value, l[1].value}, {l[2].value, l[3].value}};
}

// Reports the drawing's own window; a given window is in the tables.
void sayWindow(const Imported& imported, const Field& field)
{
    const bool saved =
        field.shape
        || !comparedWindow(imported.document.windows(), imported.document.page()).isPage;
    const QString source = saved            ? Text::tr("saved in the drawing")
                           : imported.paged ? Text::tr("the page")
                                            : Text::tr("the bounds of all objects");
    say(Text::tr("Window (%1): %2.")
            .arg(source, field.shape ? field.shape->text : placeText(field.window, imported)));
}

/// Takes the visible lines of a drawing, and its window. Returns the drawing.
Imported takeDrawing(const ParsedArguments& arguments, const QString& path,
                     ExperimentOptions& options)
{
    const auto imported = readFile(path);
    if (!imported)
        throw Failure{imported.error};
    const EditedDocument document(imported.value->document);
    const Scene scene(document);
    const auto subject = drawingSubject(QFileInfo(path).fileName(), scene.lines(), document.now());
    if (!subject)
        throw Failure{Text::tr("%1 shows no lines.").arg(path)};
    options = subject->options;
    if (!arguments.has(QStringLiteral("window")))
        sayWindow(*imported.value, options.field);
    return *imported.value;
}

/// Returns the drawing if the scene is one, otherwise an empty one.
Imported takeScene(const ParsedArguments& arguments, ExperimentOptions& options)
{
    const QString scene = arguments.text(QStringLiteral("scene")).value_or(QString());
    constexpr QStringView file = u"file:";
    if (scene.startsWith(file) && scene.size() > file.size())
        return takeDrawing(arguments, scene.mid(file.size()), options);
    const auto rows = testScenes();
    // The last key is not a row: its path was handled as a drawing.
    options.scene = rows[arguments.choice(QStringLiteral("scene"), keysOf(rows) << "file:PATH")];
    return {};
}

bool isShaped(const QString& window) { return window.contains(u'@') || window.contains(u':'); }

/// A window that is rotated, or no rectangle: one of the forms that `clip -w` takes.
void takeShape(const GivenValue& value, const Imported& imported, Field& field)
{
    const auto windows = windowsOf(value, imported);
    if (windows.size() > 1)
        throw WrongUsage{Text::tr("--window %1: algorithms are timed at one window, and these "
                                  "are %2: give one.")
                             .arg(value.text)
                             .arg(windows.size())};
    field.shape = shapedWindow(windows.front(), imported.document.page(), value.text);
    field.window = boxOf(windows.front().shape);
    if (!field.shape)
        return;
    field.window = field.shape->step().box;
    if (const QString refusal = refusalOf(*field.shape); !refusal.isEmpty())
        throw WrongUsage{Text::tr("--window %1: ").arg(value.text) + refusal};
}

void takeFieldWindow(const ParsedArguments& arguments, const Imported& imported, Field& field)
{
    const QString option = QStringLiteral("window");
    const auto text = arguments.text(option);
    if (!text)
        return;
    field.shape.reset();
    if (isShaped(*text))
        takeShape({option, *text}, imported, field);
    else
        field.window = *plainRectangle(arguments, option);
}

// Refuses options that work only at axis-aligned rectangles.
void refuseAtShape(const ParsedArguments& arguments, const ExperimentOptions& options,
                   const Wanted& wanted)
{
    const auto refuse = [](const QString& option) {
        throw WrongUsage{Text::tr("--%1 needs a window that is a rectangle along the axes: "
                                  "give XMIN,YMIN,XMAX,YMAX for --window, or leave out --%1.")
                             .arg(option)};
    };
    if (!options.scene.anyShape)
        refuse(QStringLiteral("scene"));
    if (arguments.has(QStringLiteral("paper")))
        refuse(QStringLiteral("paper"));
    if (options.order == Order::ByClass)
        refuse(QStringLiteral("order"));
    if (options.precision == Precision::Single)
        refuse(QStringLiteral("precision"));
    if (options.threads > 1)
        refuse(QStringLiteral("threads"));
    if (!wanted.analyses.empty() && arguments.has(QStringLiteral("measure")))
        throw WrongUsage{Text::tr("--measure %1 needs a window that is a rectangle along the "
                                  "axes: measure only times at others.")
                             .arg(wanted.analyses.front().key)};
}

void takeField(const ParsedArguments& arguments, const Imported& imported,
               ExperimentOptions& options)
{
    if (const auto space = plainRectangle(arguments, QStringLiteral("space")))
        options.field.space = *space;
    takeFieldWindow(arguments, imported, options.field);
    if (options.scene.lines == 0 && !hasRoom(options.field))
        throw WrongUsage{Text::tr("The window must have an area, and the space must extend "
                                  "beyond it on all four sides: see --space and --window.")};
}

QStringList drawTargetWords()
{
    return QStringList(QStringLiteral("auto")) + keysOf(drawTargetKinds());
}

DrawTargetMaker parsedDrawTarget(const ParsedArguments& arguments, bool draws)
{
    const auto choice = arguments.choice(QStringLiteral("draw-with"), drawTargetWords());
    if (!draws)
        return nullptr;
    if (choice == 0)
        return bestDrawTarget();
    const DrawTargetKind kind = drawTargetKinds()[choice - 1];
    if (DrawTargetMaker maker = kind.maker())
        return maker;
    throw Failure{
        Text::tr("%1 cannot draw here: it needs a display. Leave out --draw-with.").arg(kind.name)};
}

/// Only the wall clock measures the work of several threads and cores.
void takeThreads(const ParsedArguments& arguments, ExperimentOptions& options)
{
    if (!arguments.has(QStringLiteral("threads")))
        return;
    if (mostThreads() == 1)
        throw Failure{Text::tr("--threads: this machine has one core, or Clearcut was built "
                               "without oneTBB.")};
    options.threads = *arguments.count(QStringLiteral("threads"), 1, mostThreads());
    if (options.threads > 1)
        options.clock = wallClock();
}

} // namespace

std::vector<Option> experimentOptions()
{
    return {
        {{"n", "lines"},
         "N",
         Text::tr("Number of lines in a run (1000000; for a drawing: its own).")},
        {{"r", "runs"},
         "N",
         Text::tr("Number of runs (10, or as many as are needed to tell which algorithms "
                  "differ: 12 for 12 algorithms).")},
        {{"warmup"},
         "N",
         Text::tr("Number of runs before the measured ones, which do not count (1).")},
        {{"quick"}, {}, Text::tr("Take only 100000 lines.")},
        {{"s", "seed"},
         "N",
         Text::tr("Seed of the random lines of the first run (1); each further run has the next.")},
        {{"scene"},
         "SCENE",
         Text::tr("%1, or file:PATH for the lines of a drawing (paper).")
             .arg(keysOf(testScenes()).join(QStringLiteral(", ")))},
        {{"order"},
         "as-they-come|shuffled|sorted",
         Text::tr("Order of the lines (as-they-come). as-they-come: the scene's or the drawing's "
                  "own order. shuffled: a random order, so that neighbours no longer resemble each "
                  "other. sorted: by class (inside, rejected, cut, missed), which the processor "
                  "predicts best.")},
        {{"space"}, "XMIN,YMIN,XMAX,YMAX", Text::tr("The space of the lines (the paper's).")},
        {{"w", "window"},
         "WINDOW",
         Text::tr("The clip window (the paper's): XMIN,YMIN,XMAX,YMAX, with @DEGREES to rotate it. "
                  "Or a convex one, such as circle:X,Y,R or “polygon:X,Y X,Y …”. Algorithms that "
                  "cannot clip there are left out.")},
        {{"a", "algorithms"},
         "LIST",
         Text::tr("Keys or abbreviations with commas between them (all).")},
        {{"form"},
         "both|corrected|published",
         Text::tr("Which forms of the algorithms take part (both).")},
        {{"precision"},
         precisions.join(u'|'),
         Text::tr("Precision of the numbers; single: corrected forms only (double).")},
        {{"threads"},
         "N",
         Text::tr("Threads for each algorithm; several are timed by wall clock (1).")},
        {{"draw-with"},
         drawTargetWords().join(u'|'),
         Text::tr("What draws; auto: off-screen OpenGL if there is a display (auto).")},
        {{"measure"},
         "LIST",
         Text::tr("What to measure, with commas between: %1 (clip; with --paper: all times; "
                  "with --report or --charts: everything).")
             .arg(allMeasures())},
    };
}

ExperimentOptions parsedExperiment(const ParsedArguments& arguments, const Wanted& wanted)
{
    ExperimentOptions options;
    const Imported imported = takeScene(arguments, options);
    takeField(arguments, imported, options);
    if (arguments.has(QStringLiteral("quick")))
        options.lines = 100'000;
    const auto take = [&](const char* option, quint64 least, quint64 most, auto& to) {
        if (const auto count = arguments.count(QLatin1StringView(option), least, most))
            to = *count;
    };
    take("lines", 1, mostLines, options.lines);
    take("runs", 1, mostRuns, options.runs);
    take("warmup", 1, mostRuns, options.warmUps);
    take("seed", 0, std::numeric_limits<quint64>::max(), options.seed);
    QStringList orderKeys;
    for (const OrderName& order : orders())
        orderKeys << latin(order.key);
    options.order = Order(arguments.choice(QStringLiteral("order"), orderKeys));
    options.precision = parsedPrecision(arguments);
    takeThreads(arguments, options);
    if (options.field.shape)
        refuseAtShape(arguments, options, wanted);
    options.target =
        parsedDrawTarget(arguments, std::ranges::any_of(wanted.measures, &Measure::draws));
    return options;
}

Precision parsedPrecision(const ParsedArguments& arguments)
{
    if (arguments.choice(QStringLiteral("precision"), precisions) == 0)
        return Precision::Double;
    for (const char* option : {"paper", "form"})
        if (arguments.has(QLatin1StringView(option)))
            throw WrongUsage{
                Text::tr("--precision single has only the corrected forms: leave out --%1.")
                    .arg(QLatin1StringView(option))};
    return Precision::Single;
}

std::vector<clipping::Form> parsedForms(const ParsedArguments& arguments)
{
    constexpr std::array both{clipping::Form::Corrected, clipping::Form::Published};
    if (parsedPrecision(arguments) == Precision::Single)
        return {clipping::Form::Corrected};
    const auto choice =
        arguments.choice(QStringLiteral("form"), {"both", "corrected", "published"});
    if (choice == 0)
        return {both.begin(), both.end()};
    return {both[choice - 1]};
}

std::vector<Variant> parsedVariants(const ParsedArguments& arguments)
{
    auto algorithms = arguments.algorithms(QStringLiteral("algorithms"));
    if (algorithms.empty())
        for (const auto& algorithm : clipping::algorithms())
            algorithms.push_back(&algorithm);
    std::vector<Variant> all;
    for (const clipping::Form form : parsedForms(arguments))
        for (const Variant& variant : variantsOf(algorithms, form))
            all.push_back(variant);
    return withOneByOne(all);
}

Wanted parsedWanted(const ParsedArguments& arguments, const QString& otherwise)
{
    const auto text = arguments.text(QStringLiteral("measure"));
    const QStringList keys = text.value_or(otherwise).toLower().split(u',');
    const auto times = measures();
    const auto rest = analyses();
    Wanted wanted;
    for (const QString& key : keys) {
        if (const auto row = std::ranges::find(times, key, &Measure::key); row != times.end())
            wanted.measures.push_back(*row);
        else if (const auto other = std::ranges::find(rest, key, &Analysis::key);
                 other != rest.end())
            wanted.analyses.push_back(*other);
        else
            throw WrongUsage{Text::tr("--measure %1: give %2.").arg(*text, allMeasures())};
    }
    if (!wanted.analyses.empty() && parsedPrecision(arguments) == Precision::Single)
        throw WrongUsage{Text::tr("--precision single has only times: leave out “%1”.")
                             .arg(wanted.analyses[0].key)};
    return wanted;
}

} // namespace app
