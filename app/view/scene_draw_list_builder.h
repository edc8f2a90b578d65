// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_lines.h"
#include "app/view/cut_fill.h"
#include "app/view/draw_list_builder.h"
#include "app/view/painted_part.h"

namespace app {

/// Builds a draw list from the lines of a scene, chunk by chunk in order. A chunk outside the view
/// costs only a test of its box.
class SceneDrawListBuilder {
public:
    /// `part` is the part that will be added: of an area, what is in it (CutFill).
    SceneDrawListBuilder(const SceneLines& lines, const PaintedPart& part,
                         const PictureOptions& options, std::size_t expectedPieces);

    /// Sets the style for the following calls; the style must outlive them.
    void setStyle(const Style& style);
    /// Adds the lines [first, end) of a chunk, whole.
    void addWhole(std::size_t block, std::size_t chunk, std::size_t first, std::size_t end);
    /// Adds pieces of a chunk with the lines [first, end), possibly none. Areas may reach into the
    /// painted part although none of their lines does.
    void addPieces(std::size_t block, std::size_t chunk, std::size_t first, std::size_t end,
                   std::span<const clipping::Clipped> pieces);

    /// Adds an image, between two objects.
    void add(const SharedUnderlay& image);

    DrawList take() { return builder_.take(); }

private:
    /// The lines of the object in one block.
    struct Lines {
        std::size_t block, first, end;
    };

    void goTo(std::size_t block);
    bool isEmpty(const FloatBox& box, std::size_t first, std::size_t end) const;
    bool skips(const FloatBox& box, std::size_t first, std::size_t end);
    void enter(std::size_t line)
    {
        if (line >= objectEnd_)
            enterObjectOf(line);
    }
    void enterObjectOf(std::size_t line);
    void enterUpTo(std::size_t end, std::size_t& line);
    void findObject(std::size_t object);
    bool fillObject();
    bool strokeCut();
    bool beginsObject(std::size_t line) const;
    bool isWhole() const;
    double before(std::size_t line);

    const SceneLines& lines_;
    const PaintedPart& part_;
    CutFill cutFill_;
    const bool closesAreas_; ///< the stroke of a cut area that is kept follows the cut
    const double leastLength_;
    DrawListBuilder builder_;
    const Style* style_ = nullptr;
    bool begun_ = false; // whether the draw command for stroked-only objects has begun

    std::size_t at_ = std::size_t(-1); // the current block
    const SceneBlock* block_ = nullptr;

    // The object of the previous line. Its lines are known only if it is filled or dashed.
    std::size_t object_ = std::size_t(-1);
    std::size_t objectEnd_ = 0; // in the block
    bool strokes_ = false;
    std::vector<Lines> objectLines_;
    Outline outline_;
    std::vector<clipping::Segment> cutOutline_; ///< of the current area, without short rings
    bool isCut_ = false;                        ///< whether the area is, even if no ring is left
    std::size_t firstLine_ = 0;                 // in the scene
    LengthsBefore lengths_;
};

} // namespace app
