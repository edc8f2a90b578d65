// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/algorithm_mark.h"

#include <QImage>
#include <QPainter>
#include <QTest>

#include <algorithm>
#include <array>
#include <set>

#include "tests/test_class.h"

namespace view_algorithm_mark_test {

using namespace app;
using clipping::Form;

namespace {

constexpr int size = 48;

QImage markerOf(const clipping::Algorithm& algorithm, Form form)
{
    QImage image(size, size, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    paintMarker(painter, QRectF(0, 0, size, size), {&algorithm, form}, Ground::Light);
    return image;
}

/// Pixels that are rather painted than not.
int painted(const QImage& image)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += qGray(image.pixel(x, y)) < 240;
    return count;
}

/// Without colour.
QImage figureOf(const clipping::Algorithm& algorithm)
{
    QImage figure = markerOf(algorithm, Form::Corrected).convertToFormat(QImage::Format_Grayscale8);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            figure.scanLine(y)[x] = figure.scanLine(y)[x] < 240 ? 0 : 255;
    return figure;
}

} // namespace

class AlgorithmMarkTest : public QObject {
    Q_OBJECT

private slots:
    void everyAlgorithmHasItsOwnMark()
    {
        for (const Ground ground : {Ground::Light, Ground::Dark}) {
            std::set<QRgb> colours;
            for (const auto& algorithm : clipping::algorithms())
                colours.insert(algorithmColour(algorithm, ground).rgb());
            QCOMPARE(colours.size(), clipping::algorithms().size());
        }
        const auto all = clipping::algorithms();
        for (std::size_t a = 0; a < all.size(); ++a)
            for (std::size_t b = a + 1; b < all.size(); ++b) {
                const QByteArray pair = QByteArray(all[a].key.data()) + ' ' + all[b].key.data();
                QVERIFY2(figureOf(all[a]) != figureOf(all[b]), pair);
            }
    }
    /// A new algorithm needs no mark of its own.
    void rowsWithoutAMarkDifferFromAllOthers()
    {
        std::vector<clipping::Algorithm> rows(clipping::algorithms().begin(),
                                              clipping::algorithms().end());
        static constexpr std::array<std::string_view, 6> added{"a", "b", "c", "d", "e", "f"};
        for (const std::string_view key : added) {
            rows.push_back(rows.front());
            rows.back().key = rows.back().abbreviation = key;
        }
        std::set<QRgb> light, dark;
        std::vector<QPainterPath> paths;
        for (const clipping::Algorithm& row : rows) {
            const AlgorithmMark mark = markOf(row, rows);
            light.insert(mark.light.rgb());
            dark.insert(mark.dark.rgb());
            QVERIFY2(std::ranges::find(paths, mark.path) == paths.end(), row.key.data());
            paths.push_back(mark.path);
            QVERIFY(qGray(mark.light.rgb()) < qGray(mark.dark.rgb()));
        }
        QCOMPARE(light.size(), rows.size());
        QCOMPARE(dark.size(), rows.size());
        QCOMPARE(markOf(rows.back()).path, markOf({}).path); // it is in no catalogue
    }
    void hollowMarkersHaveTheSameOutline()
    {
        for (const auto& algorithm : clipping::algorithms()) {
            if (!algorithm.published)
                continue;
            const QImage filled = markerOf(algorithm, Form::Corrected),
                         hollow = markerOf(algorithm, Form::Published);
            QVERIFY2(painted(hollow) < 0.95 * painted(filled), algorithm.key.data());
            QVERIFY2(painted(hollow) > 0.2 * painted(filled), algorithm.key.data());
        }
    }
    void markersStayInTheirBoxes()
    {
        for (const auto& algorithm : clipping::algorithms())
            for (const Form form : {Form::Corrected, Form::Published}) {
                QImage image(size, size, QImage::Format_RGB32);
                image.fill(Qt::white);
                QPainter painter(&image);
                paintMarker(painter, QRectF(12, 12, 24, 24), {&algorithm, form}, Ground::Light);
                painter.end();
                const int within = painted(image.copy(11, 11, 26, 26));
                QVERIFY2(within > 0 && painted(image) == within, algorithm.key.data());
            }
    }
};

} // namespace view_algorithm_mark_test

TEST_CLASS(view_algorithm_mark_test::AlgorithmMarkTest, Gui)
#include "tests/app/view/algorithm_mark_test.moc"
