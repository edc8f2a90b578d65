// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/clipboard.h"

#include "app/document/tree_draft.h"
#include "app/formats/format.h"

#include <QBuffer>

#include <unordered_set>

namespace app {
namespace {

const QString svgType = QStringLiteral("image/svg+xml");

// An object from a page with other units, scaled to this page.
Object scaled(Object object, double factor)
{
    const Placement where{Point(factor)};
    object.path = object.path.placed(where);
    object.particulars.recipe = placed(object.particulars.recipe, where);
    object.style.width *= factor;
    object.style.dashOffset *= factor;
    for (double& dash : object.style.dashes)
        dash *= factor;
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

// The document with only these objects, in their layers, and in the groups that are copied.
Document only(Document document, const ObjectRanges& objects, ContainerId entered)
{
    const auto groups = copiedGroups(document, objects, entered);
    const ObjectRanges others =
        without(ObjectRanges(ObjectRange{0, document.objects().size()}), objects);
    Edit edit;
    for (const ObjectRange& range : others.ranges())
        edit.splices.push_back({std::uint32_t(range.first), std::uint32_t(range.size()), 0});
    edit.containers = document.containers().spliced(edit.splices);
    for (const ContainerId id : edit.containers->inOrder())
        if ((*edit.containers)[id].kind == Container::Kind::Group && !groups.contains(id))
            edit.containers = edit.containers->dissolved(id);
    document.apply(edit);
    return document;
}

} // namespace

std::unique_ptr<QMimeData> copied(const Document& document, const ObjectRanges& objects,
                                  ContainerId entered)
{
    QBuffer svg;
    svg.open(QIODevice::WriteOnly);
    auto data = std::make_unique<QMimeData>();
    if (formats().front().write(only(document, objects, entered), svg, {}))
        return data;
    data->setData(svgType, svg.data());
    data->setText(QString::fromUtf8(svg.data()));
    return data;
}

Document pasted(const QMimeData& data, const Page& page)
{
    QByteArray bytes = data.hasFormat(svgType) ? data.data(svgType) : data.text().toUtf8();
    if (!bytes.contains("<svg"))
        return {};
    QBuffer svg(&bytes);
    svg.open(QIODevice::ReadOnly);
    const auto read = formats().front().read(svg);
    if (!read)
        return {};
    const Document& document = read.value->document;
    const double factor = document.page().millimetresPerUnit() / page.millimetresPerUnit();
    Objects objects;
    document.objects().forEach(
        0, document.objects().size(), [&](std::size_t, const ObjectView& object) {
            Object copy = factor == 1 ? object.copy() : scaled(object.copy(), factor);
            copy.particulars.id.clear();
            objects.append(copy);
        });
    return Document({page, {}, std::move(objects), document.containers(), {}});
}

} // namespace app
