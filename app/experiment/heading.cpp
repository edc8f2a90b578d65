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
         {Headings::tr("Form"),
          Headings::tr("Published: as its authors printed it. Corrected: without their faults.")}},
        {"rank",
         {Headings::tr("Rank"),
          Headings::tr("Empty if it does not differ significantly from every other algorithm.")}},
        {"letters",
         {Headings::tr("Letters"),
          Headings::tr("Algorithms that share no letter differ significantly, and by 1 % or "
                       "more.")}},
        {"ratio_fastest",
         {Headings::tr("Ratio"),
          Headings::tr("To the lowest median: the median of the ratios run by run.")}},
        {"p_fastest",
         {Headings::tr("p"),
          Headings::tr(
              "Of the exact signed-rank test against the lowest median, paired by run, "
              "with Holm's correction. The same runs decide which algorithm has the lowest median: "
              "with eleven equal algorithms, some p is below 0.05 in about one of ten "
              "experiments.")}},
        {"median_ns",
         {Headings::tr("Median\nns"),
          Headings::tr("Nanoseconds a line: half of the runs took less.")}},
        {"spread_ns",
         {Headings::tr("Spread\nns"),
          Headings::tr("Between the quartiles: the middle half of the runs.")}},
        {"mean_ns",
         {Headings::tr("Mean\nns"), Headings::tr("What the paper used; one slow run moves it.")}},
        {"low_ns",
         {Headings::tr("Low\nns"),
          Headings::tr("The middle lies above this with 95 % confidence.")}},
        {"high_ns",
         {Headings::tr("High\nns"),
          Headings::tr("The middle lies below this with 95 % confidence.")}},
        {"visible",
         {Headings::tr("Visible\nlines"), Headings::tr("Lines of which a part is left.")}},
        {"lost",
         {Headings::tr("Lost\nlines"), Headings::tr("Lines that are visible and that it drops.")}},
        {"shown",
         {Headings::tr("Shown\nwrongly"),
          Headings::tr("Lines that are not visible and that it keeps.")}},
        {"checksum",
         {Headings::tr("Checksum"),
          Headings::tr("Of all visible parts: who finds the same has the same.")}},
    };
}

/// Columns of the comparison with the paper.
std::map<QString, Heading> againstHeadings()
{
    const QString faster =
        Headings::tr("The time between the other and Prop., in per cent of "
                     "Prop.'s, as the paper says it. Negative: Prop. is slower.");
    const QString saves = Headings::tr("The time between the other and Prop., in per cent of the "
                                       "other's. Negative: Prop. is slower.");
    return {
        {"paper_s",
         {Headings::tr("Paper,\ntotal s"),
          Headings::tr("The paper's average, in seconds: always of making, clipping and drawing "
                       "all lines of its table.")}},
        {"ours_s", {Headings::tr("Ours\ns"), Headings::tr("Our average, in seconds.")}},
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
    const QString ns = Headings::tr("Nanoseconds a line of this class alone.");
    return {
        {"inside_ns", {Headings::tr("Inside\nns"), ns}},
        {"rejected_ns", {Headings::tr("Rejected\nns"), ns}},
        {"cut_ns", {Headings::tr("Cut\nns"), ns}},
        {"missed_ns", {Headings::tr("Missed\nns"), ns}},
        {"weighted_ns",
         {Headings::tr("Weighted\nns"),
          Headings::tr("What a line of the scene would cost if each cost what its class does.")}},
        {"class", {Headings::tr("Class of line"), {}}},
        {"lines_of_class", {Headings::tr("Lines"), {}}},
        {"comparisons", {Headings::tr("Compar-\nisons"), Headings::tr("A line, on average.")}},
        {"additions",
         {Headings::tr("Addi-\ntions"), Headings::tr("A line, on average, with subtractions.")}},
        {"multiplications",
         {Headings::tr("Multipli-\ncations"), Headings::tr("A line, on average.")}},
        {"divisions", {Headings::tr("Divi-\nsions"), Headings::tr("A line, on average.")}},
        {"all", {Headings::tr("All"), Headings::tr("Operations a line.")}},
        {"outside",
         {Headings::tr("Ends\noutside"),
          Headings::tr("Lines that it gives an end outside the window.")}},
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
        {"category", {Headings::tr("Asked about"), {}}},
        {"lines", {Headings::tr("Lines"), {}}},
        {"meaning", {Headings::tr("What that is"), {}}},
        {"judged", {Headings::tr("Tested"), Headings::tr("Lines whose answer was judged.")}},
        {"wrong", {Headings::tr("Wrong"), {}}},
        {"rounded_outside",
         {Headings::tr("Rounded\noutside"),
          Headings::tr("Right, but for an end that rounding left some ulps outside the window.")}},
        {"points",
         {Headings::tr("Points\nof 10"),
          Headings::tr("One for each whole tenth that is right, of the visible or of the invisible "
                       "lines, whichever is less; 10 only if every line is right.")}},
        {"degree", {Headings::tr("Result"), {}}},
        {"fault", {Headings::tr("What is wrong"), {}}},
        {"line", {Headings::tr("Line, End 1 → End 2"), {}}},
        {"window", {Headings::tr("Window, min … max"), {}}},
        {"expected", {Headings::tr("Visible is"), Headings::tr("What exact arithmetic says.")}},
        {"got", {Headings::tr("It returned"), {}}},
        {"error",
         {Headings::tr("Off by"),
          Headings::tr("In ulps: units in the last place of the largest coordinate of line and "
                       "window. Beyond a million of them in units of the coordinates.")}},
        {"ratio",
         {Headings::tr("Yours\ntakes ×"),
          Headings::tr("How many times as long as this one your algorithm takes.")}},
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
