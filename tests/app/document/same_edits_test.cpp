// SPDX-License-Identifier: GPL-3.0-or-later
// The same edits, done to a sheet without more ado and to a document through Edit.
#include "app/document/edited_document.h"

#include <QTest>

#include <map>

#include "tests/app/document/plain_drawing.h"
#include "tests/app/document/random_sheets.h"
#include "tests/app/document/sheet.h"
#include "tests/test_class.h"

namespace document_same_edits_test {

using namespace app;

namespace {

/// A drawing and a document that are edited alike.
class Both {
public:
    explicit Both(const Sheet& sheet) : drawing(sheet), document(documentOf(sheet)) {}

    bool same() const { return sheetOf(document.now()) == drawing.sheet(); }
    const Sheet& sheet() const { return drawing.sheet(); }

    /// `shapes` lie in layers between those of the shapes around them.
    void splice(std::size_t first, std::size_t count, const std::vector<Shape>& shapes)
    {
        Edit edit;
        std::vector<ContainerId> into;
        const auto layers = document.now().containers().childrenOf(0);
        const auto old = std::span(sheet().shapes).subspan(first, count);
        auto at = std::uint32_t(first);
        for (std::uint32_t layer = 0; layer < layers.size(); ++layer) {
            const auto in = [&](const Shape& shape) { return shape.layer == layer; };
            const Splice s{at, std::uint32_t(std::ranges::count_if(old, in)),
                           std::uint32_t(std::ranges::count_if(shapes, in))};
            if (s.removed + s.added == 0)
                continue;
            edit.splices.push_back(s);
            into.push_back(layers[layer]);
            at += s.removed;
        }
        for (const Shape& shape : shapes)
            edit.objects.append(
                Object{Path(shape.paths), shape.style, {.id = shape.id}, shape.hidden});
        edit.containers = document.now().containers();
        for (std::size_t i = into.size(); i-- > 0;) { // from above, so that places stay
            const Splice& s = edit.splices[i];
            edit.containers = edit.containers->spliced(s.first, s.removed, s.added, into[i]);
        }
        apply(edit);
        drawing.splice(first, count, shapes);
    }

    void setWindow(const clipping::Window& window)
    {
        apply({.windows = ClipWindows{{{.shape = RectangleShape{window}}}}});
        drawing.setWindow(window);
    }

    void setPage(const Page& page)
    {
        apply({.page = page});
        drawing.setPage(page);
    }

    void setLayer(std::size_t index, const Layer& layer)
    {
        const Containers& tree = document.now().containers();
        apply({.containers = tree.with({.id = tree.childrenOf(0)[index],
                                        .name = layer.name,
                                        .svgId = layer.id,
                                        .visible = layer.visible,
                                        .locked = layer.locked})});
        auto layers = sheet().layers;
        layers[index] = layer;
        drawing.setLayers(layers);
    }

    void addLayer(std::size_t index, const Layer& layer)
    {
        const std::size_t place = drawing.endOfLayer(std::uint32_t(index) - 1);
        const Containers& tree = document.now().containers();
        apply({.containers = tree.inserted({.name = layer.name,
                                            .svgId = layer.id,
                                            .visible = layer.visible,
                                            .locked = layer.locked},
                                           0, index, {place, place})});
        auto layers = sheet().layers;
        layers.insert(layers.begin() + std::ptrdiff_t(index), layer);
        drawing.setLayers(layers);
        renumber(place, place, 1);
    }

    void removeLayer(std::size_t index)
    {
        const Containers& tree = document.now().containers();
        const ContainerId id = tree.childrenOf(0)[index];
        const ObjectRange range = tree.rangeOf(id);
        Edit edit{.containers = tree.removed(id)};
        if (!range.empty())
            edit.splices = {{std::uint32_t(range.first), std::uint32_t(range.size()), 0}};
        apply(edit);
        auto layers = sheet().layers;
        layers.erase(layers.begin() + std::ptrdiff_t(index));
        renumber(range.first, range.end, -1);
        drawing.setLayers(layers);
    }

    /// Undoes the last edit of the document.
    void undo()
    {
        document.apply(undo_.back());
        undo_.pop_back();
    }
    std::size_t steps() const { return undo_.size(); }

    PlainDrawing drawing;
    EditedDocument document;

private:
    void apply(const Edit& edit) { undo_.push_back(document.apply(edit)); }

    // Removes the shapes [first, end); those above come into other layers.
    void renumber(std::size_t first, std::size_t end, int by)
    {
        std::vector<Shape> above(sheet().shapes.begin() + std::ptrdiff_t(end),
                                 sheet().shapes.end());
        for (Shape& shape : above)
            shape.layer += std::uint32_t(by);
        drawing.splice(first, sheet().shapes.size() - first, above);
    }

    std::vector<Edit> undo_;
};

/// Edits both at random.
class Script {
public:
    Script(Both& both, unsigned seed) : both_(both), random_(seed) {}

    void step()
    {
        const auto act = random_.below(12);
        if (act == 0)
            both_.setWindow({random_.point(), random_.point()});
        else if (act == 1)
            both_.setPage(random_.page());
        else if (act == 2)
            both_.setLayer(random_.below(layers()), layer());
        else if (act == 3 && layers() < 8)
            both_.addLayer(1 + random_.below(layers()), layer());
        else if (act == 4 && layers() > 1)
            both_.removeLayer(random_.below(layers()));
        else
            splice();
    }

private:
    std::size_t layers() const { return both_.sheet().layers.size(); }

    Layer layer()
    {
        return {random_.text(), random_.below(2) == 0, random_.below(2) == 0, random_.text()};
    }

    void splice()
    {
        const auto& shapes = both_.sheet().shapes;
        const std::size_t first = random_.below(shapes.size() + 1);
        const std::size_t count = std::min(shapes.size() - first, random_.below(8));
        std::uint32_t layer = first > 0 ? shapes[first - 1].layer : 0;
        const std::uint32_t last = first + count < shapes.size() ? shapes[first + count].layer
                                                                 : std::uint32_t(layers() - 1);
        std::vector<Shape> added;
        const std::size_t most = shapes.size() > 150 ? 4 : 16;
        for (auto n = random_.below(most); n > 0; --n) {
            layer += std::uint32_t(random_.below(last - layer + 1));
            added.push_back(shape(layer));
        }
        both_.splice(first, count, added);
    }

    // Now and then a long one, so that there are several blocks.
    Shape shape(std::uint32_t layer)
    {
        Shape shape = random_.shape(layer);
        if (random_.below(10) == 0)
            for (int i = 0; i < 1000; ++i)
                shape.paths[0].segments.push_back({{double(i), 0}});
        return shape;
    }

    Both& both_;
    RandomSheets random_;
};

} // namespace

class SameEditsTest : public QObject {
    Q_OBJECT

private slots:
    void stayTheSame()
    {
        Both both(RandomSheets(5).sheet());
        const Document initial = both.document.snapshot();
        Script script(both, 6);
        std::map<std::size_t, Sheet> seen;
        std::size_t blocks = 0;
        for (int i = 0; i < 2000; ++i) {
            script.step();
            QVERIFY2(both.same(), qPrintable(QString::number(i)));
            if (i % 50 == 0)
                seen.emplace(both.steps(), both.sheet());
            blocks = std::max(blocks, both.document.now().objects().blocks().size());
        }
        QVERIFY(blocks >= 3);
        for (; both.steps() > 0; both.undo())
            if (const auto at = seen.find(both.steps()); at != seen.end())
                QVERIFY(sheetOf(both.document.now()) == at->second);
        QVERIFY(both.document.now() == initial);
    }
};

} // namespace document_same_edits_test

TEST_CLASS(document_same_edits_test::SameEditsTest, None)
#include "tests/app/document/same_edits_test.moc"
