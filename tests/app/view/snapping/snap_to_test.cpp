// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/snap_to.h"

#include <QTest>

#include <set>

#include "tests/test_class.h"

namespace view_snapping_snap_to_test {

using app::SnapTo;

class SnapToTest : public QObject {
    Q_OBJECT

private slots:
    void everyKindHasItsOwnKeyNameAndGlyph()
    {
        std::set<QString> names, words;
        std::set<std::string_view> keys;
        for (const app::SnapKind& kind : app::snapKinds()) {
            keys.insert(kind.key);
            names.insert(kind.name);
            words.insert(kind.word);
            QVERIFY(!kind.name.isEmpty() && !kind.word.isEmpty() && !kind.glyph.empty());
            for (const auto& [a, b] : kind.glyph)
                for (const double number : {a.x, a.y, b.x, b.y})
                    QVERIFY(std::abs(number) <= 1);
        }
        QCOMPARE(keys.size(), app::snapKinds().size());
        QCOMPARE(names.size(), keys.size());
        QCOMPARE(words.size(), keys.size());
        QVERIFY(keys.size() <= 32);
    }
    void kindsAreSwitchedOneByOne()
    {
        QCOMPARE(SnapTo::Nothing.size(), std::size_t(0));
        QCOMPARE(SnapTo::All.size(), app::snapKinds().size());
        const SnapTo two = SnapTo::Nothing.with("ends").with("page").with("ends");
        QCOMPARE(two.size(), std::size_t(2));
        QVERIFY(two.has("page") && !two.has("middles"));
        QVERIFY(!two.without("page").has("page"));
        QCOMPARE(two & SnapTo::All.without("ends"), SnapTo::Nothing.with("page"));
    }
    void settingsAreReadBack()
    {
        const SnapTo some = SnapTo::usual().with("on-path").without("ends");
        QCOMPARE(SnapTo::fromText(some.text()), some);
        QCOMPARE(SnapTo::fromText(""), SnapTo::usual());
        QCOMPARE(SnapTo::fromText("+nonsense - + -ends"), SnapTo::usual().without("ends"));
    }
};

} // namespace view_snapping_snap_to_test

TEST_CLASS(view_snapping_snap_to_test::SnapToTest, None)
#include "tests/app/view/snapping/snap_to_test.moc"
