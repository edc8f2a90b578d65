// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/clipboard.h"

#include "app/commands/set_style.h"
#include "app/document/hidden_objects.h"
#include "app/document/moved_runs.h"
#include "app/document/paper.h"
#include "app/document/placed_images.h"
#include "app/document/tree_draft.h"
#include "app/export/drawn_box.h"
#include "app/export/part_of_drawing.h"
#include "app/formats/format.h"
#include "app/formats/svg/writer.h"

#include <QBuffer>

#include <algorithm>
#include <array>
#include <unordered_set>

namespace app {
namespace {

const QString ownType = QStringLiteral("application/x-clearcut+svg");
const QString svgType = QStringLiteral("image/svg+xml");
const QString textType = QStringLiteral("text/plain");
const QString pdfType = QStringLiteral("application/pdf");
const QString pngType = QStringLiteral("image/png");
constexpr double usualDpi = 300, mostPixels = 4000;

Document onPaperOfItsSize(Document drawing)
{
    if (const auto box = drawnBox(drawing))
        drawing.apply({.page = paperAround(drawing.page(), *box)});
    return drawing;
}

// An object from a page with other units, scaled to this page; its stroke by another factor.
Object scaledObject(Object object, double factor, double strokes)
{
    const Placement where{Point(factor)};
    object.path = object.path.placed(where);
    object.particulars.recipe = placed(object.particulars.recipe, where);
    scaleStroke(object.style, strokes);
    return object;
}

// The groups that are copied: those chosen as a whole, and the groups in them.
std::unordered_set<ContainerId> copiedGroups(const Document& document, const ObjectRanges& objects,
                                             ContainerId entered)
{
    const Containers& tree = document.containers();
    std::unordered_set<ContainerId> groups;
    for (const TreeItem& item : TreeDraft(document, objects, entered).chosen())
        if (item.id != 0)
            groups.insert(item.id);
    for (const ContainerId id : tree.inOrder()) // each after the one around it
        if (groups.contains(tree.parentOf(id)))
            groups.insert(id);
    return groups;
}

// The drawing without the images that are not copied: those of layers in which, and in the layers
// around which, something else could be selected, too.
Document onlyImagesWith(Document document, const ObjectRanges& objects)
{
    Containers tree = document.containers();
    if (!tree.isUnderlaid())
        return document;
    const ObjectRanges others = without(editableObjects(document), objects);
    const auto isCopied = [&](ContainerId id) {
        const ObjectRange all{0, document.objects().size()};
        const ObjectRange range = id == 0 ? all : tree.rangeOf(id);
        return meets(objects, range) && !meets(others, range);
    };
    for (const ContainerId id : tree.underlaid()) {
        ContainerId around = id;
        while (around != 0 && tree.rangeOf(around).empty())
            around = tree.parentOf(around);
        if (tree.shown(id) && isCopied(around))
            continue;
        Container without = tree[id];
        without.underlay = {};
        tree = tree.with(without);
    }
    document.apply({.containers = std::move(tree)});
    return document;
}

// The document with only these objects, in their layers, and in the groups that are copied.
Document only(Document document, const ObjectRanges& objects, ContainerId entered)
{
    document = onlyImagesWith(std::move(document), objects);
    const auto groups = copiedGroups(document, objects, entered);
    Page page = document.page();
    page.guides = {};
    page.sheets.reset();
    const ObjectRanges others =
        without(ObjectRanges(ObjectRange{0, document.objects().size()}), objects);
    Edit edit{.windows = ClipWindows(), .page = std::move(page)};
    for (const ObjectRange& range : others.ranges())
        edit.splices.push_back({std::uint32_t(range.first), std::uint32_t(range.size()), 0});
    edit.containers = document.containers().spliced(edit.splices);
    for (const ContainerId id : edit.containers->inOrder())
        if ((*edit.containers)[id].kind == Container::Kind::Group && !groups.contains(id))
            edit.containers = edit.containers->dissolved(id);
    document.apply(edit);
    return document;
}

// A drawing, which is written only when a program asks for it: writing takes longer than a frame.
class CopiedDrawing final : public QMimeData {
public:
    explicit CopiedDrawing(Document drawing) : drawing_(std::move(drawing)) {}

    QStringList formats() const override { return {ownType, svgType, pdfType, pngType, textType}; }
    bool hasFormat(const QString& type) const override { return formats().contains(type); }

protected:
    QVariant retrieveData(const QString& type, QMetaType) const override
    {
        if (type == ownType)
            return written(own_, svg::write);
        if (type == pdfType)
            return picture(pdf_, u"pdf");
        if (type == pngType)
            return picture(png_, u"png");
        const QByteArray& pixels = written(pixels_, svg::writeInPixels);
        return type == textType  ? QVariant(QString::fromUtf8(pixels))
               : type == svgType ? QVariant(pixels)
                                 : QVariant();
    }

private:
    using Write = std::optional<QString> (*)(const Document&, QIODevice&, const WriteOptions&);
    const QByteArray& written(QByteArray& bytes, Write write) const
    {
        QBuffer buffer(&bytes);
        if (bytes.isEmpty() && buffer.open(QIODevice::WriteOnly) && write(drawing_, buffer, {}))
            bytes.clear();
        return bytes;
    }

    const QByteArray& picture(QByteArray& bytes, QStringView format) const
    {
        if (!bytes.isEmpty())
            return bytes;
        const Document drawing = onPaperOfItsSize(drawing_);
        const Point paper = millimetresOf(drawing.page());
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        if (findFormat(format)->write(
                drawing, buffer,
                {.dpi = std::min(usualDpi, mostPixels * 25.4 / std::max(paper.x, paper.y))}))
            bytes.clear();
        return bytes;
    }

    const Document drawing_;
    mutable QByteArray own_, pixels_, pdf_, png_;
};

} // namespace

std::unique_ptr<QMimeData> copied(const Document& document, const ObjectRanges& objects,
                                  ContainerId entered)
{
    return std::make_unique<CopiedDrawing>(only(document, objects, entered));
}

std::unique_ptr<QMimeData> copiedFile(std::string_view format, const QByteArray& content)
{
    struct Kind {
        std::string_view format;
        QString type;
        bool isText;
    };
    static const std::array kinds{Kind{"svg", svgType, true},
                                  Kind{"pdf", pdfType, false},
                                  Kind{"png", pngType, false},
                                  Kind{"csv", QStringLiteral("text/csv"), true},
                                  Kind{"dxf", QStringLiteral("image/vnd.dxf"), true},
                                  Kind{"geojson", QStringLiteral("application/geo+json"), true}};
    auto data = std::make_unique<QMimeData>();
    const auto* kind = std::ranges::find(kinds, format, &Kind::format);
    if (kind == kinds.end())
        return data;
    data->setData(kind->type, content);
    if (kind->isText)
        data->setText(QString::fromUtf8(content));
    return data;
}

Pasted pasted(const QMimeData& data, const Page& page)
{
    QByteArray bytes = data.hasFormat(ownType)   ? data.data(ownType)
                       : data.hasFormat(svgType) ? data.data(svgType)
                                                 : data.text().toUtf8();
    const bool isOffered = data.hasFormat(ownType) || data.hasFormat(svgType);
    if (bytes.isEmpty() || (!isOffered && !bytes.contains("<svg")))
        return {};
    QBuffer svg(&bytes);
    svg.open(QIODevice::ReadOnly);
    const auto read = formats().front().read(svg);
    if (!read)
        return {.fault = isOffered ? read.error : QString()};
    const Document& document = read.value->document;
    // Between drawings of the program, lengths stay the real ones; strokes stay as wide on paper.
    const double strokes = document.page().millimetresPerUnit() / page.millimetresPerUnit();
    const double factor = data.hasFormat(ownType) ? document.page().realMillimetresPerUnit()
                                                        / page.realMillimetresPerUnit()
                                                  : strokes;
    const bool same = factor == 1 && strokes == 1;
    Objects objects;
    document.objects().forEach(
        0, document.objects().size(), [&](std::size_t, const ObjectView& object) {
            Object copy = same ? object.copy() : scaledObject(object.copy(), factor, strokes);
            copy.particulars.id.clear();
            objects.append(copy);
        });
    const Placement where = same ? Placement() : Placement{Point(factor)};
    return {Document(
                {page, {}, std::move(objects), withPlacedImages(document.containers(), where), {}}),
            read.value->report};
}

} // namespace app
