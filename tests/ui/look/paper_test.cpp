// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/buttons.h"

#include <QSettings>
#include <QToolButton>

#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace look_paper_test {

using namespace ui;

namespace {

/// A drawing with a black line, in the window and out of it, on a page of 200 x 100.
struct Drawing : TestWindow {
    Drawing()
    {
        app::Sheet sheet;
        sheet.page = {{0, 0}, {200, 100}, {200, app::Unit::Mm}, {100, app::Unit::Mm}};
        sheet.window = {{50, 20}, {150, 80}};
        app::Shape line;
        line.paths = {{{10, 50}, {{{190, 50}}}}};
        line.style.stroke = app::Colour{};
        line.style.width = 4;
        sheet.shapes = {line};
        session().load({app::documentOf(sheet), {}});
        show();
        window->canvas().fitPage();
    }
    app::Session& session() const { return window->session(); }
    QColor at(app::Point p) const
    {
        window->canvas().settle();
        QWidget& drawing = *drawingArea();
        const app::Point s = window->canvas().view().toScreen(p);
        const QImage image = drawing.grab().toImage();
        const double ratio = image.devicePixelRatio();
        return image.pixelColor(qRound(s.x * ratio), qRound(s.y * ratio));
    }
    QColor page() const { return at({100, 90}); }
    QColor kept() const { return at({100, 50}); }
    QColor ghost() const { return at({20, 50}); }
    QColor outline() const { return at({75, 20}); } // beside the handles
    void choose(Theme theme) const
    {
        window->setTheme(theme);
        QCoreApplication::processEvents();
    }
    QToolButton& paperSwitch() const
    {
        return *window->findChild<QToolButton*>("dark-paper-switch");
    }
};

int distance(const QColor& a, const QColor& b)
{
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green())
           + std::abs(a.blue() - b.blue());
}

} // namespace

/// The paper is white in both themes; dark paper is a switch of its own.
class PaperTest : public QObject {
    Q_OBJECT

    static void themes()
    {
        QTest::addColumn<int>("theme");
        QTest::newRow("light") << int(Theme::Light);
        QTest::newRow("dark") << int(Theme::Dark);
    }

private slots:
    void thePaperIsWhite_data() { themes(); }
    void thePaperIsWhite()
    {
        QFETCH(int, theme);
        const Drawing t;
        t.choose(Theme(theme));
        QCOMPARE(t.page(), QColor(Qt::white));
        QCOMPARE(t.kept(), QColor(Qt::black));
        const QColor grey = t.ghost();
        QVERIFY2(std::abs(grey.red() - 179) <= 2, qPrintable(grey.name())); // 30 % of black
    }
    void overlaysFollowThePaper_data() { themes(); }
    void overlaysFollowThePaper()
    {
        QFETCH(int, theme);
        const Drawing t;
        t.choose(Theme(theme));
        const Look &light = lookOf(Theme::Light), &dark = lookOf(Theme::Dark);
        QVERIFY(distance(t.outline(), light.accent) < 60);
        t.run("dark-paper");
        QVERIFY(t.action("dark-paper")->isChecked());
        QCOMPARE(t.page(), dark.paper);
        QVERIFY(t.kept().lightness() > 128); // black is shown lighter
        QVERIFY(distance(t.outline(), dark.accent) < 60);
        t.run("dark-paper");
        QCOMPARE(t.page(), QColor(Qt::white));
    }
    void theThemeChangesLive()
    {
        const Drawing t;
        t.choose(Theme::Light);
        t.window->canvas().settle();
        const QImage light = t.drawingArea()->grab().toImage();
        t.choose(Theme::Dark);
        t.window->canvas().settle();
        QCOMPARE(t.drawingArea()->grab().toImage(), light); // it is all on white paper
        t.run("dark-paper");
        const QColor dark = t.page();
        t.choose(Theme::Light);
        QCOMPARE(t.page(), dark);
    }
    void theStatusBarHasASwitchInTheDarkTheme()
    {
        const Drawing t;
        t.choose(Theme::Light);
        QVERIFY(!t.paperSwitch().isVisible());
        t.choose(Theme::Dark);
        QVERIFY(t.paperSwitch().isVisible() && !t.paperSwitch().isChecked());
        QTest::mouseClick(&t.paperSwitch(), Qt::LeftButton);
        QVERIFY(t.session().display().darkPaper);
        QVERIFY(t.page() != QColor(Qt::white));
        t.run("dark-paper");
        QVERIFY(!t.paperSwitch().isChecked());
    }
    void itIsOffAtFirstAndRemembered()
    {
        const Drawing t;
        QVERIFY(!t.session().display().darkPaper);
        t.run("dark-paper");
        QCOMPARE(QSettings().value("darkPaper").toBool(), true);
        const auto next = windowWithMenus();
        QVERIFY(next->session().display().darkPaper);
        t.run("dark-paper");
        QCOMPARE(QSettings().value("darkPaper").toBool(), false);
    }
    void thumbnailsAreOnWhitePaper_data() { themes(); }
    void thumbnailsAreOnWhitePaper()
    {
        QFETCH(int, theme);
        applyTheme(*qApp, Theme(theme));
        SampleButton button(QStringLiteral("Sample"), nullptr);
        button.resize(120, SampleButton::heightFor(120)); // its picture is not painted yet
        const QImage shown = button.grab().toImage();
        QCOMPARE(shown.pixelColor(shown.width() / 2, shown.height() / 3), QColor(Qt::white));
    }
};

} // namespace look_paper_test

TEST_CLASS(look_paper_test::PaperTest, Widgets)
#include "tests/ui/look/paper_test.moc"
