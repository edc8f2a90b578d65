// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/setting.h"
#include "ui/sheets/sheets.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/sheet.h"
#include "ui/window/keyboard.h"

#include <QAbstractButton>
#include <QDockWidget>
#include <QScrollArea>

#include "tests/not_empty.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace ui::sheets_settings_sheet_test {

class SettingsSheetTest : public QObject {
    Q_OBJECT

    static QStringList shownPanels(const TestWindow& t)
    {
        QStringList names;
        for (const auto* dock : t.window->findChildren<QDockWidget*>())
            if (!dock->isHidden())
                names << dock->objectName();
        names.sort();
        return names;
    }
    static int choices(const Setting& setting)
    {
        return setting.choices.empty() ? 2 : int(setting.choices.size());
    }
    /// Calls `look` with every setting.
    static void forEach(const std::function<void(const Setting&)>& look)
    {
        for (const SettingsGroup& group : notEmpty(settingsGroups()))
            for (const Setting& setting : notEmpty(group.settings))
                look(setting);
    }

private slots:
    void everySheetTakesThePlaceOfThePanels()
    {
        for (const SheetInfo& info : notEmpty(sheets())) {
            TestWindow t;
            t.show();
            t.open(t.twoLines());
            const QStringList panels = shownPanels(t);
            QVERIFY(!panels.isEmpty());
            const app::View view = t.window->canvas().view();
            showSheet(*t.window, info.key);
            Sheet* sheet = t.window->sheet();
            QVERIFY(sheet && sheet->isVisible());
            QCOMPARE(sheet->objectName().toStdString(), std::string(info.key));
            QVERIFY(!sheet->accessibleName().isEmpty());
            QCOMPARE(shownPanels(t), QStringList());
            QVERIFY(sheet->isAncestorOf(QApplication::focusWidget()));
            QCOMPARE(sheet->mapTo(t.window.get(), sheet->rect().topRight()).x(),
                     t.window->width() - 1);
            QVERIFY(sheet->preview() ? sheet->preview()->isVisible()
                                     : t.window->canvas().isVisible());
            showSheet(*t.window, info.key); // it is the same
            QCOMPARE(t.window->sheet(), sheet);
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
            QCOMPARE(t.window->sheet(), nullptr);
            QCOMPARE(shownPanels(t), panels);
            QVERIFY(t.drawingArea()->hasFocus());
            QCOMPARE(t.window->canvas().view().zoom, view.zoom);
        }
    }

    void theDrawingStaysAliveBesideASheet()
    {
        TestWindow t;
        t.show();
        t.open(t.twoLines());
        t.run("settings");
        t.window->canvas().setFocus();
        t.run("select-all");
        t.run("delete");
        QVERIFY(t.window->session().now().objects().empty());
        QVERIFY(t.window->sheet());
        t.run("undo");
        QTest::keyClick(t.drawingArea(), Qt::Key_Escape); // deselects, or closes the sheet
        QTest::keyClick(t.drawingArea(), Qt::Key_Escape);
        QCOMPARE(t.window->sheet(), nullptr);
    }

    void aWantedPanelClosesTheSheet()
    {
        TestWindow t;
        t.show();
        t.run("settings");
        t.run("compare-live");
        QCOMPARE(t.window->sheet(), nullptr);
        QVERIFY(t.window->showsPanel("compare"));
        t.run("settings");
        t.run("workspace-draw");
        QCOMPARE(t.window->sheet(), nullptr);
        QVERIFY(t.window->showsPanel("layers"));
    }

    void theSheetStaysBesideTheMicroscopeAndWhilePresenting()
    {
        TestWindow t;
        t.show();
        t.open(t.twoLines());
        const QStringList panels = shownPanels(t);
        t.run("settings");
        for (const char* mode : {"microscope", "presentation"}) {
            t.run(mode);
            QVERIFY(t.window->sheet() && t.window->sheet()->isVisible());
            QCOMPARE(shownPanels(t), QStringList());
            t.run(mode);
        }
        t.window->closeSheet();
        QCOMPARE(shownPanels(t), panels);
    }

    void tilesAndASheetCloseEachOther()
    {
        TestWindow t;
        t.show();
        t.open(t.twoLines());
        const QStringList panels = shownPanels(t);
        t.run("settings");
        t.run("tiles");
        QVERIFY(t.window->sheets().isOpen() && !t.window->sheet());
        t.run("settings");
        QVERIFY(!t.window->sheets().isOpen() && t.window->sheet());
        QVERIFY(t.window->sheet()->isAncestorOf(QApplication::focusWidget()));
        t.window->closeSheet();
        QCOMPARE(shownPanels(t), panels);
    }

    void everySettingTakesEffectAndIsReset()
    {
        TestWindow t;
        t.show();
        t.run("settings");
        forEach([&t](const Setting& setting) {
            MainWindow& window = *t.window;
            const int standard = setting.standard(window);
            for (int value = 0; value < choices(setting); ++value) {
                change(setting, window, value);
                QCOMPARE(setting.value(window), value);
                auto* reset = window.sheet()->findChild<QAbstractButton*>("reset-" + setting.key);
                QCOMPARE(reset->isHidden(), value == standard);
                if (const auto* box = window.sheet()->findChild<QAbstractButton*>(
                        QStringLiteral("setting-") + setting.key))
                    QCOMPARE(box->isChecked(), value == 1);
                if (const auto* row = window.sheet()->findChild<Segments*>(
                        QStringLiteral("setting-") + setting.key))
                    QCOMPARE(row->chosen(), value);
                if (value != standard)
                    reset->click();
                QCOMPARE(setting.value(window), standard);
            }
        });
    }

    void theKindsOfSnappingArePartsOfIt()
    {
        TestWindow t;
        t.show();
        t.run("settings");
        const auto box = [&t](const char* name) {
            return t.window->sheet()->findChild<QAbstractButton*>(name);
        };
        const auto left = [&](const char* name) {
            return box(name)->mapTo(t.window->sheet(), QPoint()).x();
        };
        QVERIFY(left("setting-snap-to-ends") > left("setting-snap"));
        QVERIFY(box("setting-snap-to-ends")->isEnabled());
        t.run("snap");
        QVERIFY(!box("setting-snap-to-ends")->isEnabled());
        QVERIFY(box("setting-snap")->isEnabled());
        QVERIFY(!box("setting-snap")->text().endsWith(u':'));
        QCOMPARE(box("reset-snap-to-ends")->toolTip(),
                 QStringLiteral("Reset “Snap to: Ends” to standard"));
    }

    void aClickSetsAndAllIsReset()
    {
        TestWindow t;
        t.show();
        t.run("settings");
        const auto click = [&t](const char* name) {
            t.window->sheet()->findChild<QAbstractButton*>(name)->click();
        };
        const auto homes =
            t.window->sheet()->findChild<QWidget*>("setting-capsule")->findChildren<QToolButton*>();
        homes[2]->click();
        QCOMPARE(t.window->canvas().capsuleHome(), app::CapsuleHome::Off);
        click("setting-snap");
        QVERIFY(!t.window->canvas().snaps());
        click("reset-settings");
        QCOMPARE(t.window->canvas().capsuleHome(), app::CapsuleHome::AtObject);
        QVERIFY(t.window->canvas().snaps());
        click("done");
        QCOMPARE(t.window->sheet(), nullptr);
    }

    /// No choice has the unit of this page.
    void theUnitOfThePageIsSetAgain()
    {
        TestWindow t;
        t.show();
        t.open(t.file("picas.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='40pc' "
                                   "height='40pc' viewBox='0 0 40 40'/>"));
        const auto unit = [&t] { return t.window->session().display().unit; };
        QCOMPARE(unit(), app::Unit::Pc);
        t.run("settings");
        for (const char* button : {"reset-unit", "reset-settings"}) {
            t.run("unit-mm");
            QCOMPARE(unit(), app::Unit::Mm);
            t.window->sheet()->findChild<QAbstractButton*>(button)->click();
            QCOMPARE(unit(), app::Unit::Pc);
        }
        forEach([&t](const Setting& setting) {
            const int before = setting.value(*t.window);
            change(setting, *t.window, -1);
            QCOMPARE(setting.value(*t.window), before);
        });
    }

    /// Those that a drawing brings are not.
    void settingsAreRemembered()
    {
        TestWindow t;
        const auto other = [](const Setting& setting, const MainWindow& window) {
            return setting.standard(window) == 0 ? 1 : 0;
        };
        forEach([&](const Setting& s) { change(s, *t.window, other(s, *t.window)); });
        t.window = windowWithMenus();
        forEach([&](const Setting& setting) {
            if (setting.key != u"unit")
                QCOMPARE(setting.value(*t.window), other(setting, *t.window));
        });
        forEach([&](const Setting& s) { change(s, *t.window, s.standard(*t.window)); });
    }

    void everySettingHasCommands()
    {
        const TestWindow t;
        QStringList names;
        for (const QAction* action : commands(*t.window))
            names << action->objectName();
        forEach([&names](const Setting& setting) {
            if (setting.choices.empty())
                QVERIFY2(names.contains(setting.key), qPrintable(setting.key));
            for (const Setting::Choice& choice : setting.choices)
                QVERIFY2(setting.key == u"theme" || names.contains(choice.key),
                         qPrintable(choice.key));
        });
    }

    void theSheetFitsSmallWindows()
    {
        TestWindow t;
        t.window->resize(1024, 640);
        t.show();
        t.run("settings");
        const auto* scrolled = t.window->sheet()->findChild<QScrollArea*>();
        QVERIFY(t.window->sheet()->width() < 420);
        QVERIFY(scrolled->widget()->minimumSizeHint().width() <= scrolled->viewport()->width());
        t.window->resize(1440, 900);
        QTRY_COMPARE(t.window->sheet()->width(), 420);
    }
};

} // namespace ui::sheets_settings_sheet_test

TEST_CLASS(ui::sheets_settings_sheet_test::SettingsSheetTest, Widgets)
#include "tests/ui/sheets/settings_sheet_test.moc"
