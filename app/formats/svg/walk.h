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

/// Where an element is drawn: what it gets from those around it.
struct Place {
    Matrix matrix{};         ///< to the document's coordinates
    Properties properties{}; ///< of the element around it
    Lengths lengths{};
    double opacity = 1;       ///< the product of those around it
    bool hidden = false;      ///< display="none" around it
    bool repeated = false;    ///< inside a <use>
    Node use = noNode;        ///< a <use> that draws just this element
    int depth = 0;
    std::vector<std::shared_ptr<const ConvexRegion>> clips{}; ///< outermost first
};

/// Draws the tree into a document: one row of a list for each element that SVG can paint.
class Walk {
public:
    /// `tolerance`, in user units, is what curves are flattened to.
    Walk(const Tree& tree, Report& report, double tolerance);

    /// Everything under the root, as a document of that page. Throws Refused.
    Document drawAll(const Page& page, const Matrix& rootMatrix, const Point& viewport);

    qint64 line() const { return tree_.line(node_); } ///< of the element being drawn

private:
    struct Row {
        std::string_view element;
        void (Walk::*draw)(Node, const Place&);
    };
    static const Row* find(std::string_view element);

    void draw(Node node, const Place& around);
    void drawChildren(Node node, const Place& place);
    /// The place of an element's content, its own transform and properties applied.
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
    std::vector<Node> used_;   ///< the targets of the <use>s that are being drawn
    std::size_t repeated_ = 0; ///< elements drawn through <use>
    std::size_t parts_ = 0;
    std::size_t clipWork_ = 0; ///< chords times sides
    double tolerance_;
    std::vector<bool> idIsTaken_; ///< by the first element of the file that has it
    int notesKept_ = 0;
};

} // namespace app::svg
