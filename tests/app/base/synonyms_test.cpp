// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/name_match.h"
#include "app/base/synonyms.h"

#include <QTest>

#include <algorithm>
#include <functional>

#include "tests/test_class.h"

namespace base_synonyms_test {

class SynonymsTest : public QObject {
    Q_OBJECT

private slots:
    void theyAreInOrderEachOnce()
    {
        const auto all = app::synonyms();
        QVERIFY(all.size() > 50);
        QVERIFY(std::ranges::adjacent_find(all, std::greater_equal(), &app::Synonym::typed)
                == all.end());
        for (const app::Synonym& synonym : all)
            QVERIFY(synonym.typed != synonym.word);
    }
    void eachWordOfATextIsReplaced()
    {
        QCOMPARE(app::inProgramWords("turn LEFT"), QString("rotate LEFT"));
        QCOMPARE(app::inProgramWords("Spin circle"), QString("rotate ellipse"));
        QCOMPARE(app::inProgramWords("return"), QString("return"));
        QCOMPARE(app::inProgramWords(QString()), QString());
    }
    void namesAreFoundByThem()
    {
        QVERIFY(app::matchName("turn", "Rotate"));
        QVERIFY(app::matchName("erase", "Delete"));
        QVERIFY(!app::matchName("turn", "Delete"));
        // What is typed comes before what it means.
        QCOMPARE(app::matchName("box", "Rectangle, or box")->letters,
                 (QList<qsizetype>{14, 15, 16}));
    }
};

} // namespace base_synonyms_test

TEST_CLASS(base_synonyms_test::SynonymsTest, None)
#include "tests/app/base/synonyms_test.moc"
