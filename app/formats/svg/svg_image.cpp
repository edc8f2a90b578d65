// SPDX-License-Identifier: GPL-3.0-or-later
// Images that are SVG drawings themselves: what they draw becomes objects in the box of the image.
#include "app/formats/svg/limits.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/tree_drawer.h"

#include <glm/common.hpp>

#include <utility>

namespace app::svg {

/// Where the drawing lies in the box of its image.
struct TreeDrawer::SvgFrame {
    SvgFrame(const SvgImage& image, const Box& box, std::string_view aspect)
    {
        const Point size = image.size.x > 0 ? image.size : box.size;
        matrix = viewBoxTransform({{}, size}, box, aspect);
        const Point least = glm::max(matrix({}), box.min);
        seen = {least, glm::min(matrix(size), box.min + box.size) - least};
        if (image.viewBox)
            matrix = matrix
                     * viewBoxTransform(*image.viewBox, {{}, size},
                                        image.tree.attribute(0, "preserveAspectRatio"));
        viewport = image.viewBox ? image.viewBox->size : size;
        screen = size;
    }

    Matrix matrix{}; ///< from the drawing's to the image's coordinates
    Box seen{};      ///< the part of the box that shows the drawing
    Point viewport{}, screen{};
};

/// Null: it is none, or there are too many images.
const SvgImage* TreeDrawer::svgImageOf(Node node)
{
    if (imageSource_.drawn() >= mostImages)
        return nullptr;
    const auto* const image = std::get_if<std::shared_ptr<const SvgImage>>(&findImage(node));
    return image ? image->get() : nullptr;
}

void TreeDrawer::drawSvgImage(Node node, const SvgImage& image, const Place& around)
{
    Place place = inside(node, around);
    const auto box = imageBox(node, place);
    if (!box || place.matrix.determinant() == 0) {
        report_.add(losses::sizeless);
        return;
    }
    const bool isTooDeep = imageSource_.depth() >= deepestImages || !patterns_.empty();
    if (isTooDeep || imageSource_.gaveUp()) {
        report_.add(isTooDeep ? losses::imageTooDeep : losses::imageTooComplex);
        return;
    }
    reportEffects(place.properties, true);
    countImage();
    const SvgFrame frame(image, *box, tree_.attribute(node, "preserveAspectRatio"));
    addViewportClip(frame.seen, place);
    const auto drawing = drawnImage(image, frame, place);
    if (!drawing || (drawing->objects().empty() && !drawing->containers().isUnderlaid()))
        return;
    const Node named = around.repeated ? around.use : node;
    Particulars particulars = named == noNode ? Particulars() : particularsOf(named);
    addDrawing(*drawing,
               {.name = QString::fromUtf8(tree_.attribute(node, "inkscape:label")),
                .svgId = std::move(particulars.id),
                .title = std::move(particulars.title),
                .description = std::move(particulars.description)},
               place);
}

/// What an image draws, in the document's coordinates. Empty: it is beyond a limit, which is told.
std::optional<Document> TreeDrawer::drawnImage(const SvgImage& image, const SvgFrame& frame,
                                               const Place& place)
{
    Place root;
    root.matrix = place.matrix * frame.matrix;
    root.lengths.viewport = frame.viewport;
    root.lengths.screen = frame.screen;
    root.opacity = place.opacity;
    root.hidden = place.hidden || !place.properties.visible;
    root.depth = place.depth;
    const Report::Pin pin(report_);
    try {
        Styles styles(image.tree, report_);
        styles.takeWork(styles_);
        TreeDrawer drawer(image.tree, styles, report_, page_, imageSource_.inImage());
        drawer.takeWork(*this);
        Document drawing = drawer.drawRoot(std::move(root));
        styles_.takeWork(styles);
        takeWork(drawer);
        return drawing;
    } catch (const Refused&) {
        imageSource_.giveUp();
        report_.add(losses::imageTooComplex);
        return std::nullopt;
    }
}

/// Counts on from another drawer, for the limits of a file.
void TreeDrawer::takeWork(TreeDrawer& of)
{
    repeated_ = of.repeated_;
    bounded_ = of.bounded_;
    letters_ = of.letters_;
    content_.work() = of.content_.work();
}

/// Adds a drawing as a group, or as a layer if there are images in it. Its layers dissolve, and its
/// ids are none of this file. What is hidden in it is hidden object by object.
void TreeDrawer::addDrawing(const Document& drawing, Container container, const Place& place)
{
    const Containers& tree = drawing.containers();
    container.kind = tree.isUnderlaid() ? Container::Kind::Layer : Container::Kind::Group;
    content_.open(std::move(container));
    std::size_t next = 0;
    for (const ContainerMark& mark : tree.parts().marks) {
        const bool isGroup = mark.id != 0 && tree[mark.id].kind == Container::Kind::Group;
        if (isGroup && mark.closes) {
            content_.close();
        } else if (mark.id != 0 && !mark.closes) {
            Container inner = tree[mark.id];
            inner.svgId.clear();
            const SharedUnderlay image = std::exchange(inner.underlay, {});
            inner.visible = isGroup || tree.shown(mark.id);
            if (isGroup)
                content_.open(std::move(inner));
            else if (image)
                addImage(*image, std::move(inner), place);
        }
        const bool isShown = mark.objects == 0 || tree.shown(tree.containerOf(next));
        for (std::size_t i = 0; i < mark.objects; ++i, ++next) {
            Object object = drawing.objects()[next].copy();
            object.particulars.id.clear();
            object.hidden = object.hidden || !isShown;
            content_.add(std::move(object), place.clips);
        }
    }
    content_.close();
}

void TreeDrawer::addImage(Underlay image, Container layer, const Place& place)
{
    image.svgId.clear();
    if (!clipImage(image, place.clips))
        return;
    layer.locked = true;
    layer.underlay = std::move(image);
    content_.open(std::move(layer));
    content_.close();
}

} // namespace app::svg
