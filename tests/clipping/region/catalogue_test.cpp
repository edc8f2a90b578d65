// SPDX-License-Identifier: GPL-3.0-or-later
#include "clipping/algorithm.h"
#include "clipping/region/catalogue.h"

#include <QTest>

#include "tests/test_class.h"

namespace region_catalogue_test {

using namespace clipping;

class CatalogueTest : public QObject {
    Q_OBJECT

private slots:
    void everyFormBelongsToARow()
    {
        QVERIFY(!regionAlgorithms().empty());
        for (const RegionAlgorithm& form : regionAlgorithms()) {
            const Algorithm* row = findAlgorithm(form.key);
            QVERIFY(row && row->key == form.key);
            QVERIFY(!form.idea.empty() && form.ulps <= row->ulps);
            QCOMPARE(findRegionAlgorithm(form.key), &form);
        }
        QVERIFY(findRegionAlgorithm(exactAlgorithm().key));
        QVERIFY(!findRegionAlgorithm("skala"));
    }

    void theFormsClip()
    {
        const PreparedRegion region({{{areaOf({{0, 0}, {2, 2}})}}, Keep::Inside});
        const Segment line{{-1, 1}, {3, 1}}, inside{{0, 1}, {2, 1}};
        for (const RegionAlgorithm& form : regionAlgorithms()) {
            const auto pieces = form.clip(line, region);
            QCOMPARE(pieces.size(), 1u);
            QCOMPARE(pieces[0].segment, inside);
            std::array<RegionPiece, 1> out;
            QCOMPARE(form.clipAll(std::span(&line, 1), region, out, {}).written, 1u);
            QCOMPARE(out[0].segment, inside);
        }
    }
};

} // namespace region_catalogue_test

TEST_CLASS(region_catalogue_test::CatalogueTest, Core)
#include "tests/clipping/region/catalogue_test.moc"
