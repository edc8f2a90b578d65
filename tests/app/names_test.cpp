// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDirIterator>
#include <QRegularExpression>
#include <QTest>

#include <map>
#include <set>

#include "tests/not_empty.h"
#include "tests/test_class.h"

namespace names_test {

// Two types of one name in one namespace: neither compiler nor linker has to say a word, and of
// their inline functions the linker keeps those of one for both.

namespace {

using Places = std::map<QString, std::set<QString>>; // of the definitions, by the type's full name

// Types at the left margin of a file; those in unnamed namespaces belong to it alone.
void addTypesOf(const QString& path, Places& places)
{
    static const QRegularExpression opens(
        QStringLiteral(R"(^(?:inline )?namespace\s*(?:[A-Z_]+ )?([\w:]*)\s*\{)"));
    static const QRegularExpression defines(QStringLiteral(
        R"(^(?:struct|class|enum|enum class)\s+(\w+)(?:\s+final)?\s*(?::[^:].*)?\{)"));
    QFile file(path);
    QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(path));
    QStringList within;
    while (!file.atEnd()) {
        const QString line = QString::fromUtf8(file.readLine());
        if (const auto found = opens.match(line); found.hasMatch())
            within.push_back(found.captured(1));
        else if (line.startsWith(QLatin1StringView("} // namespace"))) {
            QVERIFY2(!within.isEmpty(), qPrintable(path));
            within.removeLast();
        } else if (const auto type = defines.match(line);
                   type.hasMatch() && !within.contains(QString()))
            places[(within + QStringList{type.captured(1)}).join(QStringLiteral("::"))].insert(
                path);
    }
}

} // namespace

class NamesTest : public QObject {
    Q_OBJECT

private slots:
    void noTwoTypesHaveOneName()
    {
        Places places;
        for (const char* layer : {"clipping", "app", "ui"}) {
            QDirIterator files(QStringLiteral(SOURCE_DIR "/") + QLatin1StringView(layer),
                               {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                               QDirIterator::Subdirectories);
            while (files.hasNext())
                addTypesOf(files.next(), places);
        }
        QVERIFY(places.contains(QStringLiteral("app::Document"))); // they are found at all
        for (const auto& [name, files] : notEmpty(places)) {
            const QStringList list(files.begin(), files.end());
            QVERIFY2(list.size() == 1, qPrintable(name + QLatin1StringView(" is defined in ")
                                                  + list.join(QLatin1StringView(" and "))));
        }
    }
};

} // namespace names_test

TEST_CLASS(names_test::NamesTest, Core)
#include "tests/app/names_test.moc"
