// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/clip_object.h"
#include "app/formats/svg/container_stack.h"
#include "app/formats/svg/convex_region.h"
#include "app/formats/svg/outline.h"
#include "app/formats/svg/paint.h"
#include "app/formats/svg/transform.h"

#include <memory>

namespace app::svg {

/// The context in which an element is drawn, inherited from the elements around it.
struct Place {
    Matrix matrix{};         ///< from the element's to the document's coordinates
    Properties properties{}; ///< of the parent element
    Lengths lengths{};
    double opacity = 1;    ///< the product of all opacities around it
    bool hidden = false;   ///< display="none" on an element around it
    bool repeated = false; ///< inside a <use>
    Node use = noNode;     ///< the <use> that draws this element directly
    int depth = 0;
    std::vector<std::shared_ptr<const ConvexRegion>> clips{}; ///< outermost first
};

/// The bounding box of an element's shapes.
struct ElementBounds {
    Point min{}, max{};
    bool isEmpty = true;
    bool isKnown = true; ///< whether they have no texts, images and the like
};

/// Converts the tree into a document. A table has one row for each element that SVG can paint.
class TreeDrawer {
public:
    TreeDrawer(const Tree& tree, Styles& styles, Report& report, const Page& page);

    /// The content of the root as a document with the page. Throws Refused.
    Document drawAll(const Matrix& rootMatrix, const Point& viewport);

    qint64 line() const { return tree_.line(node_); } ///< the line of the element being drawn

private:
    struct Row {
        std::string_view element;
        void (TreeDrawer::*draw)(Node, const Place&);
    };
    static const Row* find(std::string_view element);
    static bool isDrawn(std::string_view element); ///< by SVG, whether it is kept or not

    void draw(Node node, const Place& around);
    void drawChildren(Node node, const Place& place);
    bool isWanted(Node node);
    /// The context for an element's content, with the element's transform and properties applied.
    Place inside(Node node, const Place& around);
    Place styled(Node node, const Place& around); ///< the same without clip paths
    void transform(Node node, Place& place);
    void reportEffects(const Properties& properties, bool group);

    void drawGroup(Node node, const Place& around);
    bool isGroup(Node node) const;
    void drawContainer(Node node, Container::Kind kind, Place place, const Place& around);
    void drawSwitch(Node node, const Place& around);
    void drawNestedSvg(Node node, const Place& around);
    void drawUse(Node node, const Place& around);
    void drawOutline(Node node, const Place& around);
    void drawUsed(Node use, Node target, const Place& place);
    bool containsItself(Node use, Node target) const;
    Point shiftOf(Node use, const Place& place) const;
    struct ViewportSize {
        std::string_view width{}, height{};
    };
    void drawViewport(Node node, const Place& place, const ViewportSize& given);

    std::optional<Box> boundsOf(Node node, const Place& place);
    void addBounds(Node node, const Place& place, ElementBounds& bounds);
    void addBoundsWithin(Node node, const Place& around, ElementBounds& bounds);

    void addClipPath(Node node, Place& place);
    void addViewportClip(const Box& viewport, Place& place);
    std::optional<ConvexRegion> clipRegion(Node clip, const Place& place);
    std::optional<std::vector<Subpath>> clipOutlines(Node clip, const Place& base);
    std::optional<std::vector<Subpath>> clipOutline(Node node, const Place& base);
    std::nullopt_t refuseClip(const LossKind& why);
    void addClipped(Drawn drawn, const Place& place);
    std::vector<Drawn> clipped(Drawn drawn, const ConvexRegion& region);

    Outline outlineOf(const OutlineKind& kind, Node node, const Place& place);
    std::vector<Subpath> placed(Outline outline, const Matrix& matrix);
    void scaleDashes(Node node, const Outline& outline, Properties& properties);
    void countParts(const Drawn& drawn);
    Particulars particularsOf(Node node);
    QString idOf(Node node);

    const Tree& tree_;
    Report& report_;
    Styles& styles_;
    Paints paints_;
    const Page& page_;
    ContainerStack containers_;
    Node node_ = 0;
    std::vector<Node> used_;   ///< the targets of the <use> elements being drawn
    std::size_t repeated_ = 0; ///< number of elements drawn through <use>
    std::size_t bounded_ = 0;  ///< number of elements of which boxes were computed
    std::size_t parts_ = 0;
    std::size_t clipWork_ = 0;   ///< chords times sides
    bool hasConditions_ = false; ///< whether the file names languages or extensions
    double tolerance_;
    std::vector<bool> idIsTaken_; ///< for the first element with an id: whether the id is in use
    int notesKept_ = 0;
};

} // namespace app::svg
