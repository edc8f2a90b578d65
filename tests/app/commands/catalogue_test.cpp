// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/commands/catalogue.h"

#include <QDir>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <set>

#include "tests/test_class.h"

namespace commands_catalogue_test {

class CatalogueTest : public QObject {
    Q_OBJECT

private slots:
    void everyRowSaysWhatItIs()
    {
        static const QRegularExpression words(QStringLiteral("^[a-z]+(-[a-z]+)*$"));
        std::set<std::string_view> keys;
        for (const app::CommandKind& kind : app::commandKinds()) {
            QVERIFY(words.match(app::latin(kind.key)).hasMatch());
            QVERIFY2(keys.insert(kind.key).second, kind.key.data());
            QVERIFY2(!kind.summary.empty(), kind.key.data());
        }
    }

    // A command that is not in the catalogue would be left out of the tests that draw from it.
    void everyCommandIsInIt()
    {
        static const QRegularExpression derives(
            QStringLiteral("class (?!EditCommand)\\w+ : public (Undo|Edit)Command\\b"));
        static const QRegularExpression row(QStringLiteral("CommandKind row\\{\"([^\"]*)\""));
        qsizetype found = 0;
        const QDir folder(QStringLiteral(SOURCE_DIR "/app/commands"));
        for (const QString& name : folder.entryList({QStringLiteral("*.h")})) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QString text = QString::fromUtf8(file.readAll());
            qsizetype commands = text.count(derives), rows = 0;
            for (auto each = row.globalMatch(text); each.hasNext(); ++rows) {
                const QString key = each.next().captured(1);
                QVERIFY2(std::ranges::any_of(app::commandKinds(),
                                             [&](const app::CommandKind& kind) {
                                                 return app::latin(kind.key) == key;
                                             }),
                         qPrintable(name + ": " + key));
            }
            QVERIFY2(commands == rows, qPrintable(name));
            found += commands;
        }
        QCOMPARE(found, qsizetype(app::commandKinds().size()));
    }
};

} // namespace commands_catalogue_test

TEST_CLASS(commands_catalogue_test::CatalogueTest, None)
#include "tests/app/commands/catalogue_test.moc"
