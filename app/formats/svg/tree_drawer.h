// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/container_stack.h"
#include "app/formats/svg/convex_region.h"
#include "app/formats/svg/drawn.h"
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

/// Converts the tree into a document. A table has one row for each element that SVG can paint.
class TreeDrawer {
public:
    /// `tolerance` is the flattening tolerance in user units.
    TreeDrawer(const Tree& tree, Report& report, double tolerance);

    /// The content of the root as a document with this page. Throws Refused.
    Document drawAll(const Page& page, const Matrix& rootMatrix, const Point& viewport);

    qint64 line() const { return tree_.line(node_); } ///< the line of the element being drawn

private:
    struct Row {
        std::string_view element;
        void (TreeDrawer::*draw)(Node, const Place&);
    };
    static const Row* find(std::string_view element);

    void draw(Node node, const Place& around);
    void drawChildren(Node node, const Place& place);
    /// The context for an element's content, with the element's transform and properties applied.
    Place inside(Node node, const Place& around);
    void reportEffects(const Properties& properties, bool group);

    void drawGroup(Node node, const Place& around);
    bool isGroup(Node node) const;
    void drawContainer(Node node, Container::Kind kind, Place place, const Place& around);
    void drawSwitch(Node node, const Place& around);
    void drawNestedSvg(Node node, const Place& around);
    void drawUse(Node node, const Place& around);
    void drawOutline(Node node, const Place& around);
    void drawUsed(Node use, Node target, const Place& place);
    void drawViewport(Node node, Node sizes, const Place& place);

    void addClipPath(Node node, Place& place);
    void addViewportClip(const Box& viewport, Place& place);
    std::optional<ConvexRegion> clipRegion(Node clip, const Place& place);
    std::optional<std::vector<Subpath>> clipOutline(Node node, const Place& base);
    void addClipped(Drawn drawn, const Place& place);
    std::vector<Drawn> clipped(Drawn drawn, const ConvexRegion& region);

    std::vector<Subpath> placed(Outline outline, const Matrix& matrix);
    void countParts(const Drawn& drawn);
    Particulars particularsOf(Node node);
    QString idOf(Node node);

    const Tree& tree_;
    Report& report_;
    Styles styles_;
    Paints paints_;
    ContainerStack containers_;
    Node node_ = 0;
    std::vector<Node> used_;   ///< the targets of the <use> elements being drawn
    std::size_t repeated_ = 0; ///< number of elements drawn through <use>
    std::size_t parts_ = 0;
    std::size_t clipWork_ = 0; ///< chords times sides
    double tolerance_;
    std::vector<bool> idIsTaken_; ///< for the first element with an id: whether the id is in use
    int notesKept_ = 0;
};

} // namespace app::svg
