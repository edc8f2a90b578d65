// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/recent_files.h"

#include <QTemporaryDir>
#include <QTest>

#include "tests/test_class.h"

namespace session_recent_files_test {

class RecentFilesTest : public QObject {
    Q_OBJECT

private slots:
    void keepsTheNewestTenOnce()
    {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
        const auto now = QDateTime::fromSecsSinceEpoch(1'800'000'000, Qt::UTC);
        for (std::size_t i = 0; i < 12; ++i)
            app::remember(settings, {QString("/a b/%1.svg").arg(i), i, now});
        app::remember(settings, {"/a b/5.svg", 55, now});
        const auto files = app::recentFiles(settings);
        QCOMPARE(files.size(), app::mostRecentFiles);
        QCOMPARE(files[0], (app::RecentFile{"/a b/5.svg", 55, now}));
        QCOMPARE(files[1].path, "/a b/11.svg");
        QCOMPARE(std::ranges::count(files, QString("/a b/5.svg"), &app::RecentFile::path), 1);
        app::forgetRecentFiles(settings);
        QVERIFY(app::recentFiles(settings).empty());
    }
    void daysInWords()
    {
        QLocale::setDefault(QLocale(QLocale::English));
        const QDate today(2026, 11, 21);
        QCOMPARE(app::dayText(today, today), "today");
        QCOMPARE(app::dayText(today.addDays(-1), today), "yesterday");
        QCOMPARE(app::dayText({2026, 11, 18}, today), "18 Nov");
        QCOMPARE(app::dayText({2025, 11, 18}, today), "18 Nov 2025");
    }
};

} // namespace session_recent_files_test

TEST_CLASS(session_recent_files_test::RecentFilesTest, None)
#include "tests/app/session/recent_files_test.moc"
