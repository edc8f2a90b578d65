// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QRegularExpression>
#include <QTest>

#include "tests/test_class.h"

namespace tasks_events_only_test {

// The tasks use the mouse and the keyboard alone, and each is one of the list.
class EventsOnlyTest : public QObject {
    Q_OBJECT

    static QDir folder() { return QDir(QStringLiteral(SOURCE_DIR "/tests/ui/tasks")); }
    static QString read(const QString& name)
    {
        QFile file(folder().filePath(name));
        return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
    }
    static QStringList taskFiles()
    {
        QStringList files = folder().entryList({"*_test.cpp"});
        files.removeAll("events_only_test.cpp");
        return files;
    }
    /// The functions that are tasks: "holeCircle" of "hole_circle".
    static QStringList functions(const QString& source)
    {
        static const QRegularExpression slot(QStringLiteral("void (\\w+)\\(\\)\\n"));
        QStringList names;
        for (auto all = slot.globalMatch(source); all.hasNext();)
            names << all.next().captured(1);
        return names;
    }
    static QString camelCase(const QString& name)
    {
        QStringList words = name.split(u'_');
        QString joined = words.takeFirst();
        for (const QString& word : words)
            joined += word[0].toUpper() + word.mid(1);
        return joined;
    }

    /// What a player uses beside events and this plumbing, which it must have.
    static QString otherIn(const QString& file, const QStringList& plumbing)
    {
        QString source = read(file);
        for (const QString& allowed : plumbing) {
            if (!source.contains(allowed))
                return "without " + allowed;
            source.remove(allowed);
        }
        static const QRegularExpression other(
            "session|history|Commands?\\b|setTool|setSnap|setText|setValue|setChecked|"
            "setCurrent|setPlainText|trigger|\\bdocument\\b|canvas|files\\(|click\\(\\)|"
            "toggle\\(|\\bpush\\(|\\bselect\\(|\\bapply\\(|\\bload\\(|\\bopen\\(\\w*[fF]ile");
        return other.match(source).captured();
    }

private slots:
    void tasksUseNothingButEvents()
    {
        static const QRegularExpression other(
            "session|history|Commands?\\b|setTool|setSnap|setText|setValue|trigger|"
            "\\bdocument|canvas|window\\(|->");
        int tasks = 0;
        for (const QString& name : taskFiles()) {
            const auto found = other.match(read(name));
            QVERIFY2(!found.hasMatch(), qPrintable(name + ": " + found.captured()));
            ++tasks;
        }
        QVERIFY(tasks > 0);
    }
    // What the player may do with the window apart from events: wait, and read what is drawn.
    void thePlayerUsesNothingButEvents()
    {
        QCOMPARE(
            otherIn("player.h",
                    {"auto& canvas = window_.window->canvas();", "canvas.settle();",
                     "window_.window->canvas().view().toScreen(p)",
                     "window_.window->files().wait();", "window_.window->session().now().objects()",
                     "window_.window->session().now().page()",
                     "window_.window->files().lastExport()", "file.value->document.objects()",
                     "app/document/paper.h", "the session is only read"}),
            QString());
    }
    // The same of the player with several drawings; it also prepares files and the clipboard.
    void theDeskPlayerUsesNothingButEvents()
    {
        QCOMPARE(otherIn("desk_player.h",
                         {"shown().canvas().focusProxy()", "shown().canvas().view().toScreen(from)",
                          "shown().canvas().settle()", "shown().session().now()",
                          "shown().files().name()", "shown().files().open(file)", ".files().busy()",
                          "read.value->document", "setText(QStringLiteral(\"Wall\"))",
                          ".value->document", "drawn.apply(app::adding("}),
                 QString());
    }
    void everyTaskIsInTheList()
    {
        static const QRegularExpression row(QStringLiteral("^\\| (\\d+) \\| `(\\w+)`"),
                                            QRegularExpression::MultilineOption);
        const QString list = read("README.md");
        QStringList names;
        for (auto all = row.globalMatch(list); all.hasNext();) {
            const auto task = all.next();
            names << camelCase(task.captured(2));
            QCOMPARE(task.captured(1).toInt(), int(names.size()));
        }
        QStringList written;
        for (const QString& name : taskFiles())
            written << functions(read(name));
        names.sort();
        written.sort();
        QCOMPARE(written, names); // each once
        QVERIFY(names.size() >= 45);
        QCOMPARE(names.removeDuplicates(), 0);
        QVERIFY(!list.contains("not\nwritten") && !list.contains("not written"));
    }
    // The counts themselves are compared with the steps when the tasks are played (player.h).
    void noneOfTheTenPlayedTasksTakesMoreActionsThanElsewhere()
    {
        static const QRegularExpression row(
            QStringLiteral("^\\| `(\\w+)` \\| (\\d+) \\| (\\d+) \\| (\\d+) \\|"),
            QRegularExpression::MultilineOption);
        int tasks = 0;
        for (auto all = row.globalMatch(read("README.md")); all.hasNext(); ++tasks) {
            const auto task = all.next();
            for (const int peer : {3, 4})
                QVERIFY2(task.captured(2).toInt() <= task.captured(peer).toInt(),
                         qPrintable(task.captured()));
        }
        QCOMPARE(tasks, 10);
    }
};

} // namespace tasks_events_only_test

TEST_CLASS(tasks_events_only_test::EventsOnlyTest, None)
#include "tests/ui/tasks/events_only_test.moc"
