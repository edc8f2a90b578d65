// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/recent_colours.h"
#include "app/view/colour_chart.h"

#include <QTemporaryDir>
#include <QTest>

#include "tests/test_class.h"

namespace session_typed_colour_test {

using app::Colour;

// Colours as people type them, and those that they picked last.
class TypedColourTest : public QObject {
    Q_OBJECT

    static std::optional<Colour> typed(const char* text) { return app::typedColour(text).value; }

private slots:
    void digitsAndNamesAreRead()
    {
        const std::optional brown = Colour{0x8A, 0x5A, 0x2B};
        for (const char* text : {"#8A5A2B", "8a5a2b", " #8a5A2b ", "rgb(138, 90, 43)"})
            QCOMPARE(typed(text), brown);
        QCOMPARE(typed("f00"), std::optional(Colour{255, 0, 0}));
        QCOMPARE(typed("#8A5A2B80"), std::optional(Colour{0x8A, 0x5A, 0x2B, 0x80}));
        QCOMPARE(typed("teal"), std::optional(Colour{0, 128, 128}));
    }
    void otherTextIsRefusedWithASentence()
    {
        for (const char* text : {"", "#12345", "colour", "12345g", "#"}) {
            const auto colour = app::typedColour(text);
            QVERIFY2(!colour && colour.error.endsWith(u'.'), text);
        }
    }
    void digitsAreReadBack()
    {
        for (const Colour colour : {Colour{1, 2, 3}, Colour{255, 0, 171, 7}})
            QCOMPARE(app::typedColour(app::hexText(colour)).value, std::optional(colour));
        QCOMPARE(app::hexText({138, 90, 43}), QString("#8A5A2B"));
    }
    void newestColoursAreRememberedOnce()
    {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath("a.ini"), QSettings::IniFormat);
        for (int i = 0; i < 20; ++i)
            app::rememberColour(settings, {std::uint8_t(i), 0, 0});
        app::rememberColour(settings, {15, 0, 0});
        const auto recent = app::recentColours(settings);
        QCOMPARE(recent.size(), app::mostRecentColours);
        QCOMPARE(recent.front(), (Colour{15, 0, 0}));
        QCOMPARE(recent[1], (Colour{19, 0, 0}));
        QCOMPARE(std::ranges::count(recent, Colour{15, 0, 0}), 1);
    }
    void damagedSettingsGiveTheColoursThatAreLeft()
    {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath("a.ini"), QSettings::IniFormat);
        settings.setValue("recentColours", QStringList{"abcx", "#010203", "", "#010203"});
        QCOMPARE(app::recentColours(settings), (std::vector{Colour{1, 2, 3}}));
    }
    void chartHasPureColoursInWholeRows()
    {
        const auto chart = app::colourChart();
        QCOMPARE(chart.size() % app::coloursInRow, std::size_t(0));
        for (const Colour pure :
             {Colour{0, 0, 0}, Colour{255, 255, 255}, Colour{255, 0, 0}, Colour{0, 255, 0},
              Colour{0, 0, 255}, Colour{0, 255, 255}, Colour{255, 0, 255}, Colour{255, 255, 0}})
            QVERIFY2(std::ranges::count(chart, pure) == 1, qPrintable(app::hexText(pure)));
    }
};

} // namespace session_typed_colour_test

TEST_CLASS(session_typed_colour_test::TypedColourTest, None)
#include "tests/app/session/typed_colour_test.moc"
