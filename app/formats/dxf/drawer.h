// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/document/recipe.h"
#include "app/formats/dxf/drawn_layers.h"
#include "app/formats/dxf/pens.h"
#include "app/formats/dxf/space.h"

#include <map>

namespace app::dxf {

/// A block: entities that an INSERT draws by its name.
struct Block {
    glm::dvec3 base{};
    Records content{};  ///< up to ENDBLK
    bool other = false; ///< is in another file
};
using Blocks = std::map<std::string, Block, std::less<>>; ///< by name, in capitals

/// The context in which entities are drawn: that of the insertion around them.
struct Place {
    Space space{};
    std::optional<std::size_t> layer{}; ///< of the insertion; what is on layer 0 is drawn on it
    Pen pen{};                          ///< of what is drawn as its block
    bool hidden = false;                ///< the insertion is on a frozen layer
    int depth = 0;
};

class Drawer;

/// An entity in its place.
struct Entity {
    const Record& record;
    Records& following; ///< vertices of an old polyline
    const Place& place;
    Drawer& drawer;

    /// From the coordinate system of the entity's own plane.
    Space plane() const { return place.space * planeOf(record.point(210, {0, 0, 1})); }
};

/// Where a block is drawn: in rows and columns, in the coordinates of `place`.
struct Insertion {
    Space place{}, size{};
    std::size_t columns = 1, rows = 1;
    double right = 0, up = 0; ///< from one column, or row, to the next
};

/// A shape to be drawn.
struct Shape {
    std::vector<Subpath> paths{};
    Paint paint = Paint::Stroke;
    double width = 0; ///< of its line in drawing units; 0: as the pen says
    Recipe recipe{};
};

/// Draws entities into a document. Throws svg::Refused beyond the limits (limits.h).
class Drawer {
public:
    /// `bytes`: of the file.
    Drawer(const Header& header, const Tables& tables, const Blocks& blocks, Report& report,
           std::size_t bytes);

    /// Draws all entities up to the end of their section or block.
    void drawAll(Records records, const Place& place);
    Document take();

    // For the entities.
    void add(const Entity& entity, Shape shape);
    void addLine(const Entity& entity, const clipping::Segment& line);
    /// Draws a block once in each of these spaces.
    void insert(const Entity& entity, std::string_view name, const Insertion& insertion);
    bool hasBlock(std::string_view name) const { return blocks_.contains(inCapitals(name)); }
    const Header& header() const { return header_; }
    const Tables& tables() const { return tables_; }
    Report& report() { return report_; }
    void count(std::size_t parts); ///< towards the limit of the drawing
    /// A length in drawing units.
    double units(double millimetres) const { return millimetres / header_.millimetres(); }

private:
    void draw(const Entity& entity);
    std::size_t layerOf(const Entity& entity);
    StyleEntry styleOf(const Entity& entity, std::size_t layer, Paint paint, double width);
    bool isHidden(const Entity& entity) const;
    void countRepeated(std::size_t pairs);

    const Header& header_;
    const Tables& tables_;
    const Blocks& blocks_;
    Report& report_;
    Pens pens_;
    DrawnLayers layers_;
    std::vector<const Block*> open_; ///< the blocks that are being drawn
    std::size_t mostParts_, parts_ = 0, repeated_ = 0;
    double tolerance_;
    Style last_{};
    std::optional<StyleEntry> lastEntry_{};
};

} // namespace app::dxf
