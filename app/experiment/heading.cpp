// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/heading.h"

#include "app/base/text.h"

#include <array>
#include <map>

namespace app {
namespace {

QString withoutRank()
{
    return Text::tr(
        "Empty if the algorithm does not differ significantly from every other algorithm.");
}

/// Columns of times by algorithm.
std::map<QString, Heading> timeHeadings()
{
    return {
        {"algorithm", {Text::tr("Algorithm"), {}}},
        {"form",
         {Text::tr("Form"), Text::tr("Published: as its authors printed it. Corrected: "
                                     "without the faults of the published form.")}},
        {"rank", {Text::tr("Rank"), withoutRank()}},
        {"letters",
         {Text::tr("Letters"),
          Text::tr("Algorithms that share no letter differ significantly, by 1 % or more.")}},
        {"ratio_fastest",
         {Text::tr("Ratio"),
          Text::tr("Ratio to the lowest median: the median of the ratios run by run.")}},
        {"p_fastest",
         {Text::tr("p"),
          Text::tr("p of the exact signed-rank test against the lowest median, paired by run, with "
                   "Holm's correction. The same runs decide which algorithm has the lowest median. "
                   "So with twelve equal algorithms, some p is below 0.05 in about one of ten "
                   "experiments.")}},
        {"median_ns",
         {Text::tr("Median\nns"), Text::tr("Nanoseconds per line: half of the runs took less.")}},
        {"spread_ns",
         {Text::tr("Spread\nns"), Text::tr("The distance between the quartiles: the middle "
                                           "half of the runs lies between them.")}},
        {"mean_ns",
         {Text::tr("Mean\nns"), Text::tr("The paper reports means. One slow run changes a mean.")}},
        {"low_ns",
         {Text::tr("Low\nns"),
          Text::tr("The lower end of the median's 95 % confidence interval.")}},
        {"high_ns",
         {Text::tr("High\nns"),
          Text::tr("The upper end of the median's 95 % confidence interval.")}},
        {"visible",
         {Text::tr("Visible\nlines"), Text::tr("Lines of which the algorithm keeps a part.")}},
        {"lost", {Text::tr("Lost\nlines"), Text::tr("Visible lines that the algorithm drops.")}},
        {"shown",
         {Text::tr("Shown\nwrongly"), Text::tr("Invisible lines that the algorithm keeps.")}},
        {"checksum",
         {Text::tr("Checksum"), Text::tr("Of all visible parts. Algorithms with the same "
                                         "visible parts have the same checksum.")}},
    };
}

/// Columns of the comparison with the paper.
std::map<QString, Heading> againstHeadings()
{
    const QString faster =
        Text::tr("The difference of the times of this algorithm and Prop. in per cent of "
                 "Prop.'s time, as in the paper. Negative: Prop. is slower.");
    const QString saves =
        Text::tr("The difference of the times of this algorithm and Prop. in per cent of this "
                 "algorithm's time. Negative: Prop. is slower.");
    return {
        {"paper_s",
         {Text::tr("Paper,\ntotal s"),
          Text::tr("The paper's average time in seconds. It always includes generating, "
                   "clipping and drawing all lines of its table.")}},
        {"ours_s", {Text::tr("Ours\ns"), Text::tr("Our average time in seconds.")}},
        {"paper_rank",
         {Text::tr("Paper's\nrank"),
          Text::tr("From the paper's own runs.") + u' ' + withoutRank()}},
        {"our_rank", {Text::tr("Our\nrank"), withoutRank()}},
        {"paper_letters",
         {Text::tr("Paper's\nletters"),
          Text::tr("Algorithms that share no letter differ significantly. From the paper's own "
                   "runs, as if they were paired row by row.")}},
        {"our_letters",
         {Text::tr("Our\nletters"),
          Text::tr("Algorithms that share no letter differ significantly.")}},
        {"paper_faster", {Text::tr("Faster %\npaper"), faster}},
        {"our_faster", {Text::tr("Faster %\nours"), faster}},
        {"paper_saves", {Text::tr("Saves %\npaper"), saves}},
        {"our_saves", {Text::tr("Saves %\nours"), saves}},
    };
}

/// Columns of the explanation of times.
std::map<QString, Heading> explanationHeadings()
{
    const QString ns = Text::tr("Nanoseconds per line, measured with lines of this class only.");
    return {
        {"inside_ns", {Text::tr("Inside\nns"), ns}},
        {"rejected_ns", {Text::tr("Rejected\nns"), ns}},
        {"cut_ns", {Text::tr("Cut\nns"), ns}},
        {"missed_ns", {Text::tr("Missed\nns"), ns}},
        {"weighted_ns",
         {Text::tr("Weighted\nns"),
          Text::tr("The mean cost of a line of the scene, if each line cost as much as its "
                   "class does alone.")}},
        {"class", {Text::tr("Class of line"), {}}},
        {"lines_of_class", {Text::tr("Lines"), {}}},
        {"comparisons", {Text::tr("Compar-\nisons"), Text::tr("Per line, on average.")}},
        {"additions",
         {Text::tr("Addi-\ntions"), Text::tr("Per line, on average, including subtractions.")}},
        {"multiplications", {Text::tr("Multipli-\ncations"), Text::tr("Per line, on average.")}},
        {"divisions", {Text::tr("Divi-\nsions"), Text::tr("Per line, on average.")}},
        {"all", {Text::tr("All"), Text::tr("Operations per line.")}},
        {"outside",
         {Text::tr("Ends\noutside"),
          Text::tr("Lines with an end that the algorithm leaves outside the window.")}},
        {"mean_ulps",
         {Text::tr("Mean\nulps"),
          Text::tr("How far ends are off, in units in the last place of the largest coordinate.")}},
        {"most_ulps", {Text::tr("Most\nulps"), Text::tr("How far the worst end is off.")}},
        {"what", {Text::tr("What"), {}}},
        {"value", {Text::tr("Value"), {}}},
    };
}

/// Columns of a verdict on a library's algorithm.
std::map<QString, Heading> verdictHeadings()
{
    return {
        {"category", {Text::tr("Test"), {}}},
        {"lines", {Text::tr("Lines"), {}}},
        {"meaning", {Text::tr("What it tests"), {}}},
        {"judged", {Text::tr("Tested"), Text::tr("Lines whose result was judged.")}},
        {"wrong", {Text::tr("Wrong"), {}}},
        {"rounded_outside",
         {Text::tr("Rounded\noutside"),
          Text::tr("Right, except that rounding left an end some ulps outside the window.")}},
        {"points",
         {Text::tr("Points\nof 10"),
          Text::tr(
              "One point for each full tenth of right lines, counted for visible and for invisible "
              "lines: the smaller count is given. 10 points only if every line is right.")}},
        {"degree", {Text::tr("Result"), {}}},
        {"fault", {Text::tr("What is wrong"), {}}},
        {"line", {Text::tr("Line, End 1 → End 2"), {}}},
        {"window", {Text::tr("Window, min … max"), {}}},
        {"expected", {Text::tr("Right result"), Text::tr("The visible part by exact arithmetic.")}},
        {"got", {Text::tr("Its result"), {}}},
        {"error",
         {Text::tr("Off by"),
          Text::tr("In ulps: units in the last place of the largest coordinate of line and "
                   "window. Errors above a million ulps are in units of the coordinates.")}},
        {"ratio",
         {Text::tr("Your time\n÷ its time"),
          Text::tr("The time of your algorithm divided by the time of this one.")}},
    };
}

} // namespace

Heading headingOf(const QString& name)
{
    static const std::array all{timeHeadings(), againstHeadings(), explanationHeadings(),
                                verdictHeadings()};
    for (const auto& headings : all)
        if (const auto found = headings.find(name); found != headings.end())
            return found->second;
    return {name, {}};
}

} // namespace app
