// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

// The rooms of app/ as app/CMakeLists.txt lists them, against what their files include. The
// compiler refuses most of what is found here (app.rooms.header_from_above); this names it in a
// sentence.

namespace {

QString contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Of each room, all that it stands on, itself included. In `order` from the ground up.
struct Rooms {
    QStringList order{};
    QMap<QString, QSet<QString>> below{};
    QStringList faults{}; ///< of the list itself
};

Rooms roomsIn(const QString& cmake)
{
    static const QRegularExpression row(
        QStringLiteral("^app_room\\((\\w+)(?: ON ([a-z_ ]+?))?(?: USES [^)]*| DATA [^)]*)?\\)"),
        QRegularExpression::MultilineOption);
    Rooms rooms;
    for (auto match = row.globalMatch(cmake); match.hasNext();) {
        const auto found = match.next();
        const QString name = found.captured(1);
        QSet<QString>& below = rooms.below[name];
        below << name;
        for (const QString& on : found.captured(2).split(u' ', Qt::SkipEmptyParts)) {
            if (!rooms.order.contains(on))
                rooms.faults
                    << QStringLiteral("%1 stands on %2, which is not below it").arg(name, on);
            below += rooms.below.value(on);
        }
        rooms.order << name;
    }
    return rooms;
}

/// What a file of a room includes and does not stand on: one sentence each.
QStringList upward(const Rooms& rooms, const QString& path, const QString& text)
{
    static const QRegularExpression include(QStringLiteral("^#include \"(app|ui)/(\\w+)"),
                                            QRegularExpression::MultilineOption);
    const QString room = path.section(u'/', 1, 1);
    QStringList found;
    for (auto match = include.globalMatch(text); match.hasNext();) {
        const auto line = match.next();
        if (line.captured(1) == u"ui" || !rooms.below[room].contains(line.captured(2)))
            found << QStringLiteral("%1 includes %2/%3: %4 does not stand on that")
                         .arg(path, line.captured(1), line.captured(2), room);
    }
    return found;
}

} // namespace

class RoomsTest : public QObject {
    Q_OBJECT
    const QDir source_{QStringLiteral(SOURCE_DIR)};
    const Rooms rooms_ = roomsIn(contentOf(source_.filePath(QStringLiteral("app/CMakeLists.txt"))));

private slots:
    void theListIsInOrder()
    {
        QVERIFY(rooms_.order.size() > 20);
        QCOMPARE(rooms_.faults, QStringList());
        QCOMPARE(rooms_.order.size(), rooms_.below.size()); // none is listed twice
    }

    void everyFolderIsARoom()
    {
        const QDir app(source_.filePath(QStringLiteral("app")));
        QStringList folders;
        for (const QString& folder : app.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name))
            if (QDirIterator(app.filePath(folder), {"*.h", "*.cpp"}, QDir::Files,
                             QDirIterator::Subdirectories)
                    .hasNext())
                folders << folder;
        QStringList rooms = rooms_.order;
        rooms.sort();
        QCOMPARE(folders, rooms);
    }

    void nothingIncludesWhatIsAbove()
    {
        QStringList found;
        int files = 0;
        for (QDirIterator it(source_.filePath(QStringLiteral("app")), {"*.h", "*.cpp"}, QDir::Files,
                             QDirIterator::Subdirectories);
             it.hasNext(); ++files) {
            const QString path = it.next();
            found += upward(rooms_, source_.relativeFilePath(path), contentOf(path));
        }
        QVERIFY(files > 500);
        QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
    }

    void anIncludeThatPointsUpIsNamed()
    {
        const Rooms rooms = roomsIn(QStringLiteral("app_room(base)\napp_room(document ON base)\n"
                                                   "app_room(view ON document USES X::y)\n"));
        const auto from = [&](const char* room, const char* text) {
            return upward(rooms, QStringLiteral("app/%1/x.h").arg(QLatin1StringView(room)),
                          QString::fromUtf8(text));
        };
        QCOMPARE(
            from("view", "#include \"app/base/number.h\"\n#include \"app/view/visible_colour.h\"\n")
                .size(),
            0);
        QCOMPARE(
            from("document", "#include \"app/view/visible_colour.h\"\n"),
            QStringList{"app/document/x.h includes app/view: document does not stand on that"});
        QCOMPARE(from("view", "#include \"ui/look/look.h\"\n").size(), 1);
    }

    void aRoomOnOneAboveItIsNamed()
    {
        QCOMPARE(roomsIn(QStringLiteral("app_room(base ON view)\napp_room(view ON base)\n")).faults,
                 QStringList{"base stands on view, which is not below it"});
    }
};

QTEST_GUILESS_MAIN(RoomsTest)
#include "rooms_test.moc"
