// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/remembered.h"
#include "ui/look/look.h"

#include <QDialog>
#include <QDirIterator>
#include <QRegularExpression>
#include <QScreen>

#include <random>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

// The settings are a file that any program may have written.

namespace ui::hostile_settings_test {

class HostileSettingsTest : public QObject {
    Q_OBJECT

    // The settings that a session writes; everySettingsKeyIsTested compares them with the sources.
    static QStringList keys()
    {
        return {"theme",
                "geometry",
                "ownLayout",
                "layout",
                "panes/workspace-draw",
                "panes/workspace-cut",
                "panes/workspace-compare",
                "panes/workspace-learn",
                "snapKinds",
                "snap",
                "grid",
                "page",
                "windowDragged",
                "recent",
                "compareForms",
                "explanationZoom",
                "explanationGeometry",
                "experimentGeometry",
                "experimentPace",
                "experimentFolder",
                "stepsFolder",
                "lessonPagesFolder",
                "lessonsFolder",
                "judgeGeometry",
                "zooGeometry",
                "plugInLibrary",
                "plugInsTrusted",
                "undoMegabytes",
                "darkPaper",
                "capsule",
                "folds/workspace-draw",
                "folds/workspace-cut",
                "folds/workspace-compare",
                "folds/workspace-learn",
                "palette/recent",
                "export/choices",
                "export/drawings",
                "print/paper",
                "shortcuts",
                "lessons/done",
                "lessons/opened",
                "practice/best/cohen-sutherland:published",
                "practice/passed/cohen-sutherland:published",
                "drawings/open",
                "drawings/shown",
                "drawings/reopen"};
    }

    static bool fits(const QWidget& window)
    {
        const QSize room = window.screen()->availableSize();
        const QSize least = window.minimumSize();
        return window.width() <= std::max(room.width(), least.width())
               && window.height() <= std::max(room.height(), least.height());
    }

private slots:
    void everySettingsKeyIsTested()
    {
        QStringList known = keys();
        QDirIterator files(SOURCE_DIR, {"*.cpp", "*.h"}, QDir::Files, QDirIterator::Subdirectories);
        static const QRegularExpression literal(
            "(?:Settings\\(\\)|settings)\\.(?:setValue|value)\\(\"([A-Za-z/]+)\"");
        int found = 0;
        while (files.hasNext()) {
            const QString path = files.next();
            if (!path.startsWith(SOURCE_DIR "/ui/") && !path.startsWith(SOURCE_DIR "/app/"))
                continue;
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            auto matches = literal.globalMatch(QString::fromUtf8(file.readAll()));
            for (; matches.hasNext(); ++found) {
                const QString key = matches.next().captured(1);
                QVERIFY2(known.contains(key), qPrintable(path + ": " + key));
            }
        }
        QVERIFY(found >= 10);
    }

    void theProgramStartsWithGarbageInEveryKey_data()
    {
        QTest::addColumn<QVariant>("value");
        QTest::newRow("nothing") << QVariant(QString());
        QTest::newRow("text") << QVariant("garbage");
        QTest::newRow("long") << QVariant(QString(300'000, u'9'));
        QTest::newRow("huge") << QVariant(2147483647);
        QTest::newRow("negative") << QVariant(-2147483647 - 1);
        QTest::newRow("nan") << QVariant("nan");
        QTest::newRow("bytes") << QVariant(QByteArray("\xff\0\0\0\xfd", 5));
        QTest::newRow("huge place") << QVariant("0,0 30000x20000");
        QTest::newRow("far place") << QVariant("-99999,99999 30000x20000 maximized");
        QTest::newRow("list") << QVariant(QStringList(3000, "x"));
        QTest::newRow("shortcuts") << QVariant(
            QStringList{"undo\tCtrl+S", "nonsense\tF5", "save\t" + QString(10'000, u'S'), "\t\t"});
        QTest::newRow("exports") << QVariant(
            QStringList{"png area=moon dpi=1e300 precision=-99 background=0 paper=",
                        "svg\t/\t" + QString(9000, u'x'), "/a.svg\t/b\tgif"});
        QTest::newRow("panes") << QVariant("4 99 exact exact exact exact");
    }
    void theProgramStartsWithGarbageInEveryKey()
    {
        QFETCH(QVariant, value);
        TestWindow usual; // sets the settings' place
        usual.window.reset();
        for (const QString& key : keys())
            QSettings().setValue(key, value);
        const auto window = windowWithMenus();
        QVERIFY2(fits(*window),
                 qPrintable(QStringLiteral("%1x%2").arg(window->width()).arg(window->height())));
        window->show();
        QVERIFY(QTest::qWaitForWindowExposed(window.get()));
        QVERIFY(fits(*window));
        QVERIFY(savedTheme() == Theme::System || savedTheme() == Theme::Light
                || savedTheme() == Theme::Dark);
        for (const char* key :
             {"reproduce-paper", "hard-cases", "judge", "about-algorithm", "export", "print"})
            window->findChild<QAction*>(key)->trigger();
        QVERIFY(window->files().recent().empty());
        int dialogs = 0;
        for (const QDialog* dialog : window->findChildren<QDialog*>())
            if (dialog->isVisible()) {
                ++dialogs;
                QVERIFY2(fits(*dialog), qPrintable(dialog->objectName()));
            }
        QCOMPARE(dialogs, 4);
    }

    // QMainWindow crashes on some of these.
    void aDamagedLayoutIsIgnored()
    {
        TestWindow test;
        test.show();
        const QByteArray whole = test.window->saveState(1);
        test.window.reset();
        QSettings().setValue("ownLayout", true);
        std::mt19937 random(1);
        for (int i = 0; i < 12; ++i) {
            QByteArray damaged = i % 2 ? whole : app::sealed(whole);
            char& byte = damaged[qsizetype(random() % std::size_t(damaged.size()))];
            byte = char(byte ^ 1 << random() % 8);
            QSettings().setValue("layout", damaged);
            const auto window = windowWithMenus();
            QVERIFY(fits(*window));
        }
    }

    void theRequestedSizeIsLimitedToTheScreen()
    {
        TestWindow test;
        test.window->resize(30'000, 20'000);
        test.window->close();
        test.window = windowWithMenus();
        QVERIFY(fits(*test.window));
        test.window->resize(1100, 700);
        QSettings().setValue("geometry", "5,6 1030x650");
        const auto again = windowWithMenus();
        QCOMPARE(again->size().height(), 650);
    }
};

} // namespace ui::hostile_settings_test

TEST_CLASS(ui::hostile_settings_test::HostileSettingsTest, Widgets)
#include "tests/ui/hostile_settings_test.moc"
