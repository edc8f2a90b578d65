// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

// All kinds of content that an import cannot keep, or keeps in another form, in the words of the
// report: "1 mask", "2 masks".

namespace app::svg {

struct LossKind {
    const char* one;
    const char* many;
    bool remark = false;              ///< kept in another form
    const char* oneInstead = nullptr; ///< kept instead, or required; null: nothing
    const char* manyInstead = nullptr;
    bool each = false;     ///< an entry of the report for each text, not for all together
    bool cut = false;      ///< a remark on something that was cut (Loss::cut)
    bool outlined = false; ///< a remark on texts (Loss::outlined)
};

namespace losses {

inline constexpr LossKind text{QT_TRANSLATE_NOOP("Text", "text"),
                               QT_TRANSLATE_NOOP("Text", "texts")};
// What is drawn of texts; saving it over the file would lose the texts themselves.
inline constexpr LossKind outlinedText{
    QT_TRANSLATE_NOOP("Text", "text became the outlines of its letters"),
    QT_TRANSLATE_NOOP("Text", "texts became the outlines of their letters"),
    true,
    nullptr,
    nullptr,
    false,
    false,
    true};
inline constexpr LossKind replacedFont{
    QT_TRANSLATE_NOOP("Text", "use of a font that is not installed was replaced: %1"),
    QT_TRANSLATE_NOOP("Text", "uses of a font that is not installed were replaced: %1"),
    true,
    nullptr,
    nullptr,
    true};
inline constexpr LossKind letter{QT_TRANSLATE_NOOP("Text", "letter %1 that no installed font has"),
                                 QT_TRANSLATE_NOOP("Text", "letters %1 that no installed font has"),
                                 false, QT_TRANSLATE_NOOP("Text", "a box stands in its place"),
                                 QT_TRANSLATE_NOOP("Text", "boxes stand in their places")};
inline constexpr LossKind pictureLetter{
    QT_TRANSLATE_NOOP("Text", "letter that is a picture in its font"),
    QT_TRANSLATE_NOOP("Text", "letters that are pictures in their fonts")};
inline constexpr LossKind smallCapitals{
    QT_TRANSLATE_NOOP("Text", "use of small capitals was drawn with capitals made smaller"),
    QT_TRANSLATE_NOOP("Text", "uses of small capitals were drawn with capitals made smaller"),
    true};
inline constexpr LossKind offPath{
    QT_TRANSLATE_NOOP("Text", "text was cut off where its path ends"),
    QT_TRANSLATE_NOOP("Text", "texts were cut off where their paths end"), true};
inline constexpr LossKind pathlessText{
    QT_TRANSLATE_NOOP("Text", "text on a path that is not in the file was left out"),
    QT_TRANSLATE_NOOP("Text", "texts on paths that are not in the file were left out"), true};
inline constexpr LossKind image{QT_TRANSLATE_NOOP("Text", "image"),
                                QT_TRANSLATE_NOOP("Text", "images")};
inline constexpr LossKind imageElsewhere{
    QT_TRANSLATE_NOOP("Text", "image that is neither in the file nor in its folder or below"),
    QT_TRANSLATE_NOOP("Text", "images that are neither in the file nor in its folder or below")};
inline constexpr LossKind imageMissing{
    QT_TRANSLATE_NOOP("Text", "image whose own file is missing or cannot be read"),
    QT_TRANSLATE_NOOP("Text", "images whose own files are missing or cannot be read")};
inline constexpr LossKind imageKind{
    QT_TRANSLATE_NOOP("Text", "image that is neither PNG, JPEG, GIF nor SVG"),
    QT_TRANSLATE_NOOP("Text", "images that are neither PNG, JPEG, GIF nor SVG")};
inline constexpr LossKind imageOfImage{
    QT_TRANSLATE_NOOP("Text", "image that an SVG image takes from another file"),
    QT_TRANSLATE_NOOP("Text", "images that SVG images take from other files")};
inline constexpr LossKind imageTooDeep{
    QT_TRANSLATE_NOOP("Text", "SVG image in more than five others"),
    QT_TRANSLATE_NOOP("Text", "SVG images in more than five others")};
inline constexpr LossKind imageTooComplex{
    QT_TRANSLATE_NOOP("Text", "SVG image with more than a drawing can have"),
    QT_TRANSLATE_NOOP("Text", "SVG images with, or after one with, more than a drawing can have")};
inline constexpr LossKind imageDamaged{QT_TRANSLATE_NOOP("Text", "damaged image"),
                                       QT_TRANSLATE_NOOP("Text", "damaged images")};
inline constexpr LossKind imageTooLarge{
    QT_TRANSLATE_NOOP("Text", "image that is too large"),
    QT_TRANSLATE_NOOP("Text", "images that are too large"), false,
    QT_TRANSLATE_NOOP("Text", "at most 100 million pixels and 64 MB are possible, and in all "
                              "images of a file 200 million pixels and 256 MB"),
    QT_TRANSLATE_NOOP("Text", "at most 100 million pixels and 64 MB are possible, and in all "
                              "images of a file 200 million pixels and 256 MB")};
inline constexpr LossKind imageBeyond{QT_TRANSLATE_NOOP("Text", "image beyond the first 500"),
                                      QT_TRANSLATE_NOOP("Text", "images beyond the first 500")};
inline constexpr LossKind profileColour{
    QT_TRANSLATE_NOOP("Text", "colour of a colour profile"),
    QT_TRANSLATE_NOOP("Text", "colours of colour profiles"), false,
    QT_TRANSLATE_NOOP("Text", "the colour given beside it is used"),
    QT_TRANSLATE_NOOP("Text", "the colours given beside them are used")};
inline constexpr LossKind sharpPixels{QT_TRANSLATE_NOOP("Text", "image with sharp pixels"),
                                      QT_TRANSLATE_NOOP("Text", "images with sharp pixels"), false,
                                      QT_TRANSLATE_NOOP("Text", "its pixels are smoothed"),
                                      QT_TRANSLATE_NOOP("Text", "their pixels are smoothed")};
inline constexpr LossKind imageUncut{
    QT_TRANSLATE_NOOP("Text", "clip path of an image that is not one convex polygon"),
    QT_TRANSLATE_NOOP("Text", "clip paths of images that are not one convex polygon"), false,
    QT_TRANSLATE_NOOP("Text", "the image is not cut"),
    QT_TRANSLATE_NOOP("Text", "the images are not cut")};
inline constexpr LossKind foreignObject{QT_TRANSLATE_NOOP("Text", "foreign object"),
                                        QT_TRANSLATE_NOOP("Text", "foreign objects")};
inline constexpr LossKind animation{QT_TRANSLATE_NOOP("Text", "animation"),
                                    QT_TRANSLATE_NOOP("Text", "animations")};
inline constexpr LossKind script{QT_TRANSLATE_NOOP("Text", "script"),
                                 QT_TRANSLATE_NOOP("Text", "scripts")};
inline constexpr LossKind gradient{QT_TRANSLATE_NOOP("Text", "gradient"),
                                   QT_TRANSLATE_NOOP("Text", "gradients"), false,
                                   QT_TRANSLATE_NOOP("Text", "its mean colour is used"),
                                   QT_TRANSLATE_NOOP("Text", "their mean colours are used")};
inline constexpr LossKind emptyGradient{
    QT_TRANSLATE_NOOP("Text", "gradient without colours, which paints nothing"),
    QT_TRANSLATE_NOOP("Text", "gradients without colours, which paint nothing"), true};
inline constexpr LossKind pattern{QT_TRANSLATE_NOOP("Text", "pattern"),
                                  QT_TRANSLATE_NOOP("Text", "patterns"), false,
                                  QT_TRANSLATE_NOOP("Text", "its mean colour is used"),
                                  QT_TRANSLATE_NOOP("Text", "their mean colours are used")};
inline constexpr LossKind mask{QT_TRANSLATE_NOOP("Text", "mask"),
                               QT_TRANSLATE_NOOP("Text", "masks")};
inline constexpr LossKind filter{QT_TRANSLATE_NOOP("Text", "filter"),
                                 QT_TRANSLATE_NOOP("Text", "filters")};
inline constexpr LossKind blending{QT_TRANSLATE_NOOP("Text", "blend mode"),
                                   QT_TRANSLATE_NOOP("Text", "blend modes")};
inline constexpr LossKind marker{QT_TRANSLATE_NOOP("Text", "arrowhead or other marker"),
                                 QT_TRANSLATE_NOOP("Text", "arrowheads or other markers"), false,
                                 QT_TRANSLATE_NOOP("Text", "its line is kept"),
                                 QT_TRANSLATE_NOOP("Text", "their lines are kept")};
inline constexpr LossKind drawnMarker{
    QT_TRANSLATE_NOOP("Text", "arrowhead or other marker became shapes beside its line"),
    QT_TRANSLATE_NOOP("Text", "arrowheads or other markers became shapes beside their lines"),
    true};
inline constexpr LossKind clipPathUnits{
    QT_TRANSLATE_NOOP("Text", "clip path in the box of something with texts or images"),
    QT_TRANSLATE_NOOP("Text", "clip paths in the boxes of something with texts or images")};
inline constexpr LossKind clipPathContent{QT_TRANSLATE_NOOP("Text", "clip path with an element %1"),
                                          QT_TRANSLATE_NOOP("Text", "clip paths with elements %1")};
inline constexpr LossKind manyClipShapes{
    QT_TRANSLATE_NOOP("Text", "clip path with more than 1,000 shapes that overlap"),
    QT_TRANSLATE_NOOP("Text", "clip paths with more than 1,000 shapes that overlap")};
inline constexpr LossKind crossedClipPath{
    QT_TRANSLATE_NOOP("Text", "clip path with more than 5 million crossings of lines"),
    QT_TRANSLATE_NOOP("Text", "clip paths with more than 5 million crossings of lines")};
inline constexpr LossKind selfClip{QT_TRANSLATE_NOOP("Text", "clip path that clips itself"),
                                   QT_TRANSLATE_NOOP("Text", "clip paths that clip themselves")};
inline constexpr LossKind missingClipPath{
    QT_TRANSLATE_NOOP("Text", "reference to a clip path that is not in the file was ignored"),
    QT_TRANSLATE_NOOP("Text", "references to clip paths that are not in the file were ignored"),
    true};
inline constexpr LossKind notInClipPath{
    QT_TRANSLATE_NOOP("Text", "element that SVG does not use in a clip path was left out"),
    QT_TRANSLATE_NOOP("Text", "elements that SVG does not use in a clip path were left out"), true};
inline constexpr LossKind cutShape{
    QT_TRANSLATE_NOOP("Text", "shape was cut where a clip path ends"),
    QT_TRANSLATE_NOOP("Text", "shapes were cut where clip paths end"),
    true,
    nullptr,
    nullptr,
    false,
    true};
inline constexpr LossKind hiddenShape{
    QT_TRANSLATE_NOOP("Text", "shape that a clip path hides was removed"),
    QT_TRANSLATE_NOOP("Text", "shapes that clip paths hide were removed"),
    true,
    nullptr,
    nullptr,
    false,
    true};
inline constexpr LossKind wideStroke{
    QT_TRANSLATE_NOOP("Text", "wide stroke was cut at its centre line, and does not end where its "
                              "clip path does"),
    QT_TRANSLATE_NOOP("Text", "wide strokes were cut at their centre lines, and do not end where "
                              "their clip paths do"),
    true};
inline constexpr LossKind hiddenStroke{
    QT_TRANSLATE_NOOP("Text", "wide stroke of which a clip path shows only a side"),
    QT_TRANSLATE_NOOP("Text", "wide strokes of which clip paths show only a side")};
inline constexpr LossKind wholeStroke{
    QT_TRANSLATE_NOOP("Text", "wide stroke that reaches out of its clip path"),
    QT_TRANSLATE_NOOP("Text", "wide strokes that reach out of their clip paths"), false,
    QT_TRANSLATE_NOOP("Text", "it keeps its whole width"),
    QT_TRANSLATE_NOOP("Text", "they keep their whole width")};
inline constexpr LossKind unevenStroke{QT_TRANSLATE_NOOP("Text", "unevenly stretched stroke"),
                                       QT_TRANSLATE_NOOP("Text", "unevenly stretched strokes"),
                                       false, QT_TRANSLATE_NOOP("Text", "it has its mean width"),
                                       QT_TRANSLATE_NOOP("Text", "they have their mean widths")};
inline constexpr LossKind longDashes{QT_TRANSLATE_NOOP("Text", "dash pattern that is too long"),
                                     QT_TRANSLATE_NOOP("Text", "dash patterns that are too long")};
inline constexpr LossKind damaged{QT_TRANSLATE_NOOP("Text", "part of a damaged shape"),
                                  QT_TRANSLATE_NOOP("Text", "parts of damaged shapes"), false,
                                  QT_TRANSLATE_NOOP("Text", "the rest is kept"),
                                  QT_TRANSLATE_NOOP("Text", "the rest is kept")};
// %1 stands for the text found in the file.
inline constexpr LossKind property{QT_TRANSLATE_NOOP("Text", "use of the style property %1"),
                                   QT_TRANSLATE_NOOP("Text", "uses of the style property %1"),
                                   false,
                                   nullptr,
                                   nullptr,
                                   true};
inline constexpr LossKind attribute{QT_TRANSLATE_NOOP("Text", "use of the attribute %1"),
                                    QT_TRANSLATE_NOOP("Text", "uses of the attribute %1"),
                                    false,
                                    nullptr,
                                    nullptr,
                                    true};
inline constexpr LossKind unknownAttribute{
    QT_TRANSLATE_NOOP("Text", "attribute %1 that SVG does not have was ignored"),
    QT_TRANSLATE_NOOP("Text", "attributes %1 that SVG does not have were ignored"),
    true,
    nullptr,
    nullptr,
    true};
inline constexpr LossKind value{QT_TRANSLATE_NOOP("Text", "value %1 that is not understood"),
                                QT_TRANSLATE_NOOP("Text", "values %1 that are not understood"),
                                false,
                                nullptr,
                                nullptr,
                                true};
inline constexpr LossKind styleRule{QT_TRANSLATE_NOOP("Text", "style rule %1"),
                                    QT_TRANSLATE_NOOP("Text", "style rules %1"),
                                    false,
                                    nullptr,
                                    nullptr,
                                    true};
inline constexpr LossKind unknownBox{
    QT_TRANSLATE_NOOP("Text", "transform in the box of something with texts or images"),
    QT_TRANSLATE_NOOP("Text", "transforms in the box of something with texts or images")};
inline constexpr LossKind paintServer{QT_TRANSLATE_NOOP("Text", "paint of the kind %1"),
                                      QT_TRANSLATE_NOOP("Text", "paints of the kind %1")};
inline constexpr LossKind strokeBelow{
    QT_TRANSLATE_NOOP("Text", "stroke below the fill of its shape became a shape of its own"),
    QT_TRANSLATE_NOOP("Text", "strokes below the fills of their shapes became shapes of their own"),
    true};
inline constexpr LossKind strokeApart{
    QT_TRANSLATE_NOOP("Text", "stroke above the markers of its shape became a shape of its own"),
    QT_TRANSLATE_NOOP("Text",
                      "strokes above the markers of their shapes became shapes of their own"),
    true};
inline constexpr LossKind selfUse{
    QT_TRANSLATE_NOOP("Text", "<use> that contains itself"),
    QT_TRANSLATE_NOOP("Text", "<use> elements that contain themselves")};
inline constexpr LossKind unknownElement{
    QT_TRANSLATE_NOOP("Text", "element %1 that SVG does not have was left out"),
    QT_TRANSLATE_NOOP("Text", "elements %1 that SVG does not have were left out"),
    true,
    nullptr,
    nullptr,
    true};
inline constexpr LossKind replacedForeign{
    QT_TRANSLATE_NOOP("Text", "foreign object was replaced by what the file has in place of it"),
    QT_TRANSLATE_NOOP("Text",
                      "foreign objects were replaced by what the file has in place of them"),
    true};
inline constexpr LossKind language{
    QT_TRANSLATE_NOOP("Text", "element for another language than English"),
    QT_TRANSLATE_NOOP("Text", "elements for other languages than English")};
inline constexpr LossKind extension{
    QT_TRANSLATE_NOOP("Text", "element that only programs with an extension draw was left out"),
    QT_TRANSLATE_NOOP("Text", "elements that only programs with an extension draw were left out"),
    true};
inline constexpr LossKind rootCondition{
    QT_TRANSLATE_NOOP("Text", "drawing for another language or extension was read all the same"),
    QT_TRANSLATE_NOOP("Text", "drawings for other languages or extensions were read all the same"),
    true};
inline constexpr LossKind emptyPage{
    QT_TRANSLATE_NOOP(
        "Text", "size of the drawing of 0 or less, with which SVG draws nothing, was ignored"),
    QT_TRANSLATE_NOOP(
        "Text", "sizes of the drawing of 0 or less, with which SVG draws nothing, were ignored"),
    true};
inline constexpr LossKind sizeless{
    QT_TRANSLATE_NOOP("Text", "element of size 0 or less, which SVG does not draw, was left out"),
    QT_TRANSLATE_NOOP("Text", "elements of size 0 or less, which SVG does not draw, were left out"),
    true};
inline constexpr LossKind emptyViewBox{
    QT_TRANSLATE_NOOP("Text", "viewBox that is no rectangle was ignored"),
    QT_TRANSLATE_NOOP("Text", "viewBoxes that are no rectangles were ignored"), true};
inline constexpr LossKind undeclaredPrefix{
    QT_TRANSLATE_NOOP("Text", "prefix %1 without a declaration was read as usual"),
    QT_TRANSLATE_NOOP("Text", "prefixes %1 without a declaration were read as usual"), true};
inline constexpr LossKind htmlEntity{
    QT_TRANSLATE_NOOP("Text", "name of a character without a declaration was read as in HTML: %1"),
    QT_TRANSLATE_NOOP("Text", "names of characters without a declaration were read as in HTML: %1"),
    true};
inline constexpr LossKind blankBeginning{
    QT_TRANSLATE_NOOP("Text", "beginning with blanks before <?xml was skipped"),
    QT_TRANSLATE_NOOP("Text", "beginnings with blanks before <?xml were skipped"), true};
inline constexpr LossKind otherFile{QT_TRANSLATE_NOOP("Text", "reference to another file"),
                                    QT_TRANSLATE_NOOP("Text", "references to other files")};
inline constexpr LossKind elementNote{
    QT_TRANSLATE_NOOP("Text", "title, description or metadata of an element"),
    QT_TRANSLATE_NOOP("Text", "titles, descriptions or metadata of elements")};
inline constexpr LossKind metadata{
    QT_TRANSLATE_NOOP("Text", "title, description and metadata of more than 16 MB"),
    QT_TRANSLATE_NOOP("Text", "titles, descriptions and metadata of more than 16 MB")};
inline constexpr LossKind layers{QT_TRANSLATE_NOOP("Text", "stack of too many layers"),
                                 QT_TRANSLATE_NOOP("Text", "stacks of too many layers"), false,
                                 QT_TRANSLATE_NOOP("Text", "the upper layers became one"),
                                 QT_TRANSLATE_NOOP("Text", "the upper layers became one")};

inline constexpr LossKind windows{QT_TRANSLATE_NOOP("Text", "clip window beyond the first 1,000"),
                                  QT_TRANSLATE_NOOP("Text", "clip windows beyond the first 1,000")};

inline constexpr LossKind guides{QT_TRANSLATE_NOOP("Text", "guide beyond the first 1,000"),
                                 QT_TRANSLATE_NOOP("Text", "guides beyond the first 1,000")};
inline constexpr LossKind unreadableGuide{
    QT_TRANSLATE_NOOP("Text", "guide without a finite x or y"),
    QT_TRANSLATE_NOOP("Text", "guides without a finite x or y")};

inline constexpr LossKind unreadableSheets{
    QT_TRANSLATE_NOOP("Text", "division among sheets with a missing or invalid number"),
    QT_TRANSLATE_NOOP("Text", "divisions among sheets with a missing or invalid number")};

inline constexpr LossKind unreadableScale{
    QT_TRANSLATE_NOOP("Text", "scale, unit, margins or background of the page that are not valid"),
    QT_TRANSLATE_NOOP("Text", "scales, units, margins or backgrounds of pages that are not valid"),
    false, QT_TRANSLATE_NOOP("Text", "the usual ones are used"),
    QT_TRANSLATE_NOOP("Text", "the usual ones are used")};

inline constexpr LossKind invertedWindow{
    QT_TRANSLATE_NOOP("Text", "inverted clip window"),
    QT_TRANSLATE_NOOP("Text", "inverted clip windows"), false,
    QT_TRANSLATE_NOOP("Text", "its left or top edge is beyond the opposite one"),
    QT_TRANSLATE_NOOP("Text", "their left or top edges are beyond the opposite ones")};
inline constexpr LossKind unreadableWindow{
    QT_TRANSLATE_NOOP("Text", "clip window with a missing or invalid number"),
    QT_TRANSLATE_NOOP("Text", "clip windows with a missing or invalid number"), false,
    QT_TRANSLATE_NOOP(
        "Text",
        "xmin, ymin, xmax and ymax, or corners, are needed, all finite; an angle ends with rad"),
    QT_TRANSLATE_NOOP(
        "Text",
        "xmin, ymin, xmax and ymax, or corners, are needed, all finite; an angle ends with rad")};
// %1 stands for the texts found in the file.
inline constexpr LossKind unknownOperation{
    QT_TRANSLATE_NOOP("Text", "clip window with the unknown operation %1"),
    QT_TRANSLATE_NOOP("Text", "clip windows with the unknown operation %1"), false,
    QT_TRANSLATE_NOOP("Text", "the operations are add, cut-out, intersect and replace"),
    QT_TRANSLATE_NOOP("Text", "the operations are add, cut-out, intersect and replace")};
inline constexpr LossKind unknownKeep{
    QT_TRANSLATE_NOOP("Text", "unknown value %1 of “keep” (inside or outside) was read as inside"),
    QT_TRANSLATE_NOOP("Text",
                      "unknown values %1 of “keep” (inside or outside) were read as inside"),
    true};
inline constexpr LossKind unknownVisible{
    QT_TRANSLATE_NOOP("Text", "unknown value %1 of “visible” (yes or no) was read as yes"),
    QT_TRANSLATE_NOOP("Text", "unknown values %1 of “visible” (yes or no) were read as yes"), true};
inline constexpr LossKind unknownColour{
    QT_TRANSLATE_NOOP("Text", "unknown colour %1 of a clip window was replaced by the usual one"),
    QT_TRANSLATE_NOOP("Text", "unknown colours %1 of clip windows were replaced by the usual one"),
    true};
inline constexpr LossKind containers{
    QT_TRANSLATE_NOOP("Text", "group beyond the limit was dissolved"),
    QT_TRANSLATE_NOOP("Text", "groups beyond the limit were dissolved"), true};
inline constexpr LossKind doubleId{QT_TRANSLATE_NOOP("Text", "repeated id was removed"),
                                   QT_TRANSLATE_NOOP("Text", "repeated ids were removed"), true};
inline constexpr LossKind cutClipPath{
    QT_TRANSLATE_NOOP("Text", "clip path was replaced by a real cut"),
    QT_TRANSLATE_NOOP("Text", "clip paths were replaced by real cuts"),
    true,
    nullptr,
    nullptr,
    false,
    true};
inline constexpr LossKind keptClipPath{QT_TRANSLATE_NOOP("Text", "clip path was kept"),
                                       QT_TRANSLATE_NOOP("Text", "clip paths were kept"), true};
inline constexpr LossKind keptMask{QT_TRANSLATE_NOOP("Text", "mask was kept as a clip path"),
                                   QT_TRANSLATE_NOOP("Text", "masks were kept as clip paths"),
                                   true};
inline constexpr LossKind cutMask{QT_TRANSLATE_NOOP("Text", "mask was replaced by a real cut"),
                                  QT_TRANSLATE_NOOP("Text", "masks were replaced by real cuts"),
                                  true,
                                  nullptr,
                                  nullptr,
                                  false,
                                  true};
inline constexpr LossKind groupOpacity{
    QT_TRANSLATE_NOOP("Text", "group opacity was moved to each shape"),
    QT_TRANSLATE_NOOP("Text", "group opacities were moved to each shape"), true};

} // namespace losses
} // namespace app::svg
