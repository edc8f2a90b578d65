// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exactness/error_class.h"
#include "app/exactness/magnifier_paint.h"

#include <QLocale>
#include <QRegularExpression>
#include <QTest>

#include <cmath>

#include "tests/painted_texts.h"
#include "tests/test_class.h"

namespace exactness_magnifier_paint_test {

using namespace app;

namespace {

constexpr QSize size(400, 300);
constexpr clipping::Window window{{-100, -75}, {100, 75}};
constexpr clipping::Segment slanted{{-160, -30}, {70, 130}};

MagnifierLook look() { return {chartLook(Ground::Light), 0xC2410C, 0x1D63C9, 0xA80F86, 0xE4E7EB}; }

std::vector<PaintedText> textsOf(const Magnified& seen, const MagnifierView& view)
{
    return textsPainted(size, [&](QPainter& painter) {
        paintMagnified(painter, QRectF({}, QSizeF(size)), {seen, "MD"}, view, look());
    });
}

const PaintedText* find(const std::vector<PaintedText>& texts, const QString& words)
{
    const auto found = std::ranges::find(texts, words, &PaintedText::text);
    return found == texts.end() ? nullptr : &*found;
}

/// Of "1,000" and "1.0 × 10⁶".
double numberOf(const QString& text)
{
    const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    const QString factor = text.section(QStringLiteral(" × 10"), 0, 0);
    int exponent = 0;
    for (const QChar digit : text.section(QStringLiteral(" × 10"), 1))
        exponent = 10 * exponent + int(digits.indexOf(digit));
    return QLocale().toDouble(factor) * std::pow(10, exponent);
}

} // namespace

class MagnifierPaintTest : public QObject {
    Q_OBJECT

private slots:
    void theScaleSaysHowLargeAnUlpIs()
    {
        static const QRegularExpression form(QStringLiteral("^(.+) ulps? = (\\S+?)(?:;|$)"));
        for (const auto& row : clipping::algorithms())
            for (const double factor : {1e-6, 0.03, 1.0, 7.0}) {
                const auto seen = magnified({&row}, slanted, window, 0);
                QVERIFY(seen);
                const auto view = zoomed(usualView(*seen, QSizeF(size)), *seen, factor, {});
                const double ulp = std::max(seen->ulp.x, seen->ulp.y);
                const auto texts = textsOf(*seen, view);
                const auto scale = std::ranges::find_if(
                    texts, [](const PaintedText& t) { return form.match(t.text).hasMatch(); });
                QVERIFY2(scale != texts.end(), qPrintable(wordsOf(texts).join('|')));
                const auto parts = form.match(scale->text);
                const double ulps = numberOf(parts.captured(1));
                const double length = QLocale().toDouble(parts.captured(2).replace(u'−', u'-'));
                QVERIFY2(std::abs(length / (ulps * ulp) - 1) < 0.006, qPrintable(scale->text));
                const double pixels = length * view.pixelsPerUnit;
                QVERIFY2((pixels >= 39 && pixels <= 401) || ulps == 1, qPrintable(scale->text));
            }
    }

    void namesStandAtTheirPlaces()
    {
        const auto seen = magnified({clipping::findAlgorithm("MD")}, slanted, window, 0);
        QVERIFY(seen && seen->returned && seen->exactness);
        const MagnifierView view = usualView(*seen, QSizeF(size));
        const auto texts = textsOf(*seen, view);
        const QPointF origin = QRectF({}, QSizeF(size)).center() + view.middle;
        const auto at = [&](const glm::dvec2& offset) {
            return origin + QPointF(offset.x, offset.y) * view.pixelsPerUnit;
        };
        const auto isNear = [](const PaintedText& text, const QPointF& place) {
            return text.place.adjusted(-30, -30, 30, 30).contains(place);
        };
        const PaintedText *mine = find(texts, "MD"), *exact = find(texts, "true end"),
                          *edge = find(texts, "left edge");
        QVERIFY2(mine && exact && edge, qPrintable(wordsOf(texts).join('|')));
        QVERIFY(isNear(*mine, at({0, 0})));
        QVERIFY(isNear(*exact, at(*seen->exactness)));
        QVERIFY(std::abs(edge->place.left() - at(seen->window.min).x()) < 10);
        QVERIFY(!find(texts, "right edge") && !find(texts, "bottom edge"));
    }

    void aDescriptionTellsHowFarBothEndsAreApart()
    {
        for (const auto& row : clipping::algorithms())
            for (const int end : {0, 1}) {
                const auto seen = magnified({&row}, slanted, window, end);
                const QString text = magnifiedText(*seen, "it");
                const glm::dvec2 off = glm::abs(*seen->exactness) / seen->ulp;
                const QString expected = QStringLiteral("off by %1 in x and %2 in y.")
                                             .arg(errorText(off.x), errorText(off.y));
                QVERIFY2(text.contains(expected), qPrintable(text));
            }
    }
};

} // namespace exactness_magnifier_paint_test

TEST_CLASS(exactness_magnifier_paint_test::MagnifierPaintTest, Gui)
#include "tests/app/exactness/magnifier_paint_test.moc"
