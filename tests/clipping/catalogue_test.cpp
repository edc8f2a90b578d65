// SPDX-License-Identifier: GPL-3.0-or-later
#include "clipping/algorithm.h"

#include <QDir>
#include <QTest>

#include "tests/test_class.h"

namespace catalogue_test {

class CatalogueTest : public QObject {
    Q_OBJECT

private slots:
    void namesEveryFileInAlgorithms()
    {
        const auto files = QDir(SOURCE_DIR "/clipping/algorithms").entryList({"*.cpp"});
        QCOMPARE(std::size_t(files.size()), clipping::algorithms().size());
    }

    void findsKeysAndAbbreviationsInAnyCase()
    {
        const auto* found = clipping::findAlgorithm("md");
        QVERIFY(found);
        QCOMPARE(found, clipping::findAlgorithm("Matthes-Drakopoulos"));
        QVERIFY(!clipping::findAlgorithm("nobody"));
    }

    void exactAlgorithmIsTheRowExact()
    {
        QCOMPARE(clipping::exactAlgorithm().key, std::string_view("exact"));
    }
};

} // namespace catalogue_test

TEST_CLASS(catalogue_test::CatalogueTest, None)
#include "tests/clipping/catalogue_test.moc"
