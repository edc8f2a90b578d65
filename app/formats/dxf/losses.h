// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/losses.h"

// All kinds of content that reading a DXF file cannot keep, or keeps in another form, in the words
// of the report.

namespace app::dxf {

using svg::LossKind;

namespace losses {

inline constexpr LossKind unread{QT_TRANSLATE_NOOP("Text", "entity of the type %1"),
                                 QT_TRANSLATE_NOOP("Text", "entities of the type %1"),
                                 false,
                                 nullptr,
                                 nullptr,
                                 true};
inline constexpr LossKind badEntity{QT_TRANSLATE_NOOP("Text", "damaged entity of the type %1"),
                                    QT_TRANSLATE_NOOP("Text", "damaged entities of the type %1"),
                                    false,
                                    nullptr,
                                    nullptr,
                                    true};
inline constexpr LossKind damage{
    QT_TRANSLATE_NOOP("Text", "rest of the file, which is damaged here"),
    QT_TRANSLATE_NOOP("Text", "rests of the file, which is damaged here"), false,
    QT_TRANSLATE_NOOP("Text", "what comes before is kept"),
    QT_TRANSLATE_NOOP("Text", "what comes before is kept")};
inline constexpr LossKind truncated{
    QT_TRANSLATE_NOOP("Text", "end of a file that is cut off here"),
    QT_TRANSLATE_NOOP("Text", "ends of files that are cut off here"), false,
    QT_TRANSLATE_NOOP("Text", "what comes before is kept"),
    QT_TRANSLATE_NOOP("Text", "what comes before is kept")};
inline constexpr LossKind badTableEntry{
    QT_TRANSLATE_NOOP("Text", "damaged setting, layer, line type or text style"),
    QT_TRANSLATE_NOOP("Text", "damaged settings, layers, line types or text styles")};
inline constexpr LossKind noUnit{
    QT_TRANSLATE_NOOP("Text", "file without a unit was read in millimetres"),
    QT_TRANSLATE_NOOP("Text", "files without a unit were read in millimetres"), true};
inline constexpr LossKind newerVersion{
    QT_TRANSLATE_NOOP("Text", "file of the unknown version %1 was read as version 2018"),
    QT_TRANSLATE_NOOP("Text", "files of the unknown versions %1 were read as version 2018"), true};
inline constexpr LossKind paperSpace{
    QT_TRANSLATE_NOOP("Text", "entity in paper space was left out"),
    QT_TRANSLATE_NOOP("Text", "entities in paper space were left out"), true};
inline constexpr LossKind insert{
    QT_TRANSLATE_NOOP("Text", "inserted block became separate shapes"),
    QT_TRANSLATE_NOOP("Text", "inserted blocks became separate shapes"), true};
inline constexpr LossKind selfInsert{QT_TRANSLATE_NOOP("Text", "block that contains itself"),
                                     QT_TRANSLATE_NOOP("Text", "blocks that contain themselves")};
inline constexpr LossKind deepInsert{
    QT_TRANSLATE_NOOP("Text", "insertion nested more than 50 deep"),
    QT_TRANSLATE_NOOP("Text", "insertions nested more than 50 deep")};
inline constexpr LossKind missingBlock{
    QT_TRANSLATE_NOOP("Text", "insertion of a block that is not in the file"),
    QT_TRANSLATE_NOOP("Text", "insertions of blocks that are not in the file")};
inline constexpr LossKind otherDrawing{QT_TRANSLATE_NOOP("Text", "reference to another drawing"),
                                       QT_TRANSLATE_NOOP("Text", "references to other drawings")};
inline constexpr LossKind dimension{QT_TRANSLATE_NOOP("Text", "dimension became separate shapes"),
                                    QT_TRANSLATE_NOOP("Text", "dimensions became separate shapes"),
                                    true};
inline constexpr LossKind plainDimension{
    QT_TRANSLATE_NOOP("Text", "dimension without the block that draws it"),
    QT_TRANSLATE_NOOP("Text", "dimensions without the blocks that draw them")};
inline constexpr LossKind heights{
    QT_TRANSLATE_NOOP("Text", "shape above or below the plane was drawn as seen from above"),
    QT_TRANSLATE_NOOP("Text", "shapes above or below the plane were drawn as seen from above"),
    true};
inline constexpr LossKind sizeless{
    QT_TRANSLATE_NOOP("Text", "entity without a size was left out"),
    QT_TRANSLATE_NOOP("Text", "entities without a size were left out"), true};
inline constexpr LossKind unevenWidth{QT_TRANSLATE_NOOP("Text", "polyline whose width changes"),
                                      QT_TRANSLATE_NOOP("Text", "polylines whose widths change"),
                                      false, QT_TRANSLATE_NOOP("Text", "its line is kept"),
                                      QT_TRANSLATE_NOOP("Text", "their lines are kept")};
inline constexpr LossKind mesh{QT_TRANSLATE_NOOP("Text", "mesh of a polyline"),
                               QT_TRANSLATE_NOOP("Text", "meshes of polylines")};
inline constexpr LossKind missingLineType{
    QT_TRANSLATE_NOOP("Text", "line type %1 that is not in the file was read as continuous"),
    QT_TRANSLATE_NOOP("Text", "line types %1 that are not in the file were read as continuous"),
    true};
inline constexpr LossKind complexLineType{
    QT_TRANSLATE_NOOP("Text", "line type with texts or symbols"),
    QT_TRANSLATE_NOOP("Text", "line types with texts or symbols"), false,
    QT_TRANSLATE_NOOP("Text", "its dashes are kept"),
    QT_TRANSLATE_NOOP("Text", "their dashes are kept")};
inline constexpr LossKind layers{
    QT_TRANSLATE_NOOP("Text", "layer beyond the first 1,000"),
    QT_TRANSLATE_NOOP("Text", "layers beyond the first 1,000"), false,
    QT_TRANSLATE_NOOP("Text", "it became one with the last of them"),
    QT_TRANSLATE_NOOP("Text", "they became one with the last of them")};
inline constexpr LossKind hatchPattern{QT_TRANSLATE_NOOP("Text", "hatch pattern"),
                                       QT_TRANSLATE_NOOP("Text", "hatch patterns"), false,
                                       QT_TRANSLATE_NOOP("Text", "its outline is kept"),
                                       QT_TRANSLATE_NOOP("Text", "their outlines are kept")};
inline constexpr LossKind gradient{QT_TRANSLATE_NOOP("Text", "gradient of a hatch"),
                                   QT_TRANSLATE_NOOP("Text", "gradients of hatches"), false,
                                   QT_TRANSLATE_NOOP("Text", "one colour is kept"),
                                   QT_TRANSLATE_NOOP("Text", "one colour is kept")};
inline constexpr LossKind arrowhead{QT_TRANSLATE_NOOP("Text", "arrowhead of a leader"),
                                    QT_TRANSLATE_NOOP("Text", "arrowheads of leaders"), false,
                                    QT_TRANSLATE_NOOP("Text", "its line is kept"),
                                    QT_TRANSLATE_NOOP("Text", "their lines are kept")};
inline constexpr LossKind text{QT_TRANSLATE_NOOP("Text", "text was drawn in letters of strokes"),
                               QT_TRANSLATE_NOOP("Text", "texts were drawn in letters of strokes"),
                               true};
inline constexpr LossKind missingLetters{
    QT_TRANSLATE_NOOP("Text",
                      "text with letters that the font lacks (%1): boxes stand in their place"),
    QT_TRANSLATE_NOOP("Text",
                      "texts with letters that the font lacks (%1): boxes stand in their place")};
inline constexpr LossKind longText{QT_TRANSLATE_NOOP("Text", "text of more than 10,000 letters"),
                                   QT_TRANSLATE_NOOP("Text", "texts of more than 10,000 letters")};
inline constexpr LossKind otherCodePage{
    QT_TRANSLATE_NOOP("Text", "text in the code page %1 was read as Western European"),
    QT_TRANSLATE_NOOP("Text", "texts in the code page %1 were read as Western European"), true};

} // namespace losses
} // namespace app::dxf
