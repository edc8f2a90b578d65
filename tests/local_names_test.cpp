// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a room are compiled together in the release preset, so no two of them may have the
// same name of their own, in an unnamed namespace or static: a new file would bring two others
// together that never were.
#include <QDirIterator>
#include <QRegularExpression>
#include <QTest>

#include "tests/content_of.h"
#include "tests/test_class.h"

namespace local_names_test {

namespace {

QRegularExpression pattern(const char* text, QRegularExpression::PatternOptions options = {})
{
    return QRegularExpression(QString::fromLatin1(text), options);
}

/// The text without comments, strings and directives.
QString bare(QString text)
{
    static const QRegularExpression raw =
        pattern("R\"(\\w*)\\(.*?\\)\\1\"", QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression commentOrString =
        pattern("//[^\n]*|\"(\\\\.|[^\"\\\\\n])*\"|(?<!\\w)'(\\\\.|[^'\\\\\n])+'");
    static const QRegularExpression directive =
        pattern("^ *#.*$", QRegularExpression::MultilineOption);
    for (const QRegularExpression& part : {raw, commentOrString, directive})
        text.replace(part, QStringLiteral(" "));
    return text;
}

/// The names of variables: what comes before a value, a bracket, a comma or the end.
QStringList variablesOf(QString statement)
{
    static const QRegularExpression within =
        pattern(R"(\([^()]*\)|\[[^\[\]]*\]|\{[^{}]*\}|<[^<>=]*>)");
    static const QRegularExpression name = pattern(R"((\w+) ?(?:=.*)?$)");
    for (QString before; before != statement;) {
        before = statement;
        statement.remove(within);
    }
    QStringList names;
    for (const QString& part : statement.split(u','))
        if (const auto match = name.match(part.trimmed()); match.hasMatch())
            names << match.captured(1);
    return names;
}

/// The names that a statement in a namespace declares.
QStringList declared(QString statement, bool unnamed)
{
    statement = statement.simplified();
    static const QRegularExpression notOurs =
        pattern("^(catch|else|extern|friend|namespace|static_assert|template ?<> )");
    static const QRegularExpression alias = pattern(R"(^using (\w+) =)");
    static const QRegularExpression own = pattern("^(static|constexpr|inline constexpr) ");
    static const QRegularExpression head = pattern("^template ?<[^{]*?> (?=[\\w:]+[ &*])");
    static const QRegularExpression type =
        pattern(R"(^(?:struct|class|enum class|enum|union) (\w+))");
    static const QRegularExpression function = pattern(R"(([\w:~]+) ?\()");
    if (statement.isEmpty() || notOurs.match(statement).hasMatch())
        return {};
    if (const auto match = alias.match(statement); unnamed && match.hasMatch())
        return {match.captured(1)};
    if (statement.startsWith(QStringLiteral("using"))
        || (!unnamed && !own.match(statement).hasMatch()))
        return {};
    statement.remove(head);
    if (const auto match = type.match(statement); match.hasMatch())
        return {match.captured(1)};
    const auto called = function.match(statement);
    if (const qsizetype value = statement.indexOf(u'=');
        called.hasMatch() && (value < 0 || called.capturedStart() < value))
        return called.captured(1).contains(u':') ? QStringList() : QStringList{called.captured(1)};
    return variablesOf(statement);
}

/// The names that a file has for itself.
QSet<QString> localNames(const QString& text)
{
    static const QRegularExpression opens = pattern(R"(\bnamespace(?: [\w:]+)?$)");
    QSet<QString> names;
    QList<QChar> around; ///< n: a namespace, u: an unnamed one, b: any other block
    QString statement;
    const auto note = [&] {
        const QChar within = around.isEmpty() ? u'n' : around.back();
        if (within != u'b')
            for (const QString& name : declared(statement, within == u'u'))
                names << name;
    };
    for (const QChar c : bare(text)) {
        if (c == u'{') {
            const QString head = statement.simplified();
            const bool space = opens.match(head).hasMatch();
            if (!space)
                note();
            around << (!space ? u'b' : head.endsWith(QStringLiteral("namespace")) ? u'u' : u'n');
        } else if (c == u'}' && !around.isEmpty()) {
            around.removeLast();
        } else if (c == u';') {
            note();
        } else {
            statement += c;
            continue;
        }
        statement.clear();
    }
    return names;
}

/// The rooms of a layer: its folders.
QStringList roomsOf(const QDir& layer)
{
    return layer.entryList(QDir::Dirs | QDir::NoDotAndDotDot);
}

/// Of each room, each name that several files of one have: one sentence each.
QStringList clashesIn(const QString& layer)
{
    QStringList found;
    const QDir folder(QStringLiteral(SOURCE_DIR "/") + layer);
    for (const QString& room : roomsOf(folder)) {
        QMap<QString, QStringList> filesOf;
        for (QDirIterator it(folder.filePath(room), {"*.cpp"}, QDir::Files,
                             QDirIterator::Subdirectories);
             it.hasNext();) {
            const QString file = it.next();
            for (const QString& name : localNames(QString::fromUtf8(contentOf(file))))
                filesOf[name] << folder.relativeFilePath(file);
        }
        for (auto it = filesOf.cbegin(); it != filesOf.cend(); ++it)
            if (it->size() > 1)
                found << QStringLiteral("%1: %2").arg(it.key(), it->join(u' '));
    }
    return found;
}

} // namespace

class LocalNamesTest : public QObject {
    Q_OBJECT

private slots:
    void theyAreFound()
    {
        const QSet<QString> names = localNames(
            "namespace app { namespace {\n"
            "constexpr int most = 3'000; // constexpr int no = 1;\n"
            "constexpr int digits[]{1, 2}, least = half(1, 2), last{3};\n"
            "struct Row { int inside; void call(); };\n"
            "template <class T> T half(const T& x) { const int within = 2; return x; }\n"
            "using Rows = std::vector<Row>;\n"
            "const QString text = \"int quoted(\";\n"
            "}\n"
            "static int count() { return '{'; }\n"
            "void notLocal() {}\n"
            "void Row::call() {}\n"
            "}\n");
        QCOMPARE(names, (QSet<QString>{"most", "digits", "least", "last", "Row", "half", "Rows",
                                       "text", "count"}));
    }

    void noTwoFilesOfARoomShareOne_data()
    {
        QTest::addColumn<QString>("layer");
        QTest::newRow("app") << "app";
        QTest::newRow("ui") << "ui";
    }
    void noTwoFilesOfARoomShareOne()
    {
        QFETCH(QString, layer);
        QVERIFY(roomsOf(QDir(QStringLiteral(SOURCE_DIR "/") + layer)).size() > 5);
        const QStringList clashes = clashesIn(layer);
        for (const QString& clash : clashes)
            qWarning("%s", qPrintable(clash));
        QCOMPARE(clashes.size(), 0);
    }
};

} // namespace local_names_test

TEST_CLASS(local_names_test::LocalNamesTest, None)
#include "tests/local_names_test.moc"
