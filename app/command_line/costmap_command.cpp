// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/number.h"
#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/parsed_arguments.h"
#include "app/command_line/terminal.h"
#include "app/cost_map/files.h"
#include "app/experiment/paper_scene.h"

#include <QFileInfo>

#include <cmath>

namespace app {
namespace {

constexpr double most = 1e150; // differences of such numbers, and their products, are finite
constexpr int mostSide = 4096;

/// `wanted` numbers between separators.
std::optional<std::vector<double>> numbersOf(const QString& text, QChar separator, qsizetype wanted)
{
    std::vector<double> numbers;
    const QStringList parts = text.split(separator);
    for (const QString& part : parts)
        if (const auto number = parseNumber(part.trimmed().toStdString());
            number && std::abs(*number) <= most)
            numbers.push_back(*number);
    if (parts.size() != wanted || qsizetype(numbers.size()) != wanted)
        return std::nullopt;
    return numbers;
}

std::optional<clipping::Window> rectangleOf(const ParsedArguments& arguments, const QString& option)
{
    const auto text = arguments.text(option);
    if (!text)
        return std::nullopt;
    const auto n = numbersOf(*text, u',', 4);
    if (!n || (*n)[0] > (*n)[2] || (*n)[1] > (*n)[3])
        throw WrongUsage{Text::tr("--%1 %2: give four numbers XMIN,YMIN,XMAX,YMAX such as "
                                  "-100,-75,100,75, the lesser ones first.")
                             .arg(option, *text)};
    return clipping::Window{{(*n)[0], (*n)[1]}, {(*n)[2], (*n)[3]}};
}

std::optional<Point> pointOf(const ParsedArguments& arguments, const QString& option)
{
    const auto text = arguments.text(option);
    if (!text)
        return std::nullopt;
    const auto n = numbersOf(*text, u',', 2);
    if (!n)
        throw WrongUsage{
            Text::tr("--%1 %2: give two numbers X,Y such as -150,20.").arg(option, *text)};
    return Point((*n)[0], (*n)[1]);
}

void setSize(CostPlan& plan, const QString& text)
{
    const auto n = numbersOf(text, u'x', 2);
    const auto fits = [](double side) {
        return side >= 1 && side <= mostSide && side == std::floor(side);
    };
    if (!n || !fits((*n)[0]) || !fits((*n)[1]))
        throw WrongUsage{Text::tr("--size %1: give two whole numbers from 1 to %2, such as "
                                  "240x180.")
                             .arg(text)
                             .arg(mostSide)};
    plan.columns = int((*n)[0]);
    plan.rows = int((*n)[1]);
}

/// Sets the variant that is shown, or all candidates for the cheapest.
void setAlgorithms(CostPlan& plan, const ParsedArguments& arguments)
{
    const bool cheapest = arguments.has(QStringLiteral("cheapest"));
    const auto key = arguments.text(QStringLiteral("algorithm"));
    if (cheapest == key.has_value())
        throw WrongUsage{Text::tr("Give either -a ALGORITHM or --cheapest.")};
    const bool published =
        arguments.choice(QStringLiteral("form"), {"corrected", "published"}) == 1;
    plan.variants = costVariants(published ? clipping::Form::Published : clipping::Form::Corrected);
    plan.shown.reset();
    if (!key)
        return;
    plan.shown = findVariant(*key);
    if (!plan.shown)
        throw WrongUsage{
            Text::tr("There is no algorithm “%1”. Give a key or abbreviation from the list of "
                     "“clearcut algorithms”; add :published for the published form.")
                .arg(*key)};
}

const CostMeasure& measureOf(const ParsedArguments& arguments)
{
    QStringList keys;
    for (const CostMeasure& measure : costMeasures())
        keys << latin(measure.key);
    return costMeasures()[arguments.choice(QStringLiteral("measure"), keys)];
}

CostPlan planOf(const ParsedArguments& arguments)
{
    CostPlan plan =
        usualCostPlan(rectangleOf(arguments, QStringLiteral("window")).value_or(paperWindow));
    plan.measure = &measureOf(arguments);
    setAlgorithms(plan, arguments);
    const auto from = pointOf(arguments, QStringLiteral("from")),
               to = pointOf(arguments, QStringLiteral("to"));
    if (from && to)
        throw WrongUsage{Text::tr("Fix one end: give either --from or --to.")};
    plan.fixed = to ? *to : from.value_or(plan.fixed);
    plan.end = to ? FixedEnd::End2 : FixedEnd::End1;
    plan.area = rectangleOf(arguments, QStringLiteral("area")).value_or(plan.area);
    if (plan.area.min.x == plan.area.max.x || plan.area.min.y == plan.area.max.y)
        throw WrongUsage{Text::tr("The area is empty: its XMIN,YMIN must be less than its "
                                  "XMAX,YMAX.")};
    if (const auto size = arguments.text(QStringLiteral("size")))
        setSize(plan, *size);
    return plan;
}

void printCostMap(const ParsedArguments& arguments)
{
    const auto path = arguments.text(QStringLiteral("output"));
    if (!path)
        throw WrongUsage{Text::tr("Say with -o where to write: a file whose name ends with %1. A - "
                                  "is a CSV table on standard output.")
                             .arg(endingsOf(costMapFormats()))};
    const bool toOutput = *path == QStringLiteral("-");
    if (!toOutput && !kindOf(costMapFormats(), QFileInfo(*path).suffix()))
        throw WrongUsage{Text::tr("-o %1: a cost map is written as %2; give the file one of "
                                  "these endings.")
                             .arg(*path, endingsOf(costMapFormats()))};
    const bool dark = arguments.choice(QStringLiteral("theme"), {"light", "dark"}) == 1;
    const CostMap map = costMap(planOf(arguments));
    if (toOutput) {
        const Table table = costTable(map);
        for (const TableFormat& format : tableFormats())
            if (format.key == QStringLiteral("csv"))
                print(format.text({&table, 1}));
        return;
    }
    if (const auto error =
            writeCostMap(map, *path, costMapLook(dark ? Ground::Dark : Ground::Light)))
        throw Failure{*error};
}

} // namespace

Command costmapCommand()
{
    QStringList measures;
    for (const CostMeasure& measure : costMeasures())
        measures << latin(measure.key);
    std::vector<Option> options{
        {{"a", "algorithm"},
         "ALGORITHM",
         Text::tr("Key or abbreviation of the algorithm; KEY:published is the form that its "
                  "authors printed.")},
        {{"cheapest"},
         {},
         Text::tr("Show for each cell which algorithm is cheapest, or which ones are, instead of "
                  "the cost of one.")},
        {{"form"},
         "corrected|published",
         Text::tr("With --cheapest: which forms take part (corrected).")},
        {{"from"},
         "X,Y",
         Text::tr("Fix End 1 of every line here; End 2 sweeps the area (left of the window).")},
        {{"to"},
         "X,Y",
         Text::tr("Instead of --from: fix End 2 of every line here; End 1 sweeps the area.")},
        {{"w", "window"},
         "XMIN,YMIN,XMAX,YMAX",
         Text::tr("The clip window (-100,-75,100,75, as in the paper).")},
        {{"area"},
         "XMIN,YMIN,XMAX,YMAX",
         Text::tr("Which part of the plane (three windows wide and high).")},
        {{"size"},
         "COLUMNSxROWS",
         Text::tr("Number of cells, up to %1 a side (240x180).").arg(mostSide)},
        {{"measure"},
         measures.join(u'|'),
         Text::tr("What is counted for each line, or its time, which is noisy (operations).")},
        {{"o", "output"},
         "FILE",
         Text::tr("A picture with legend and caption, or a table with a row for each cell, by its "
                  "ending: %1. A - is standard output, as CSV.")
             .arg(endingsOf(costMapFormats()))},
        {{"theme"}, "light|dark", Text::tr("The background of the picture (light).")},
    };
    return {"costmap",
            "-a ALGORITHM | --cheapest -o FILE [OPTIONS]",
            Text::tr(
                "Maps the cost of a line with one fixed end, for every position of its other end."),
            std::move(options),
            {"clearcut costmap -a md --from -150,20 -o md.png",
             "clearcut costmap --cheapest --measure divisions --size 480x360 -o cheapest.png",
             "clearcut costmap -a nln:published -w 0,0,2,2 --from -1,1 -o - > nln.csv"},
            0,
            printCostMap,
            Paints::Pictures,
            {Text::tr("Coordinates: at most 1e150.")}};
}

} // namespace app
