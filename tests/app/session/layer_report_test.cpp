// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/session/layer_colour.h"

#include <QElapsedTimer>
#include <QTest>

#include <random>

#include "tests/test_class.h"

namespace session_layer_report_test {

using namespace app;

namespace {

using MaybeColour = std::optional<Colour>;

const Style bare{};
const Style thinBare{.width = 0.5};
const Style red{.stroke = Colour{255, 0, 0}};
const Style areaInGreen{.fill = Colour{0, 255, 0}};

/// A layer of each list, of short lines in those styles.
Document layersOf(const std::vector<std::vector<Style>>& layers)
{
    DocumentBuilder builder;
    double x = 0;
    for (const auto& styles : layers) {
        builder.open({});
        for (const Style& style : styles)
            builder.addLine({{++x, 0}, {x, 1}}, builder.style(style));
        builder.close();
    }
    return builder.take({});
}

MaybeColour colourOfLayer(const Document& document, std::size_t layer)
{
    return strokeColourOf(document, document.containers().childrenOf(0).at(layer));
}

/// One object after the other.
MaybeColour firstColour(const Document& document, ContainerId container)
{
    const ObjectRange range = document.containers().rangeOf(container);
    for (std::size_t i = range.first; i < range.end; ++i)
        if (const Style& style = document.objects()[i].style(); style.stroke || style.fill)
            return style.stroke ? style.stroke : style.fill;
    return std::nullopt;
}

double milliseconds(const std::function<void()>& call)
{
    QElapsedTimer timer;
    timer.start();
    call();
    return double(timer.nsecsElapsed()) * 1e-6;
}

} // namespace

class LayerReportTest : public QObject {
    Q_OBJECT

private slots:
    void theFirstStrokeColourStandsForALayer()
    {
        const Document document = layersOf(
            {{red}, {bare, areaInGreen, red}, {}, {thinBare, bare}, {bare, thinBare, red, bare}});
        QCOMPARE(colourOfLayer(document, 0), red.stroke);
        QCOMPARE(colourOfLayer(document, 1), areaInGreen.fill);
        QCOMPARE(colourOfLayer(document, 2), MaybeColour());
        QCOMPARE(colourOfLayer(document, 3), MaybeColour());
        QCOMPARE(colourOfLayer(document, 4), red.stroke);
    }
    void itIsThatOfTheFirstObjectWithOne()
    {
        std::mt19937 random(3);
        for (int round = 0; round < 20; ++round) {
            std::vector<std::vector<Style>> layers(4);
            for (auto& layer : layers) {
                layer.resize(random() % 12'000); // blocks have some 4,000 lines
                const std::size_t plain = random() % (layer.size() + 1);
                for (std::size_t i = 0; i < layer.size(); ++i)
                    layer[i] = i < plain ? bare : std::array{bare, red, areaInGreen}[random() % 3];
            }
            const Document document = layersOf(layers);
            for (const ContainerId id : document.containers().childrenOf(0))
                QCOMPARE(strokeColourOf(document, id), firstColour(document, id));
        }
    }
    void aMillionObjectsWithoutColourCostNothing_data()
    {
        QTest::addColumn<std::vector<Style>>("styles");
        QTest::addRow("all alike") << std::vector{bare};
        QTest::addRow("by turns") << std::vector{bare, thinBare};
    }
    void aMillionObjectsWithoutColourCostNothing()
    {
        QFETCH(std::vector<Style>, styles);
        std::vector<Style> layer;
        for (std::size_t i = 0; i < 1'000'000; ++i)
            layer.push_back(styles[i % styles.size()]);
        const Document document = layersOf({layer});
        const ContainerId id = document.containers().childrenOf(0).front();
        MaybeColour colour = Colour{}, first = Colour{};
        const double quick = milliseconds([&] { colour = strokeColourOf(document, id); });
        const double whole = milliseconds([&] { first = firstColour(document, id); });
        QCOMPARE(colour, MaybeColour());
        QCOMPARE(first, MaybeColour());
        QVERIFY2(quick < whole / 20, qPrintable(QString("%1 of %2 ms").arg(quick).arg(whole)));
    }
};

} // namespace session_layer_report_test

TEST_CLASS(session_layer_report_test::LayerReportTest, Core)
#include "tests/app/session/layer_report_test.moc"
