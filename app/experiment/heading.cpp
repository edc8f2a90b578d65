// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/heading.h"

#include <QCoreApplication>

#include <array>
#include <map>

namespace app {
namespace {

struct Headings {
    Q_DECLARE_TR_FUNCTIONS(Headings)
};

/// Columns of times by algorithm.
std::map<QString, Heading> timeHeadings()
{
    return {
        {"algorithm", {Headings::tr("Algorithm"), {}}},
        {"form",
         {Headings::tr("Form"), Headings::tr("Published: as its authors printed it. Corrected: "
                                             "without the faults of the published form.")}},
        {"rank",
         {Headings::tr("Rank"),
          Headings::tr(
              "Empty if the algorithm does not differ significantly from every other algorithm.")}},
        {"letters",
         {Headings::tr("Letters"),
          Headings::tr("Algorithms that share no letter differ significantly, by 1 % or more.")}},
        {"ratio_fastest",
         {Headings::tr("Ratio"),
          Headings::tr("Ratio to the lowest median: the median of the ratios run by run.")}},
        {"p_fastest",
         {Headings::tr("p"),
          Headings::tr(
              "p of the exact signed-rank test against the lowest median, paired by run, with "
              "Holm's correction. The same runs decide which algorithm has the lowest median: with "
              "twelve equal algorithms, some p is below 0.05 in about one of ten experiments.")}},
        {"median_ns",
         {Headings::tr("Median\nns"),
          Headings::tr("Nanoseconds per line: half of the runs took less.")}},
        {"spread_ns",
         {Headings::tr("Spread\nns"), Headings::tr("The distance between the quartiles: the middle "
                                                   "half of the runs lies between them.")}},
        {"mean_ns",
         {Headings::tr("Mean\nns"),
          Headings::tr("The paper reports means. One slow run changes a mean.")}},
        {"low_ns",
         {Headings::tr("Low\nns"),
          Headings::tr("The lower end of the median's 95 % confidence interval.")}},
        {"high_ns",
         {Headings::tr("High\nns"),
          Headings::tr("The upper end of the median's 95 % confidence interval.")}},
        {"visible",
         {Headings::tr("Visible\nlines"),
          Headings::tr("Lines of which the algorithm keeps a part.")}},
        {"lost",
         {Headings::tr("Lost\nlines"), Headings::tr("Visible lines that the algorithm drops.")}},
        {"shown",
         {Headings::tr("Shown\nwrongly"),
          Headings::tr("Invisible lines that the algorithm keeps.")}},
        {"checksum",
         {Headings::tr("Checksum"), Headings::tr("Of all visible parts. Algorithms with the same "
                                                 "visible parts have the same checksum.")}},
    };
}

/// Columns of the comparison with the paper.
std::map<QString, Heading> againstHeadings()
{
    const QString faster =
        Headings::tr("The difference of the times of this algorithm and Prop. in per cent of "
                     "Prop.'s time, as in the paper. Negative: Prop. is slower.");
    const QString saves =
        Headings::tr("The difference of the times of this algorithm and Prop. in per cent of this "
                     "algorithm's time. Negative: Prop. is slower.");
    return {
        {"paper_s",
         {Headings::tr("Paper,\ntotal s"),
          Headings::tr("The paper's average time in seconds. It always includes generating, "
                       "clipping and drawing all lines of its table.")}},
        {"ours_s", {Headings::tr("Ours\ns"), Headings::tr("Our average time in seconds.")}},
        {"paper_rank", {Headings::tr("Paper's\nrank"), Headings::tr("From the paper's own runs.")}},
        {"our_rank", {Headings::tr("Our\nrank"), {}}},
        {"paper_letters",
         {Headings::tr("Paper's\nletters"),
          Headings::tr("Algorithms that share no letter differ significantly. From the paper's own "
                       "runs, as if they were paired row by row.")}},
        {"our_letters",
         {Headings::tr("Our\nletters"),
          Headings::tr("Algorithms that share no letter differ significantly.")}},
        {"paper_faster", {Headings::tr("Faster %\npaper"), faster}},
        {"our_faster", {Headings::tr("Faster %\nours"), faster}},
        {"paper_saves", {Headings::tr("Saves %\npaper"), saves}},
        {"our_saves", {Headings::tr("Saves %\nours"), saves}},
    };
}

/// Columns of the explanation of times.
std::map<QString, Heading> explanationHeadings()
{
    const QString ns =
        Headings::tr("Nanoseconds per line, measured with lines of this class only.");
    return {
        {"inside_ns", {Headings::tr("Inside\nns"), ns}},
        {"rejected_ns", {Headings::tr("Rejected\nns"), ns}},
        {"cut_ns", {Headings::tr("Cut\nns"), ns}},
        {"missed_ns", {Headings::tr("Missed\nns"), ns}},
        {"weighted_ns",
         {Headings::tr("Weighted\nns"),
          Headings::tr("The mean cost of a line of the scene, if each line cost as much as its "
                       "class does alone.")}},
        {"class", {Headings::tr("Class of line"), {}}},
        {"lines_of_class", {Headings::tr("Lines"), {}}},
        {"comparisons", {Headings::tr("Compar-\nisons"), Headings::tr("Per line, on average.")}},
        {"additions",
         {Headings::tr("Addi-\ntions"),
          Headings::tr("Per line, on average, including subtractions.")}},
        {"multiplications",
         {Headings::tr("Multipli-\ncations"), Headings::tr("Per line, on average.")}},
        {"divisions", {Headings::tr("Divi-\nsions"), Headings::tr("Per line, on average.")}},
        {"all", {Headings::tr("All"), Headings::tr("Operations per line.")}},
        {"outside",
         {Headings::tr("Ends\noutside"),
          Headings::tr("Lines with an end that the algorithm leaves outside the window.")}},
        {"mean_ulps",
         {Headings::tr("Mean\nulps"),
          Headings::tr(
              "How far ends are off, in units in the last place of the largest coordinate.")}},
        {"most_ulps", {Headings::tr("Most\nulps"), Headings::tr("How far the worst end is off.")}},
        {"what", {Headings::tr("What"), {}}},
        {"value", {Headings::tr("Value"), {}}},
    };
}

/// Columns of a verdict on a library's algorithm.
std::map<QString, Heading> verdictHeadings()
{
    return {
        {"category", {Headings::tr("Test"), {}}},
        {"lines", {Headings::tr("Lines"), {}}},
        {"meaning", {Headings::tr("What it tests"), {}}},
        {"judged", {Headings::tr("Tested"), Headings::tr("Lines whose result was judged.")}},
        {"wrong", {Headings::tr("Wrong"), {}}},
        {"rounded_outside",
         {Headings::tr("Rounded\noutside"),
          Headings::tr("Right, except that rounding left an end some ulps outside the window.")}},
        {"points",
         {Headings::tr("Points\nof 10"),
          Headings::tr(
              "One point for each full tenth of right lines, counted for visible and for invisible "
              "lines: the smaller count is given. 10 points only if every line is right.")}},
        {"degree", {Headings::tr("Result"), {}}},
        {"fault", {Headings::tr("What is wrong"), {}}},
        {"line", {Headings::tr("Line, End 1 → End 2"), {}}},
        {"window", {Headings::tr("Window, min … max"), {}}},
        {"expected",
         {Headings::tr("Right result"), Headings::tr("The visible part by exact arithmetic.")}},
        {"got", {Headings::tr("Its result"), {}}},
        {"error",
         {Headings::tr("Off by"),
          Headings::tr("In ulps: units in the last place of the largest coordinate of line and "
                       "window. Errors above a million ulps are in units of the coordinates.")}},
        {"ratio",
         {Headings::tr("Your time\n÷ its time"),
          Headings::tr("The time of your algorithm divided by the time of this one.")}},
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
