// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDirIterator>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <functional>

#include "tests/content_of.h"
#include "tests/test_class.h"

namespace rooms_test {

// The rooms of app/ and of ui/ as their CMakeLists.txt list them, against what their files include.
// The compiler refuses most of what is found here (app.rooms.header_from_above); this names it in a
// sentence.

namespace {

/// Of each room, all that it stands on, itself included. In `order` from the ground up.
struct Rooms {
    QStringList order{};
    QMap<QString, QSet<QString>> below{};
    QSet<QString> withoutMoc{};
    QStringList faults{}; ///< of the list itself
};

QStringList sorted(const QSet<QString>& names)
{
    QStringList list(names.begin(), names.end());
    list.sort();
    return list;
}

Rooms roomsIn(const QString& cmake)
{
    static const QRegularExpression row(
        QStringLiteral(
            "^room\\((\\w+)(?: ON ([a-z_ ]+?))?( NO_MOC)?(?:\\s+(?:USES|DATA)\\b[^)]*)?\\)"),
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
        if (!found.captured(3).isEmpty())
            rooms.withoutMoc << name;
    }
    return rooms;
}

/// The includes of a text, except those that moc writes.
QStringList includesOf(const QString& text)
{
    static const QRegularExpression include(QStringLiteral("^\\s*#\\s*include \"([^\"]+)\""),
                                            QRegularExpression::MultilineOption);
    QStringList paths;
    for (auto match = include.globalMatch(text); match.hasNext();)
        if (const QString path = match.next().captured(1);
            !path.endsWith(QStringLiteral(".moc")) && !path.startsWith(QStringLiteral("moc_")))
            paths << path;
    return paths;
}

/// The includes that do not name a path from the root of the repository: one sentence each.
QStringList relative(const QString& path, const QString& text)
{
    static const QRegularExpression fromRoot(
        QStringLiteral("^(app|clipping|resources|tests|ui)/(?!.*\\.\\./)"));
    QStringList found;
    for (const QString& include : includesOf(text))
        if (!fromRoot.match(include).hasMatch())
            found << QStringLiteral("%1 includes %2, which is no path from the root")
                         .arg(path, include);
    return found;
}

/// What a file of a room includes and does not stand on: one sentence each. Every room of ui stands
/// on app, and none of app on ui.
QStringList upward(const Rooms& rooms, const QString& path, const QString& text)
{
    static const QRegularExpression place(QStringLiteral("^(app|ui)/(\\w+)"));
    const QString layer = path.section(u'/', 0, 0);
    const QString room = path.section(u'/', 1, 1);
    QStringList found;
    for (const QString& include : includesOf(text)) {
        const auto to = place.match(include);
        const bool stands = !to.hasMatch()            ? true
                            : to.captured(1) == layer ? rooms.below[room].contains(to.captured(2))
                                                      : layer == u"ui";
        if (!stands)
            found << QStringLiteral("%1 includes %2/%3: %4 does not stand on that")
                         .arg(path, to.captured(1), to.captured(2), room);
    }
    return found;
}

} // namespace

class RoomsTest : public QObject {
    Q_OBJECT
    const QDir source_{QStringLiteral(SOURCE_DIR)};

    Rooms roomsOf(const QString& layer) const
    {
        return roomsIn(contentOf(source_.filePath(layer + QStringLiteral("/CMakeLists.txt"))));
    }

    /// All headers and sources of the folder and below it, from the root of the repository.
    QStringList filesOf(const QString& folder) const
    {
        QStringList files;
        for (QDirIterator it(source_.filePath(folder), {"*.h", "*.cpp"}, QDir::Files,
                             QDirIterator::Subdirectories);
             it.hasNext();)
            files << source_.relativeFilePath(it.next());
        files.sort();
        return files;
    }

private slots:
    void theListIsInOrder_data()
    {
        QTest::addColumn<QString>("layer");
        QTest::addColumn<QStringList>("outside"); // the files that are in no room
        QTest::addColumn<int>("rooms"), QTest::addColumn<int>("files"); // there are more
        QTest::newRow("app") << "app" << QStringList() << 20 << 500;
        QTest::newRow("ui") << "ui" << QStringList{"ui/main.cpp"} << 15 << 200;
    }

    void theListIsInOrder()
    {
        QFETCH(QString, layer);
        QFETCH(int, rooms);
        const Rooms listed = roomsOf(layer);
        QVERIFY(listed.order.size() > rooms);
        QCOMPARE(listed.faults, QStringList());
        QCOMPARE(listed.order.size(), listed.below.size()); // none is listed twice
    }

    void everyFolderIsARoom_data() { theListIsInOrder_data(); }
    void everyFolderIsARoom()
    {
        QFETCH(QString, layer);
        QFETCH(QStringList, outside);
        QStringList folders, loose;
        for (const QString& file : filesOf(layer))
            if (const QStringList parts = file.split(u'/'); parts.size() > 2)
                folders << parts[1];
            else
                loose << file;
        folders.removeDuplicates();
        folders.sort();
        QStringList rooms = roomsOf(layer).order;
        rooms.sort();
        QCOMPARE(folders, rooms);
        QCOMPARE(loose, outside);
    }

    void theReadmeListsThemInOrder_data() { theListIsInOrder_data(); }
    void theReadmeListsThemInOrder()
    {
        QFETCH(QString, layer);
        static const QRegularExpression row(QStringLiteral("^\\| `(\\w+)/` \\|"),
                                            QRegularExpression::MultilineOption);
        QStringList listed;
        const QString readme = contentOf(source_.filePath(layer + QStringLiteral("/README.md")));
        for (auto match = row.globalMatch(readme); match.hasNext();)
            listed << match.next().captured(1);
        QCOMPARE(listed, roomsOf(layer).order);
    }

    void nothingIncludesWhatIsAbove_data() { theListIsInOrder_data(); }
    void nothingIncludesWhatIsAbove()
    {
        QFETCH(QString, layer);
        QFETCH(QStringList, outside);
        QFETCH(int, files);
        const Rooms rooms = roomsOf(layer);
        const QStringList paths = filesOf(layer);
        QStringList found;
        for (const QString& path : paths)
            if (!outside.contains(path))
                found += upward(rooms, path, contentOf(source_.filePath(path)));
        QVERIFY(paths.size() > files);
        QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
    }

    /// NO_MOC saves the search for Q_OBJECT; with a Q_OBJECT, the program does not link.
    void aRoomWithoutMocHasNoQObject_data() { theListIsInOrder_data(); }
    void aRoomWithoutMocHasNoQObject()
    {
        QFETCH(QString, layer);
        static const QRegularExpression macro(QStringLiteral("^\\s+Q_(OBJECT|GADGET)\\b"),
                                              QRegularExpression::MultilineOption);
        const Rooms rooms = roomsOf(layer);
        QSet<QString> without(rooms.order.begin(), rooms.order.end());
        for (const QString& path : filesOf(layer))
            if (QString::fromUtf8(contentOf(source_.filePath(path))).contains(macro))
                without.remove(path.section(u'/', 1, 1));
        QVERIFY(without.size() < rooms.order.size());
        QCOMPARE(sorted(rooms.withoutMoc), sorted(without));
    }

    void everyIncludeIsAPathFromTheRoot_data()
    {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<int>("files"); // there are more
        QTest::newRow("app") << "app" << 500;
        QTest::newRow("ui") << "ui" << 200;
        QTest::newRow("tests") << "tests" << 200;
    }
    void everyIncludeIsAPathFromTheRoot()
    {
        QFETCH(QString, folder);
        QFETCH(int, files);
        const QStringList paths = filesOf(folder);
        QStringList found;
        for (const QString& path : paths)
            found += relative(path, contentOf(source_.filePath(path)));
        QVERIFY(paths.size() > files);
        QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
    }

    /// Each header of the library can be included alone. (The deep tests of the installed library
    /// compile them.)
    void aHeaderWithTheMacroOfTheLibraryFindsIt()
    {
        std::function<bool(const QString&)> finds = [&](const QString& header) {
            return header == u"clipping/abi.h"
                   || std::ranges::any_of(includesOf(contentOf(source_.filePath(header))), finds);
        };
        int asked = 0;
        for (const QString& path : filesOf(QStringLiteral("clipping")))
            if (path.endsWith(QStringLiteral(".h")) && ++asked
                && contentOf(source_.filePath(path)).contains("CLEARCUT_API"))
                QVERIFY2(finds(path), qPrintable(path));
        QVERIFY(asked > 30);
    }

    void aRelativeIncludeIsNamed()
    {
        const QString fine = "#include \"app/base/number.h\"\n#include <QTest>\n"
                             "#include \"ui/window/panels.h\"\n#include \"rooms_test.moc\"\n";
        QCOMPARE(relative("ui/menus/x.cpp", fine), QStringList());
        for (const char* include : {"../window/main_window.h", "main_window.h", "base/number.h",
                                    "ui/docks/../window/main_window.h"})
            QCOMPARE(relative("ui/docks/x.cpp", QStringLiteral("#include \"%1\"\n").arg(include)),
                     QStringList{QStringLiteral("ui/docks/x.cpp includes %1, which is no path "
                                                "from the root")
                                     .arg(QLatin1StringView(include))});
    }

    void anIncludeThatPointsUpIsNamed()
    {
        const Rooms rooms = roomsIn(QStringLiteral("room(base)\nroom(document ON base)\n"
                                                   "room(view ON document\n  USES X::y)\n"));
        const auto from = [&](const char* room, const char* text) {
            return upward(rooms, QLatin1StringView(room) + QStringLiteral("/x.h"),
                          QString::fromUtf8(text));
        };
        QCOMPARE(from("app/view", "#include \"app/base/number.h\"\n#include \"app/view/view.h\"\n"),
                 QStringList());
        QCOMPARE(
            from("app/document", "#include \"app/view/view.h\"\n"),
            QStringList{"app/document/x.h includes app/view: document does not stand on that"});
        QCOMPARE(from("ui/document", "#include \"ui/view/view.h\"\n#include \"app/view/view.h\"\n"),
                 QStringList{"ui/document/x.h includes ui/view: document does not stand on that"});
        QCOMPARE(from("app/view", "#include \"ui/base/look.h\"\n"),
                 QStringList{"app/view/x.h includes ui/base: view does not stand on that"});
    }

    void aRoomOnOneAboveItIsNamed()
    {
        QCOMPARE(roomsIn(QStringLiteral("room(base ON view)\nroom(view ON base)\n")).faults,
                 QStringList{"base stands on view, which is not below it"});
    }
};

} // namespace rooms_test

TEST_CLASS(rooms_test::RoomsTest, Core)
#include "tests/rooms_test.moc"
