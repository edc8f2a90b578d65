// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QRegularExpression>
#include <QTest>

// The tasks use the mouse and the keyboard alone, and each is one of the forty.
class EventsOnlyTest : public QObject {
    Q_OBJECT

    static QDir folder() { return QDir(QStringLiteral(SOURCE_DIR "/tests/ui/tasks")); }
    static QString read(const QString& name)
    {
        QFile file(folder().filePath(name));
        return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
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

private slots:
    void tasksUseNothingButEvents()
    {
        static const QRegularExpression other(QStringLiteral(
            "session|history|Commands?\\b|setTool|setSnap|\\bdocument|canvas|window\\(|->"));
        int tasks = 0;
        for (const QString& name : folder().entryList({"*_test.cpp"})) {
            if (name == "events_only_test.cpp")
                continue;
            const auto found = other.match(read(name));
            QVERIFY2(!found.hasMatch(), qPrintable(name + ": " + found.captured()));
            ++tasks;
        }
        QVERIFY(tasks > 0);
    }
    void everyTaskIsInTheListOfForty()
    {
        static const QRegularExpression row(QStringLiteral("^\\| (\\d+) \\| `(\\w+)`"),
                                            QRegularExpression::MultilineOption);
        QStringList names;
        for (auto all = row.globalMatch(read("README.md")); all.hasNext();)
            names << camelCase(all.next().captured(2));
        QCOMPARE(names.size(), 40);
        int written = 0;
        for (const QString& name : folder().entryList({"*_test.cpp"})) {
            if (name == "events_only_test.cpp")
                continue;
            for (const QString& function : functions(read(name))) {
                QVERIFY2(names.contains(function), qPrintable(function));
                ++written;
            }
        }
        QVERIFY2(written > 0, qPrintable(QString::number(written)));
    }
};

QTEST_APPLESS_MAIN(EventsOnlyTest)
#include "events_only_test.moc"
