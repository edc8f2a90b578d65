// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/chart_layout.h"
#include "app/view/visible_colour.h"

#include <QTest>

#include <algorithm>
#include <cmath>

#include "tests/app/charts/sample_charts.h"
#include "tests/test_class.h"

namespace charts_chart_paint_test {

using namespace app;

namespace {

const Measure& clip()
{
    static const Measure measure = measures().front();
    return measure;
}

/// The longest horizontal run of exactly that colour, and its left end.
struct Run {
    int length = 0, left = 0;
};
Run longestRun(const QImage& image, QRgb colour, int top, int bottom)
{
    Run longest;
    for (int y = std::max(top, 0); y < std::min(bottom, image.height()); ++y)
        for (int x = 0, start = 0; x < image.width(); ++x)
            if (image.pixel(x, y) != colour)
                start = x + 1;
            else if (x + 1 - start > longest.length)
                longest = {x + 1 - start, start};
    return longest;
}
Run longestRun(const QImage& image, const QColor& colour)
{
    return longestRun(image, colour.rgb(), 0, image.height());
}

double contrastOf(const QColor& a, const QColor& b)
{
    const auto plain = [](const QColor& c) {
        return Colour{std::uint8_t(c.red()), std::uint8_t(c.green()), std::uint8_t(c.blue())};
    };
    return contrast(plain(a), plain(b));
}

/// Where two pictures of one size differ.
QRect difference(const QImage& a, const QImage& b)
{
    QRect box;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            if (a.pixel(x, y) != b.pixel(x, y))
                box |= QRect(x, y, 1, 1);
    return box;
}

Chart barsOf(std::initializer_list<double> lengths)
{
    Chart chart{.key = "bars", .title = "Bars", .rows = {}};
    auto algorithm = clipping::algorithms().begin();
    for (const double length : lengths) {
        chart.rows.push_back({.variant = {&*algorithm}, .name = "row", .figures = {Bar{{length}}}});
        ++algorithm;
    }
    return chart;
}

double lengthOf(const ChartRow& row) { return std::get<Bar>(row.figures.front()).length(); }

/// All kinds of charts, and records of some and of all variants.
std::vector<Chart> allCharts()
{
    std::vector<Chart> charts;
    const auto papers = paperTables();
    for (const Record& record : {sample::seven(), sample::everything()}) {
        charts.push_back(chartOf(record, clip()));
        charts.push_back(chartOf(record, clip(), papers.front()));
        charts.push_back(boxPlotOf(record, clip()));
    }
    for (const PaperTable& paper : papers)
        charts.push_back(chartOf(paper));
    charts.push_back(chartOf(sample::operations()));
    charts.push_back(chartOf(sample::classes()));
    return charts;
}

} // namespace

class ChartPaintTest : public QObject {
    Q_OBJECT

private slots:
    void barsAreAsLongAsTheirNumbers_data()
    {
        QTest::addColumn<bool>("dark");
        QTest::addColumn<double>("scale");
        for (const bool dark : {false, true})
            for (const double scale : {1.0, 2.0, 3.0})
                QTest::addRow("%s %gx", dark ? "dark" : "light", scale) << dark << scale;
    }
    void barsAreAsLongAsTheirNumbers()
    {
        QFETCH(bool, dark);
        QFETCH(double, scale);
        const Chart chart = chartOf(sample::seven(), clip(), paperTables().front());
        const ChartLook look = chartLook(dark ? Ground::Dark : Ground::Light);
        const QImage image = sample::picture(chart, look, {640, 400}, scale);
        const auto runOf = [&](const ChartRow& row) {
            return longestRun(image, algorithmColour(*row.variant.algorithm, look.ground));
        };
        const Run longest = runOf(chart.rows.back());
        QVERIFY(longest.length > 150 * scale);
        for (const ChartRow& row : chart.rows) {
            const Run run = runOf(row);
            const double expected = longest.length * lengthOf(row) / lengthOf(chart.rows.back());
            QVERIFY2(std::abs(run.length - expected) <= 2, qPrintable(row.name));
            QVERIFY2(std::abs(run.left - longest.left) <= 1, qPrintable(row.name));
        }
    }
    void rowsGoFromTheFastestToTheSlowest()
    {
        for (const Chart& chart : {chartOf(sample::seven(), clip()), chartOf(paperTables()[0]),
                                   chartOf(paperTables()[1]), chartOf(sample::operations())}) {
            QVERIFY(std::ranges::is_sorted(chart.rows, {}, lengthOf));
            QCOMPARE(chart.rows.size(), chart.key.contains("operations")
                                            ? sample::operations().rows.size()
                                            : std::size_t(7));
        }
        const Chart chart = chartOf(sample::seven(), clip());
        QCOMPARE(lengthOf(chart.rows.front()), 1.0);
        QCOMPARE(chart.rows.front().name, QString("NLN"));
        QCOMPARE(chart.rows.back().name, QString("CB"));
    }
    void filledIsOursAndHollowAsPublished()
    {
        Chart chart = barsOf({3, 3});
        chart.rows[1].variant.algorithm = chart.rows[0].variant.algorithm =
            clipping::findAlgorithm("CS");
        chart.rows[1].variant.form = clipping::Form::Published;
        const ChartLook look = chartLook(Ground::Light);
        const QImage image = sample::picture(chart, look, {400, 120}, 2);
        const QRgb colour = algorithmColour(*chart.rows[0].variant.algorithm, look.ground).rgb();
        const ChartLayout layout = layoutOf(chart, {0, 0, 400, 120}, look);
        const auto rowAt = [&](std::size_t r) { return int(2 * layout.rows[r].top()); };
        const auto filled = longestRun(image, colour, rowAt(0), rowAt(1)),
                   hollow = longestRun(image, colour, rowAt(1), image.height());
        QVERIFY(filled.length > 400);
        QVERIFY(std::abs(filled.length - hollow.length) <= 2);   // its outline
        const int middle = filled.left + filled.length / 2 + 20; // beside a line of the grid
        const int inside[] = {rowAt(0) + int(2 * layout.barMiddle),
                              rowAt(1) + int(2 * layout.barMiddle)};
        QCOMPARE(image.pixel(middle, inside[0]), colour);
        QCOMPARE(image.pixel(middle, inside[1]), look.paper.rgb());
    }
    void thePapersNumbersAreHollowBelowTheBars()
    {
        const Chart with = chartOf(sample::seven(), clip(), paperTables().front());
        const ChartLook look = chartLook(Ground::Light);
        const QImage image = sample::picture(with, look, {640, 420}, 1);
        const ChartLayout layout = layoutOf(with, {0, 0, 640, 420}, look);
        for (std::size_t r = 0; r < with.rows.size(); ++r) {
            const QRgb colour = algorithmColour(*with.rows[r].variant.algorithm, look.ground).rgb();
            Chart moved = with;
            moved.rows[r].other = *with.rows[r].other * 1.1;
            const QRect changed = difference(image, sample::picture(moved, look, {640, 420}, 1));
            const double bar = layout.rows[r].top() + layout.barMiddle + layout.thickness / 2;
            QVERIFY2(changed.top() >= bar && changed.bottom() <= layout.rows[r].bottom(),
                     qPrintable(with.rows[r].name));
            const double x = layout.x(0, *with.rows[r].other),
                         y = layout.rows[r].top() + layout.laneMiddle;
            if (std::abs(x - layout.x(0, 1)) > 4) { // not under the line of reference
                QVERIFY2(image.pixel(int(x), int(y)) != colour, qPrintable(with.rows[r].name));
            }
        }
    }
    void bracketsStandWhereNothingDiffers()
    {
        Chart chart = chartOf(sample::seven(), clip());
        QCOMPARE(chart.groups.size(), std::size_t(1));
        QSet<QString> names;
        for (const std::size_t r : chart.groups[0].rows)
            names << chart.rows[r].name;
        QCOMPARE(names, (QSet<QString>{"LB", "MD"}));

        const ChartLook look = chartLook(Ground::Light);
        const QRectF area(0, 0, 560, 300);
        const ChartLayout layout = layoutOf(chart, area, look);
        const QImage before = sample::picture(chart, look, {560, 300}, 1);
        chart.groups = {{{0, 1}, chart.groups[0].letter}}; // as wide
        const QRect changed = difference(before, sample::picture(chart, look, {560, 300}, 1));
        QVERIFY(changed.left() >= layout.columnRights[0]);
        QVERIFY(changed.top() >= layout.rows[0].top());
        QVERIFY(changed.bottom() <= layout.rows[4].bottom());
        QVERIFY(layout.rows[4].top() < changed.bottom());
    }
    void bracketsThatOverlapStandBesideEachOther()
    {
        Chart chart = chartOf(sample::seven(), clip());
        chart.groups = {{{0, 1}, "a"}, {{1, 3}, "b"}, {{4, 5}, "c"}};
        const ChartLook look = chartLook(Ground::Light);
        const ChartLayout layout = layoutOf(chart, {0, 0, 560, 300}, look);
        QCOMPARE(layout.lanes, (std::vector<std::size_t>{0, 1, 0}));
        const QImage image = sample::picture(chart, look, {560, 300}, 1);
        const auto dark = [&](std::size_t lane, std::size_t row) { // beside the middle of a row
            const int x = int(layout.bracket + double(lane) * layout.bracketLane
                              + 2.5 * layout.unit),
                      y = int(layout.rows[row].top() + layout.barMiddle);
            int darkest = 255;
            for (int dy = -8; dy <= 8; ++dy)
                darkest = std::min(darkest, qGray(image.pixel(x, y + dy)));
            return darkest < 200;
        };
        QVERIFY(dark(0, 0) && dark(0, 1) && dark(1, 1) && dark(1, 3) && dark(0, 4) && dark(0, 5));
        QVERIFY(!dark(1, 2)); // it is not of the group that goes past it
        QVERIFY(!dark(1, 0) && !dark(0, 3) && !dark(1, 5));
        QVERIFY(layout.bracket + 2 * layout.bracketLane <= 560.5);
    }
    void numbersOfAxesAreApart()
    {
        const ChartLook look = chartLook(Ground::Light);
        for (Chart chart : {boxPlotOf(sample::seven(), clip()), chartOf(sample::classes())})
            for (int i = 0; i < 11; ++i) { // ticks at all places
                const double most = 60 * std::pow(1.4, i);
                if (!chart.oneScale)
                    for (std::size_t r = 0; r < chart.rows.size(); ++r)
                        chart.rows[r].figures = {boxOf(std::vector{most / 3, most}),
                                                 boxOf(std::vector{-most / 17, most / 5})};
                const ChartLayout layout = layoutOf(chart, {0, 0, 720, 400}, look);
                double last = -1;
                for (std::size_t p = 0; p < layout.panels.size(); ++p)
                    for (const double tick : layout.axes[p].ticks) {
                        const Interval label = tickLabel(layout, p, tick, look);
                        QVERIFY2(label.low > last + 3,
                                 qPrintable(QStringLiteral("%1 %2").arg(most).arg(tick)));
                        last = label.high;
                    }
            }
    }
    void separateTimesHaveNoBracket()
    {
        const sample::Times all[]{{"CS", sample::ours, 10}, {"LB", sample::ours, 20}};
        QVERIFY(chartOf(sample::record(all, 0.01), clip()).groups.empty());
        const sample::Times twice[]{{"CS", sample::ours, 10}, {"CS", sample::ours, 10}};
        QCOMPARE(chartOf(sample::record(twice, 0.01), clip()).groups.size(), std::size_t(1));
    }
    void everyPatternIsItsOwn()
    {
        Chart chart = barsOf({});
        chart.rows.push_back({.name = "all", .figures = {Bar{{1, 1, 1, 1, 1}}}});
        const ChartLook look = chartLook(Ground::Light);
        const QImage image =
            sample::picture(chart, look, {540, 100}, 1).convertToFormat(QImage::Format_Grayscale8);
        const ChartLayout layout = layoutOf(chart, {0, 0, 540, 100}, look);
        std::vector<QImage> parts;
        for (int p = 0; p < 5; ++p)
            parts.push_back(
                image.copy(int(layout.x(0, p)) + 4, int(layout.rows[0].top() + 8), 60, 8));
        for (std::size_t a = 0; a < parts.size(); ++a)
            for (std::size_t b = a + 1; b < parts.size(); ++b)
                QVERIFY2(parts[a] != parts[b], qPrintable(QString("%1 %2").arg(a).arg(b)));
    }
    void aFarLongerBarIsBroken()
    {
        const Chart chart = barsOf({10, 11, 12, 13, 14, 15, 900});
        QVERIFY(isBroken(chart));
        QVERIFY(sentencesOf(chart).join(' ').contains("gap"));
        const ChartLook look = chartLook(Ground::Light);
        const QImage image = sample::picture(chart, look, {500, 260}, 1);
        const auto runOf = [&](std::size_t r) {
            return longestRun(image, algorithmColour(*chart.rows[r].variant.algorithm, look.ground))
                .length;
        };
        QVERIFY(runOf(0) > 200); // not squeezed by the last
        const ChartLayout layout = layoutOf(chart, {0, 0, 500, 260}, look);
        const QRgb colour = algorithmColour(*chart.rows[6].variant.algorithm, look.ground).rgb();
        const int y = int(layout.rows[6].top() + layout.barMiddle);
        QCOMPARE(image.pixel(int(layout.panels[0].right()) - 3, y), colour);
        QCOMPARE(image.pixel(int(layout.panels[0].right()) - 14, y), look.paper.rgb());
        QVERIFY(!isBroken(barsOf({10, 11, 12, 13, 14, 15, 40})));
        QVERIFY(!isBroken(barsOf({10, 900})));
    }
    void nothingOverlapsAtAnyWidth()
    {
        const ChartLook look = chartLook(Ground::Light);
        for (const Chart& chart : allCharts())
            for (int width = 160; width < 1000; width += 23) {
                const QByteArray what = (chart.key + ' ' + QString::number(width)).toUtf8();
                const double height = naturalHeight(chart, width, look);
                const ChartLayout layout = layoutOf(chart, QRectF(0, 0, width, height), look);
                QVERIFY2(layout.nameRight <= layout.valueRight, what);
                QVERIFY2(layout.valueRight < layout.panels.front().left(), what);
                for (std::size_t p = 0; p < layout.panels.size(); ++p) {
                    QVERIFY2(layout.panels[p].width() >= (width < 300 ? 1 : 8), what);
                    const double end = p + 1 < layout.panels.size()  ? layout.panels[p + 1].left()
                                       : layout.columnRights.empty() ? width + 1.0
                                                                     : layout.columnRights[0];
                    QVERIFY2(width < 200 || layout.panels[p].right() < end, what);
                }
                for (std::size_t r = 1; r < layout.rows.size(); ++r)
                    QCOMPARE(layout.rows[r].top(), layout.rows[r - 1].bottom());
                QVERIFY2(layout.bottom() <= height + 1, what);
                QVERIFY2(leastHeight(chart, width, look) < height, what);
            }
    }
    void wordsDoNotTouch()
    {
        const ChartLook look = chartLook(Ground::Light);
        const QFontMetricsF caption(captionFont(look));
        std::vector<Chart> charts = allCharts();
        charts.push_back(barsOf({123'456'789, 234'567'890}));
        for (const Chart& chart : charts)
            for (int width = 200; width < 1000; width += 37) {
                const QByteArray what = (chart.key + ' ' + QString::number(width)).toUtf8();
                const ChartLayout layout = layoutOf(chart, QRectF(0, 0, width, 400), look);
                for (std::size_t i = 0; i < layout.legend.size(); ++i) {
                    QVERIFY2(layout.legend[i].text.right() <= width + 1, what);
                    for (std::size_t k = 0; k < i; ++k)
                        QVERIFY2(!layout.legend[k].text.intersects(layout.legend[i].symbol), what);
                }
                for (std::size_t p = 0; p < layout.panels.size(); ++p)
                    for (std::size_t t = 1; t < layout.axes[p].ticks.size(); ++t) {
                        const Axis& axis = layout.axes[p];
                        const double room =
                            layout.x(p, axis.ticks[t]) - layout.x(p, axis.ticks[t - 1]);
                        const QString label = QLocale().toString(axis.ticks[t], 'f', axis.decimals);
                        QVERIFY2(room > caption.horizontalAdvance(label), what);
                    }
            }
    }
    void pointsFindTheirRow()
    {
        const Chart chart = chartOf(sample::seven(), clip(), paperTables().front());
        const ChartLook look = chartLook(Ground::Light);
        const QRectF area(20, 30, 560, 400);
        const ChartLayout layout = layoutOf(chart, area, look);
        for (std::size_t r = 0; r < chart.rows.size(); ++r) {
            const double y = layout.rows[r].center().y(), end = lengthOf(chart.rows[r]);
            QCOMPARE(rowAt({layout.x(0, end), y}, area, chart, look), r);
            QCOMPARE(rowAt({area.left() + 5, y}, area, chart, look), r);
        }
        QVERIFY(!rowAt({area.left() - 1, 200}, area, chart, look));
        QVERIFY(!rowAt(area.topLeft(), area, chart, look));
        QVERIFY(!rowAt({100, layout.rows.back().bottom() + 1}, area, chart, look));
    }
    void everythingCanBeRead()
    {
        for (const Ground ground : {Ground::Light, Ground::Dark}) {
            const ChartLook look = chartLook(ground);
            QVERIFY(contrastOf(look.text, look.paper) >= 4.5);
            QVERIFY(contrastOf(look.muted, look.paper) >= 4.5);
            for (const auto& algorithm : clipping::algorithms())
                QVERIFY2(contrastOf(algorithmColour(algorithm, ground), look.paper) >= 3,
                         algorithm.abbreviation.data());
        }
    }
};

} // namespace charts_chart_paint_test

TEST_CLASS(charts_chart_paint_test::ChartPaintTest, Gui)
#include "tests/app/charts/chart_paint_test.moc"
