// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/recent_files.h"
#include "app/settings/remembered.h"
#include "app/settings/settings_format.h"
#include "app/settings/window_place.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "tests/app/command_line/program.h"
#include "tests/app/formats/failing_disk.h"
#include "tests/test_class.h"

namespace settings_settings_test {

using namespace app;

class SettingsTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString file() const { return folder_.filePath("Clearcut/Clearcut.ini"); }

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName("Clearcut");
        QCoreApplication::setApplicationName("Clearcut");
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
        useSafeSettings();
        QCOMPARE(QSettings().fileName(), file());
    }
    void init() { QSettings().clear(); }

    void everyTypeComesBack()
    {
        const QByteArray bytes("\0\xff\x80 a", 5);
        const QStringList list{"a", "b, c", QString()};
        {
            QSettings settings;
            settings.setValue("whole", -7);
            settings.setValue("real", 0.1);
            settings.setValue("truth", true);
            settings.setValue("text", "é \" \\ \n@Variant");
            settings.setValue("list", list);
            settings.setValue("none", QStringList());
            settings.setValue("bytes", bytes);
        }
        QVERIFY(!QJsonDocument::fromJson(contentOf(file())).isNull());
        writeText(folder_.filePath("copy"), contentOf(file())); // read anew, not from memory
        const QSettings read(folder_.filePath("copy"), QSettings().defaultFormat());
        QCOMPARE(read.value("whole").toInt(), -7);
        QCOMPARE(read.value("real").toDouble(), 0.1);
        QCOMPARE(read.value("truth").toBool(), true);
        QCOMPARE(read.value("text").toString(), "é \" \\ \n@Variant");
        QCOMPARE(read.value("list").toStringList(), list);
        QCOMPARE(read.value("none").toStringList(), QStringList());
        QCOMPARE(read.value("bytes").toByteArray(), bytes);
    }

    // It names files that were opened.
    void onlyTheUserCanReadThem()
    {
        const auto others =
            QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther;
        const auto save = [] {
            QSettings settings;
            settings.setValue("recent", QStringList{"/home/me/plan.svg"});
        };
        const auto isMine = [&] { return (QFile::permissions(file()) & others) == 0; };
        QFile::remove(file());
        save();
        QVERIFY(QFile::exists(file()) && isMine());
        const auto wide = QFile::ReadOwner | QFile::WriteOwner | others;
        QVERIFY(QFile::setPermissions(file(), wide)); // as earlier versions left it
        QSettings().setValue("recent", QStringList{"/home/me/other.svg"});
        QVERIFY(isMine());
        QVERIFY(QFile::setPermissions(file(), wide));
        useSafeSettings(); // the next start
        QVERIFY(isMine());
        QCOMPARE(QSettings().value("recent").toStringList(), QStringList{"/home/me/other.svg"});
    }

    void garbageIsNoSettings()
    {
        std::mt19937 random(1);
        const QByteArray json = R"({"a": 1, "b": ["x", "y"], "c": {"base64": "AAEC"}})";
        std::vector<QByteArray> files{"{",
                                      "{}",
                                      "[1]",
                                      "{\"a\": {\"a\": {}}}",
                                      "\0\0\0",
                                      "[General]\na=@Variant(\\0\\0\\0\\x41\\xff\\xff\\xff\\xff)",
                                      QByteArray("{\"a\":").repeated(5000),
                                      QByteArray(3'000'000, '{'),
                                      QByteArray(3'000'000, 'a')};
        const QByteArray ini = "[General]\na=\"x\\x7f\\0,\", y;\nb=@ByteArray(\\0)\n[c]\nd\\e=@@";
        for (int i = 0; i < 400; ++i) {
            const QByteArray& whole = i % 2 ? ini : json;
            QByteArray damaged = whole.left(qsizetype(random() % std::size_t(whole.size())) + 1);
            damaged[qsizetype(random() % std::size_t(damaged.size()))] = char(random());
            files.push_back(damaged);
        }
        for (std::size_t i = 0; i < files.size(); ++i) {
            const QString path = folder_.filePath(QStringLiteral("garbage%1").arg(i));
            writeText(path, files[i]);
            QSettings settings(path, QSettings().defaultFormat());
            for (const QString& key : settings.allKeys())
                QVERIFY(settings.value(key).isValid());
            settings.setValue("new", 1); // and it can be used
            settings.sync();
            QCOMPARE(QSettings(path, QSettings().defaultFormat()).value("new").toInt(), 1);
        }
    }

    // QSettings' own formats leave an empty file behind.
    void aFullDiskLeavesTheOldSettings()
    {
        QSettings settings;
        settings.setValue("a", "old");
        settings.sync();
        const QByteArray old = contentOf(file());
        QVERIFY(old.contains("old"));
        const auto size = std::size_t(old.size());
        settings.setValue("a", "new");
        for (std::size_t full = 0; full < size; ++full) {
            const disk::Failing failing(disk::Step::Write, full);
            settings.sync();
            QVERIFY2(contentOf(file()) == old, qPrintable(QString::number(full)));
        }
        for (const auto step : {disk::Step::Sync, disk::Step::Rename}) {
            const disk::Failing failing(step);
            settings.sync();
            QCOMPARE(contentOf(file()), old);
        }
        QCOMPARE(QDir(QFileInfo(file()).path()).entryList(QDir::Files | QDir::Hidden),
                 QStringList{"Clearcut.ini"});
        settings.sync(); // the disk has room again
        QVERIFY(contentOf(file()).contains("new"));
    }

    void noDamagedBitIsTakenForWhatWasSealed()
    {
        for (const QByteArray& bytes : {QByteArray(), QByteArray("\0\xff layout", 9)}) {
            const QByteArray seal = sealed(bytes);
            QCOMPARE(unsealed(seal), std::optional(bytes));
            for (qsizetype i = 0; i < seal.size(); ++i) {
                QVERIFY(!unsealed(seal.left(i)));
                for (int bit = 0; bit < 8; ++bit) {
                    QByteArray damaged = seal;
                    damaged[i] = char(damaged[i] ^ 1 << bit);
                    QVERIFY2(!unsealed(damaged), qPrintable(QString::number(i)));
                }
            }
        }
        QVERIFY(!unsealed({}));
    }

    void numbersAndFoldersAreHeldToTheirRange()
    {
        const auto real = [](const QVariant& value) {
            QSettings().setValue("x", value);
            return rememberedNumber(QStringLiteral("x"), 0.02, 50., 1.);
        };
        const auto whole = [](const QVariant& value) {
            QSettings().setValue("x", value);
            return rememberedNumber(QStringLiteral("x"), 0, 2, 1);
        };
        for (const QVariant& bad :
             {QVariant(), QVariant("x"), QVariant("nan"), QVariant("inf"), QVariant(-1),
              QVariant(1e300), QVariant(QByteArray("\0", 1)), QVariant(QStringList{"1", "2"}),
              QVariant("99999999999999999999")}) {
            QCOMPARE(real(bad), 1.);
            QCOMPARE(whole(bad), 1);
        }
        QCOMPARE(real(std::numeric_limits<double>::quiet_NaN()), 1.);
        QCOMPARE(real(2.5), 2.5);
        QCOMPARE(whole(2), 2);
        const auto folder = [](const QVariant& value) {
            QSettings().setValue("x", value);
            return rememberedFolder(QStringLiteral("x"), "usual");
        };
        for (const QVariant& bad : {QVariant(), QVariant(7), QVariant("relative"),
                                    QVariant("/no/where"), QVariant("/etc/passwd"),
                                    QVariant(QString(100'000, u'/')), QVariant(QStringList{"/"})})
            QVERIFY2(folder(bad) == "usual" || bad.toStringList() == QStringList{"/"},
                     qPrintable(bad.toString().left(99)));
        QCOMPARE(folder(folder_.path()), folder_.path());
    }

    void recentFilesAreHeldToSense()
    {
        QSettings settings;
        settings.setValue("recent",
                          QStringList{"", "x", "2025-11-18T00:00:00Z 5 relative.svg",
                                      "2025-11-18T00:00:00Z 5 /a\nb.svg", "not-a-day -5 /😀.svg",
                                      "2025-11-18T00:00:00Z 5 /" + QString(5000, u'a')});
        const auto files = recentFiles(settings);
        QCOMPARE(files.size(), std::size_t(1));
        QCOMPARE(files[0].path, "/😀.svg");
        QCOMPARE(files[0].lines, std::size_t(0));
        for (const QVariant& bad : {QVariant(5), QVariant("x"), QVariant(QByteArray("\xff"))}) {
            settings.setValue("recent", bad);
            QVERIFY(recentFiles(settings).empty());
        }
    }

    void placesComeBackAndNothingElseDoes()
    {
        for (const WindowPlace& place :
             {WindowPlace{{0, 0, 1, 1}, false}, {{-1920, 30, 1280, 800}, true}})
            QCOMPARE(placeFrom(placeText(place)), std::optional(place));
        for (const char* bad :
             {"", "1,2", "0,0 0x5", "0,0 5x0", "0,0 -5x5", "0,0 999999x5", "999999,0 5x5",
              "0,0 5x5 ", "0,0 5x5 minimized", "a,0 5x5", "0,0 99999999999x5", "0.5,0 5x5",
              "\x01\xd9\xd0\xcb", "nan,nan infxinf", " 0,0 5x5", "0,0 5x5\n0,0 5x5"})
            QVERIFY2(!placeFrom(QString::fromLatin1(bad)), bad);
    }

    void whatFitsIsOnAScreen()
    {
        const std::array screens{QRect(0, 28, 1600, 872), QRect(1600, 0, 1024, 600),
                                 QRect(-800, -600, 800, 600)};
        std::mt19937 random(1);
        std::uniform_int_distribution<int> corner(-100'000, 100'000), size(1, 100'000),
            near(-1000, 2800), small(1, 900);
        const auto onOne = [&](const QRect& place) {
            return std::ranges::any_of(screens, [&](const QRect& screen) {
                return screen.contains(place.adjusted(0, 0, 8, 40));
            });
        };
        for (int i = 0; i < 20'000; ++i) {
            const bool far = i % 2;
            const QRect wanted(
                far ? corner(random) : near(random), far ? corner(random) : near(random),
                far ? size(random) : small(random), far ? size(random) : small(random));
            const QRect place = fitted(wanted, screens);
            QVERIFY2(onOne(place), qPrintable(placeText({wanted, false})));
            QVERIFY(!onOne(wanted) || !screens[0].contains(wanted.center()) || place == wanted);
            QCOMPARE(fitted(place, screens), place);
        }
    }
};

} // namespace settings_settings_test

TEST_CLASS(settings_settings_test::SettingsTest, Core)
#include "tests/app/settings/settings_test.moc"
