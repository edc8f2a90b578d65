// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/cut.h"
#include "app/document/document_builder.h"
#include "app/scene/scene.h"
#include "app/view/long_pieces.h"

#include <QTest>

#include <cmath>

#include "tests/app/scene/block_scene.h"
#include "tests/clipping/random.h"
#include "tests/test_class.h"

namespace view_long_pieces_test {

using namespace app;

namespace {

/// Strokes of many short lines that cross the window often; some are closed, dashed or filled.
Document drawing(unsigned seed)
{
    Random random(seed);
    DocumentBuilder builder;
    builder.open({.name = "one"});
    for (int i = 0; i < 60; ++i) {
        Object object;
        object.style.stroke = Colour{};
        if (random.whole(0, 3) == 0)
            object.style.dashes = {2, 1};
        if (random.whole(0, 5) == 0)
            object.style.fill = Colour{200, 0, 0, 255};
        Subpath path{{random.between(0, 100), random.between(0, 100)}, {}, random.whole(0, 1) == 1};
        Point at = path.start;
        for (int line = random.whole(1, 200); line > 0; --line) {
            at += Point(random.between(-3, 3), random.between(-3, 3));
            path.segments.push_back({at});
        }
        if (path.closed)
            path.segments.push_back({path.start});
        object.path = Path({&path, 1});
        builder.add(object);
    }
    builder.close();
    return builder.take(Page{{0, 0}, {100, 100}});
}

double lengthOf(const clipping::Segment& s) { return std::hypot(s.b.x - s.a.x, s.b.y - s.a.y); }

struct Kept {
    double length = 0;
    std::size_t pieces = 0;
};

Kept keptOf(const SceneFrame& frame)
{
    Kept kept;
    const auto add = [&](const clipping::Segment& piece) {
        kept.length += lengthOf(piece);
        kept.pieces += piece.a != piece.b;
    };
    for (const SceneFrame::Block& block : frame.blocks) {
        for (const clipping::Clipped& piece : block.pieces)
            add(piece.segment);
        for (std::size_t chunk = 0; chunk < block.remains.size(); ++chunk)
            for (std::size_t i = block.block->chunks[chunk].first;
                 block.remains[chunk] == Remains::Whole && i < block.block->endOfChunk(chunk); ++i)
                add(block.block->segments[i]);
    }
    return kept;
}

} // namespace

class LongPiecesTest : public QObject {
    Q_OBJECT

private slots:
    void theCanvasKeepsWhatACutKeeps()
    {
        std::size_t dropped = 0;
        for (unsigned seed = 0; seed < 40; ++seed) {
            Document before = drawing(seed);
            const RectangleShape window{{{30, 30}, {70, 70}}, seed % 2 ? 0.3 : 0};
            before.apply({.windows = ClipWindows{{{.shape = window}}}});
            const EditedDocument edited(before);
            const Scene scene(edited);
            const ClipRegion region = regionOf(before.windows(), before.page());
            FrameClipping clipping;
            const SceneFrame all =
                clipping.clip(scene.lines(), region, {&clipping::exactAlgorithm()});
            const std::size_t pieces = keptOf(all).pieces;
            for (const double least : {0.5, 4.0, 30.0}) {
                const LongPieces longer(before.styles(), all, least);
                const Kept kept = keptOf(longer.frame());
                dropped += pieces - kept.pieces;
                CutOptions options{.clipAll = clipping::exactAlgorithm().corrected.clipAll,
                                   .region = region,
                                   .leastLength = least};
                Document after = before;
                Edit edit = cut(before, options).edit;
                edit.windows = ClipWindows();
                after.apply(edit);
                double expected = 0;
                for (std::size_t i = 0; i < after.objects().size(); ++i) {
                    const ObjectView object = after.objects()[i];
                    if (!object.style().stroke)
                        continue; // the area of a cut one
                    std::vector<Chord> chords;
                    for (const Subpath& path : object.path().subpaths())
                        flatten(path, 0.05, chords);
                    for (const Chord& chord : chords)
                        expected += lengthOf(chord.segment);
                }
                QVERIFY2(std::abs(kept.length - expected) < 1e-6,
                         qPrintable(QString("%1: %2, not %3, of %4")
                                        .arg(seed)
                                        .arg(kept.length)
                                        .arg(expected)
                                        .arg(keptOf(all).length)));
            }
        }
        QVERIFY(dropped > 1000);
    }
    void shortRingsAreLeftOut()
    {
        const std::vector<clipping::Segment> small{{{0, 0}, {1, 0}}, {{1, 0}, {0, 1}}},
            large{{{5, 5}, {9, 5}}, {{9, 5}, {5, 9}}, {{5, 9}, {5, 5}}};
        std::vector<clipping::Segment> both = small;
        both.insert(both.end(), large.begin(), large.end());
        QVERIFY(withoutShortRings(both, 3) == large);
        QVERIFY(withoutShortRings(both, 1) == both);
        QVERIFY(withoutShortRings({}, 1).empty());
    }
};

} // namespace view_long_pieces_test

TEST_CLASS(view_long_pieces_test::LongPiecesTest, Gui)
#include "tests/app/view/long_pieces_test.moc"
