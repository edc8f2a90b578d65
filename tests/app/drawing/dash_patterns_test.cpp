// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/dash_patterns.h"

#include <QTest>

#include "tests/test_class.h"

namespace drawing_dash_patterns_test {

class DashPatternsTest : public QObject {
    Q_OBJECT

    using Dashes = std::vector<double>;
    static constexpr app::Scale millimetres{app::Unit::Mm, 1};

    static Dashes typed(const char* text, const app::Scale& scale = millimetres,
                        const QLocale& locale = QLocale::c())
    {
        const auto dashes = app::typedDashes(QString::fromUtf8(text), scale, locale);
        return dashes ? *dashes.value : Dashes{-1};
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void everyPatternIsFoundAgain()
    {
        for (std::size_t i = 0; i < app::dashPatterns().size(); ++i) {
            app::Style style{.width = 0.35};
            style.dashes = app::scaled(app::dashPatterns()[i], style.width);
            QCOMPARE(app::patternOf(style), std::optional(i));
        }
        QCOMPARE(app::patternOf({.dashes = {6, 4}}), std::nullopt);
    }
    void usualPatternGrowsWithTheWidthAndAnOwnOneStays()
    {
        app::Style style{.width = 2, .dashes = {12, 6}};
        app::setWidth(style, 3);
        QCOMPARE(style.dashes, (Dashes{18, 9}));
        app::setWidth(style, 0); // has no pattern
        app::setWidth(style, 3);
        QCOMPARE(style.dashes, (Dashes{18, 9}));
        style.dashes = {5, 1};
        app::setWidth(style, 1);
        QCOMPARE(style.dashes, (Dashes{5, 1}));
    }
    void lengthsAreTypedWithUnitsAndSums()
    {
        QCOMPARE(typed("3 1 0.5 1"), (Dashes{3, 1, 0.5, 1}));
        QCOMPARE(typed("3mm 1 mm;0.5 mm, 1"), (Dashes{3, 1, 0.5, 1}));
        QCOMPARE(typed("1in 2+1"), (Dashes{25.4, 3}));
        QCOMPARE(typed("1cm 1", {app::Unit::Mm, 2}), (Dashes{5, 0.5})); // 2 mm is a unit
        QCOMPARE(typed("1,5; 2", millimetres, QLocale(QLocale::German)), (Dashes{1.5, 2}));
        QCOMPARE(typed("  "), Dashes());
    }
    void badPatternsAreRefusedWithASentence()
    {
        for (const char* text : {"abc", "3 -1", "0 0", "nan 1", "1e999", "3mm 2kg"}) {
            const auto dashes = app::typedDashes(text, millimetres, QLocale::c());
            QVERIFY2(!dashes && dashes.error.endsWith(u'.'), text);
        }
        QVERIFY(!app::typedDashes(QString("1 ").repeated(33), millimetres, QLocale::c()));
    }
    void shownTextIsReadBack()
    {
        const Dashes dashes{3, 1, 0.5, 1};
        QCOMPARE(app::dashesText(dashes, millimetres), QString("3 1 0.5 1 mm"));
        QCOMPARE(typed("3 1 0.5 1 mm"), dashes);
        QCOMPARE(app::dashesText(dashes, {app::Unit::User, 1}), QString("3 1 0.5 1"));
        QCOMPARE(app::dashesText({}, millimetres), QString());
    }
};

} // namespace drawing_dash_patterns_test

TEST_CLASS(drawing_dash_patterns_test::DashPatternsTest, None)
#include "tests/app/drawing/dash_patterns_test.moc"
