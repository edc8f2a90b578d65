// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/clipped_content.h"
#include "app/formats/svg/element_bounds.h"
#include "app/formats/svg/image_source.h"
#include "app/formats/svg/marker_vertices.h"
#include "app/formats/svg/outline.h"
#include "app/formats/svg/paint.h"
#include "app/formats/svg/text_layout.h"
#include "app/formats/svg/transform.h"
#include "app/lettering/named_font.h"

#include <map>
#include <memory>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

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
    ClipAreas clips{}; ///< of the elements around it
};

/// A rectangle, transformed.
PathShape rectangleShape(const Box& box, const Matrix& matrix);

/// Sets what context-fill and context-stroke mean inside an element that is drawn for another one.
void setContext(Properties& to, const Properties& from);

/// Converts the tree into a document. A table has one row for each element that SVG can paint.
class TreeDrawer {
public:
    TreeDrawer(const Tree& tree, Styles& styles, Report& report, const Page& page,
               ImageSource images);

    /// Whether clip paths, masks and viewports become Particulars::clips, and nothing is cut.
    void keepClipPaths(bool keep) { content_.keepClips(keep); }

    /// The content of the root as a document with the page. Throws Refused.
    Document drawAll(const Matrix& rootMatrix, const Point& viewport);

    /// The clip paths that were used, after drawAll().
    std::vector<NamedArea> takeClipPaths() { return std::move(clipPaths_); }

    qint64 line() const { return tree_.line(node_); } ///< the line of the element being drawn

private:
    struct Row {
        std::string_view element;
        void (TreeDrawer::*draw)(Node, const Place&);
    };
    static const Row* find(std::string_view element);
    static bool isDrawn(std::string_view element); ///< by SVG, whether it is kept or not

    Document drawRoot(Place place);
    void draw(Node node, const Place& around);
    static void refuseTooDeep(const Place& around);
    void drawChildren(Node node, const Place& place);
    bool isWanted(Node node);
    void reportRootConditions();
    /// The context for an element's content, with the element's transform and properties applied.
    Place inside(Node node, const Place& around);
    Place styled(Node node, const Place& around); ///< the same without clip paths
    void transform(Node node, Place& place);
    void reportEffects(const Properties& properties, bool group);

    void drawGroup(Node node, const Place& around);
    bool isGroup(Node node) const;
    void drawContainer(Node node, Container::Kind kind, Place place, const Place& around);
    void drawSwitch(Node node, const Place& around);
    Node chosenOf(Node node);
    void drawNestedSvg(Node node, const Place& around);
    void drawUse(Node node, const Place& around);
    void drawOutline(Node node, const Place& around);
    void drawUsed(Node use, Node target, const Place& place);
    bool containsItself(Node use, Node target) const;
    Point shiftOf(Node use, const Place& place) const;
    struct ViewportSize {
        std::string_view width{}, height{};
    };
    ViewportSize sizeOf(Node use, const Place& place) const;
    void drawViewport(Node node, const Place& place, const ViewportSize& given);
    std::optional<Place> inViewport(Node node, const Place& around, const ViewportSize& given);

    enum class BoxOf : std::uint8_t { Fill, Stroke };
    std::optional<Box> boundsOf(Node node, const Place& place, BoxOf of = BoxOf::Fill);
    void addBounds(Node node, const Place& place, ElementBounds& bounds);
    void addBoundsWithin(Node node, const Place& around, ElementBounds& bounds);
    void addBoundsOfChildren(Node node, const Place& place, ElementBounds& bounds);
    void addBoundsOfUse(Node use, const Place& place, ElementBounds& bounds);

    /// The element that a clip path is for, whose box it may refer to.
    struct Boxed {
        Node node;
        const Place& place;
    };
    void addClipPath(std::string_view value, const Boxed& boxed, Place& place);
    bool addClipReference(std::string_view reference, const Boxed& boxed, Place& place);
    bool addClipArea(Node clip, const Boxed& boxed, Place& place);
    bool turnToBox(std::string_view units, const Boxed& boxed, Place& base);
    std::optional<std::vector<PathShape>> clipShapes(Node clip, const Place& base);
    bool addClipShape(Node node, const Place& base, std::vector<PathShape>& shapes);
    bool addCut(PathShape shape, const ClipAreas& areas, std::vector<PathShape>& shapes);
    bool addCssClip(std::string_view value, const Boxed& boxed, Place& place);
    std::optional<Box> cssBox(std::string_view name, const Boxed& boxed);
    bool addWindows(ClipWindows windows, Place& place);
    void nameClipPath(Node clip, const ClipArea& area, const ClipAreas& around);
    void nameOtherClipPaths(const Place& root);
    const Properties& inheritedBy(Node node);
    /// The shapes of a mask, from bottom to top.
    struct MaskShapes {
        bool takes(const std::optional<Colour>& colour);

        ClipWindows windows{};
        bool byAlpha = false;             ///< whether colours do not count
        std::optional<double> strength{}; ///< how much of the content they show
        bool isFaint = false;             ///< whether the only shape is not opaque
        int paints = 0;                   ///< that show something
    };
    void addMask(const Boxed& boxed, Place& place);
    bool addMaskArea(Node mask, const Boxed& boxed, Place& place);
    bool addMaskRegion(Node mask, const Boxed& boxed, const Place& base, Place& place);
    bool addMaskContent(Node node, const Place& place, MaskShapes& shapes);
    bool addMaskElement(Node node, const Place& around, MaskShapes& shapes);
    bool addMaskShape(Node node, const Place& place, MaskShapes& shapes);
    void addViewportClip(const Box& viewport, Place& place);

    struct Texts;
    struct TextLineStyle;
    enum class TextLineKind : std::uint8_t { Under, Over, Through };
    /// What a part of a text inherits, beside its style.
    struct TextSpan {
        std::shared_ptr<const PathWalk> path{};
        double startOffset = 0;
        double raised = 0;
        bool keepsBlanks = false;
        bool vertical = false; ///< as the <text> says, whatever is said within it
        std::array<std::shared_ptr<const TextLineStyle>, 3> lines{};
    };
    void drawText(Node node, const Place& around);
    static bool hasLines(const TextParts& parts, const Texts& texts);
    void drawLine(const LaidLetters& letters, const Texts& texts, TextLineKind kind);
    double scriptShift(const Properties& properties, const Place& around);
    void addLines(const Place& place, TextSpan& span);
    void drawLetters(const LaidLetters& letters, const Texts& texts, Particulars own);
    void addBoundsOfText(Node node, const Place& place, ElementBounds& bounds);
    std::vector<Subpath> letterPaths(Node node, const Place& place);
    TextParts textParts(Node node, const Place& place, Texts& texts);
    void collectText(Node node, const Place& place, const TextSpan& around, Texts& texts);
    void collectReferred(Node node, const Place& place, TextSpan span, Texts& texts);
    void appendText(Node node, std::size_t run, const TextSpan& span, Texts& texts);
    void countLetters(std::size_t count);
    void collectSpan(Node node, const Place& around, TextSpan span, Texts& texts);
    bool turnToPath(Node node, const Place& place, TextSpan& span);
    void addRun(const Place& place, const TextSpan& span, Texts& texts);
    LineFont lineFontOf(const Properties& properties);
    const NamedFont& fontOf(const Properties& properties);

    struct Image {
        Underlay underlay;
        bool shown;
    };
    void findImages();
    bool holdsImage(Node node) const { return !holdsImage_.empty() && holdsImage_[node]; }
    Node firstImage(Node layer) const;
    void drawImage(Node node, const Place& around);
    SharedUnderlay takeFirstImage(Node layer, const Place& place);
    std::optional<Image> imageOf(Node node, const Place& around);
    std::optional<Box> imageBox(Node node, const Place& place);
    bool clipImage(Underlay& image, const ClipWindows& windows);
    bool clipImage(Underlay& image, const ClipAreas& areas);
    const ImageSource::Found& findImage(Node node);
    const SvgImage* svgImageOf(Node node);
    void countImage();
    void drawSvgImage(Node node, const SvgImage& image, const Place& around);
    struct SvgFrame;
    std::optional<Document> drawnImage(const SvgImage& image, const SvgFrame& frame,
                                       const Place& place);
    void addDrawing(const Document& drawing, Container container, const Place& place);
    void addImage(Underlay image, Container layer, const Place& place);
    void takeWork(TreeDrawer& of);

    std::optional<Colour> patternColour(Node pattern, const Box& box, const Lengths& lengths);
    std::optional<Colour> tileColour(Node pattern, const Matrix& matrix, const Lengths& lengths);
    bool hasMarkers(const Properties& properties) const;
    bool isMarker(Node node) const;
    void reportMissingMarkers(const Properties& properties);
    void drawMarkers(const std::vector<MarkerVertex>& vertices, const Place& place);
    void drawMarker(Node marker, const MarkerVertex& vertex, const Place& around);
    bool turnToMarker(Node marker, Place& place);
    bool fitsMarker(Node marker, const Place& place, const Matrix& toViewport, const Box& viewport);

    /// A shape in the document's coordinates.
    struct Drawn {
        std::vector<Subpath> paths;
    };
    void addShape(Drawn drawn, const Place& place, Particulars particulars,
                  const std::vector<MarkerVertex>& markers = {});
    void paintInOrder(Object object, const Place& place, const std::vector<MarkerVertex>& markers);
    Outline outlineOf(const OutlineKind& kind, Node node, const Place& place);
    std::vector<Subpath> placed(Outline outline, const Matrix& matrix);
    void scaleDashes(Node node, const Outline& outline, Properties& properties);
    Particulars particularsOf(Node node);
    QString idOf(Node node);

    const Tree& tree_;
    Report& report_;
    Styles& styles_;
    Paints paints_;
    const Page& page_;
    ClippedContent content_;
    Node node_ = 0;
    std::vector<Node> used_; ///< the targets of the <use> elements and markers being drawn
    std::unordered_map<Node, bool> markersThatFit_;   ///< whether nothing of them is to be cut
    std::vector<Node> patterns_;                      ///< in which this is drawn
    using TileKey = std::tuple<Node, double, double>; ///< a pattern, and the size of its tile
    std::map<TileKey, std::optional<Colour>> tiles_;  ///< mean colours
    std::vector<Node> clipping_; ///< the clip paths whose content is being read
    /// What elements in a clip path inherit; usually many have the same parent.
    std::pair<Node, Properties> inherited_{noNode, {}};
    std::vector<NamedArea> clipPaths_;
    std::unordered_set<Node> named_; ///< the elements of these
    std::size_t repeated_ = 0;       ///< number of elements drawn through <use>
    std::size_t bounded_ = 0;        ///< number of elements of which boxes were computed
    std::size_t letters_ = 0;        ///< number of letters of texts
    LineFonts lineFonts_;
    std::unordered_map<std::string, NamedFont> fonts_; ///< by lists of families
    ImageSource imageSource_;
    std::vector<bool> holdsImage_; ///< by element; empty: there are no images
    Node ownImage_ = noNode;       ///< the last image that became that of the layer around it
    int images_ = 0;               ///< number of images drawn
    bool hasConditions_ = false;   ///< whether the file names languages or extensions
    std::vector<bool> idIsTaken_;  ///< for the first element with an id: whether the id is in use
    int notesKept_ = 0;
};

} // namespace app::svg
