// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/open_drawings.h"

#include <QTemporaryDir>
#include <QTest>

#include "tests/test_class.h"

namespace session_open_drawings_test {

class OpenDrawingsTest : public QObject {
    Q_OBJECT

private slots:
    void areReadAsTheyWereKept()
    {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
        QCOMPARE(app::openDrawings(settings, 30), app::OpenDrawings());
        const app::OpenDrawings kept{{"/a/one.svg", "/b c/two, 2.svg", "/a/três.svg"}, 1};
        app::keepOpenDrawings(settings, kept);
        QCOMPARE(app::openDrawings(settings, 30), kept);
        QCOMPARE(app::openDrawings(settings, 2).files, kept.files.first(2));
        QCOMPARE(app::openDrawings(settings, 1), (app::OpenDrawings{kept.files.first(1), -1}));
        app::setReopensDrawings(settings, false);
        QCOMPARE(app::openDrawings(settings, 30), app::OpenDrawings());
        app::setReopensDrawings(settings, true);
        QCOMPARE(app::openDrawings(settings, 30), app::OpenDrawings()); // they were forgotten
    }
    void garbageIsLeftOut()
    {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
        QStringList files{"relative.svg", "",      "/bell\a.svg", "/" + QString(10'000, u'x'),
                          "/a.svg",       "/a.svg"};
        for (int i = 0; i < 200; ++i)
            files << QStringLiteral("/%1.svg").arg(i);
        settings.setValue("drawings/open", files);
        settings.setValue("drawings/shown", QStringList{"/a.svg", "x"});
        const auto drawings = app::openDrawings(settings, 5);
        QCOMPARE(drawings.files, QStringList({"/a.svg", "/0.svg", "/1.svg", "/2.svg", "/3.svg"}));
        QCOMPARE(drawings.shown, -1);
        settings.setValue("drawings/open", QByteArray("\xff\0\1", 3));
        QVERIFY(app::openDrawings(settings, 5).files.isEmpty());
    }
};

} // namespace session_open_drawings_test

TEST_CLASS(session_open_drawings_test::OpenDrawingsTest, Core)
#include "tests/app/session/open_drawings_test.moc"
