// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers and words in a chart are those of its rows, and stand beside what they describe.
#include "app/charts/chart_layout.h"

#include <QLocale>
#include <QTest>

#include "tests/app/charts/sample_charts.h"
#include "tests/painted_texts.h"
#include "tests/test_class.h"

namespace charts_chart_texts_test {

using namespace app;

namespace {

constexpr QSize size(1000, 900);

std::vector<Chart> charts()
{
    const Measure clip = measures().front();
    return {chartOf(sample::seven(), clip),
            chartOf(sample::everything(), clip),
            chartOf(sample::seven(), clip, paperTables().front()),
            boxPlotOf(sample::seven(), clip),
            chartOf(paperTables().front()),
            chartOf(sample::operations()),
            chartOf(sample::classes())};
}

std::vector<PaintedText> textsOf(const Chart& chart)
{
    return textsPainted(size, [&](QPainter& painter) {
        paint(painter, QRectF({}, QSizeF(size)), chart, chartLook(Ground::Light));
    });
}

bool contains(const std::vector<PaintedText>& texts, const QRectF& area, const QString& words)
{
    return words.isEmpty() || std::ranges::any_of(texts, [&](const PaintedText& text) {
               return text.text == words && area.contains(text.place.center());
           });
}

} // namespace

class ChartTextsTest : public QObject {
    Q_OBJECT

private slots:
    void everyRowHasItsNameAndItsNumbers()
    {
        for (const Chart& chart : charts()) {
            const ChartLayout layout =
                layoutOf(chart, QRectF({}, QSizeF(size)), chartLook(Ground::Light));
            const auto texts = textsOf(chart);
            for (std::size_t r = 0; r < chart.rows.size(); ++r) {
                const ChartRow& row = chart.rows[r];
                const QString where = chart.key + ", " + row.name;
                QVERIFY2(contains(texts, layout.rows[r], row.name), qPrintable(where));
                if (layout.values)
                    QVERIFY2(contains(texts, layout.rows[r], row.value), qPrintable(where));
                for (std::size_t i = 0; i < layout.columnRights.size(); ++i)
                    QVERIFY2(contains(texts, layout.rows[r], row.numbers.value(qsizetype(i))),
                             qPrintable(where));
                for (const Figure& figure : row.figures)
                    if (const auto* bar = std::get_if<Bar>(&figure))
                        QVERIFY2(contains(texts, layout.rows[r], bar->text), qPrintable(where));
            }
            for (const RowGroup& group : chart.groups) {
                const QRectF rows =
                    layout.rows[group.rows.front()].united(layout.rows[group.rows.back()]);
                QVERIFY2(contains(texts, rows, group.letter), qPrintable(group.letter));
            }
        }
    }

    void theNumbersOfAnAxisAreAsFarApartAsTheySay()
    {
        for (const Chart& chart : charts()) {
            const ChartLayout layout =
                layoutOf(chart, QRectF({}, QSizeF(size)), chartLook(Ground::Light));
            std::vector<PaintedText> numbers;
            for (const PaintedText& text : textsOf(chart))
                if (layout.ticks.contains(text.place.center())
                    && text.place.center().x() <= layout.panels.front().right() + 1)
                    numbers.push_back(text);
            QVERIFY2(numbers.size() >= 3, qPrintable(chart.key));
            const auto valueOf = [](const PaintedText& text) {
                return QLocale().toDouble(QString(text.text).replace(u'−', u'-'));
            };
            const auto placeOf = [](const PaintedText& text) { return text.place.center().x(); };
            // The outer labels may be moved, so as not to touch those of the next panel.
            const PaintedText &one = numbers[0], &two = numbers[1];
            const double scale = (placeOf(two) - placeOf(one)) / (valueOf(two) - valueOf(one));
            for (std::size_t i = 1; i + 1 < numbers.size(); ++i) {
                const double expected = placeOf(one) + scale * (valueOf(numbers[i]) - valueOf(one));
                QVERIFY2(std::abs(placeOf(numbers[i]) - expected) < 1.5,
                         qPrintable(chart.key + ": " + numbers[i].text));
            }
        }
    }

    void theHeadIsComplete()
    {
        for (const Chart& chart : charts()) {
            const QString all = wordsOf(textsOf(chart)).join(u' ');
            for (const QString& words : QStringList{chart.title, chart.subtitle})
                for (const QString& word : words.split(u' ', Qt::SkipEmptyParts))
                    QVERIFY2(all.contains(word), qPrintable(chart.key + ": " + word));
            for (const LegendEntry& entry : chart.legend)
                for (const QString& word : entry.text.split(u' ', Qt::SkipEmptyParts))
                    QVERIFY2(all.contains(word), qPrintable(chart.key + ": " + word));
            for (const Panel& panel : chart.panels)
                QVERIFY2(all.contains(panel.unit), qPrintable(chart.key + ": " + panel.unit));
        }
    }
};

} // namespace charts_chart_texts_test

TEST_CLASS(charts_chart_texts_test::ChartTextsTest, Gui)
#include "tests/app/charts/chart_texts_test.moc"
