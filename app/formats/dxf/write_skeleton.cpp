// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/write_skeleton.h"

#include <algorithm>
#include <utility>

namespace app::dxf::writing {
namespace {

void beginSection(TagWriter& tags, std::string_view name) { tags.all({{0, "SECTION"}, {2, name}}); }

/// The tables of a drawing. R12 knows no handles, no owners and no classes.
class Tables {
public:
    Tables(TagWriter& tags, const Skeleton& skeleton)
        : tags_(tags), skeleton_(skeleton), full_(skeleton.version == DxfVersion::R2000)
    {
    }

    std::uint64_t write()
    {
        beginSection(tags_, "TABLES");
        viewports();
        lineTypes();
        layers();
        styles();
        if (full_)
            others();
        tags_.text(0, "ENDSEC");
        return next_;
    }

private:
    void begin(std::string_view name, std::uint64_t handle, std::size_t count)
    {
        tags_.all({{0, "TABLE"}, {2, name}});
        if (full_) {
            tags_.handle(5, handle);
            tags_.all({{330, "0"}, {100, "AcDbSymbolTable"}});
        }
        tags_.whole(70, std::int64_t(count));
        table_ = handle;
    }

    void end() { tags_.text(0, "ENDTAB"); }

    void entry(std::string_view type, std::uint64_t handle, std::string_view className,
               std::string_view name, int codeOfHandle = 5)
    {
        tags_.text(0, type);
        if (full_) {
            tags_.handle(codeOfHandle, handle);
            tags_.handle(330, table_);
            tags_.all({{100, "AcDbSymbolTableRecord"}, {100, className}});
        }
        tags_.text(2, name);
    }

    // A program that opens the file shows all of the drawing.
    void viewports()
    {
        const auto& [min, max] = skeleton_.extents;
        const Point middle = min + (max - min) * 0.5, size = max - min;
        begin("VPORT", 8, 1);
        entry("VPORT", 0x29, "AcDbViewportTableRecord", "*ACTIVE");
        tags_.all({{70, "0"}, {10, "0"}, {20, "0"}, {11, "1"}, {21, "1"}});
        tags_.flatPoint(12, middle);
        tags_.all({{13, "0"}, {23, "0"}, {14, "10"}, {24, "10"}, {15, "10"}, {25, "10"}});
        tags_.all({{16, "0"}, {26, "0"}, {36, "1"}, {17, "0"}, {27, "0"}, {37, "0"}});
        tags_.number(40, std::max({size.y * 1.1, size.x * 0.7, 1e-6})); // the height of the view
        tags_.all({{41, "1.6"}, {42, "50"}, {43, "0"}, {44, "0"}, {50, "0"}, {51, "0"}});
        tags_.all({{71, "0"}, {72, "1000"}, {73, "1"}, {74, "3"}, {75, "0"}, {76, "0"}, {77, "0"}});
        tags_.text(78, "0");
        end();
    }

    void lineTypes()
    {
        const auto type = [&](std::uint64_t handle, std::string_view name, std::string_view what) {
            entry("LTYPE", handle, "AcDbLinetypeTableRecord", name);
            tags_.all({{70, "0"}, {3, what}, {72, "65"}});
        };
        begin("LTYPE", 5, skeleton_.lineTypes.size() + (full_ ? 3 : 1));
        if (full_)
            for (const auto& [handle, name] :
                 {std::pair(0x14, "ByBlock"), std::pair(0x15, "ByLayer")}) {
                type(std::uint64_t(handle), name, "");
                tags_.all({{73, "0"}, {40, "0"}});
            }
        type(0x16, full_ ? "Continuous" : "CONTINUOUS", "Solid line");
        tags_.all({{73, "0"}, {40, "0"}});
        for (const auto& [name, pattern] : skeleton_.lineTypes) {
            type(next_++, name, "");
            writePattern(pattern);
        }
        end();
    }

    // Dashes are positive, gaps negative.
    void writePattern(const std::vector<double>& pattern)
    {
        double length = 0;
        for (const double part : pattern)
            length += part;
        tags_.whole(73, std::int64_t(pattern.size()));
        tags_.number(40, length);
        for (std::size_t i = 0; i < pattern.size(); ++i) {
            tags_.number(49, i % 2 == 0 ? pattern[i] : -pattern[i]);
            if (full_)
                tags_.text(74, "0");
        }
    }

    void layers()
    {
        begin("LAYER", 2, skeleton_.layers.size());
        for (const LayerEntry& layer : skeleton_.layers) {
            entry("LAYER", layer.name == "0" ? 0x10 : next_++, "AcDbLayerTableRecord", layer.name);
            tags_.text(70, layer.locked ? "4" : "0");
            writeLook(tags_, layer.look, full_ ? Looks::Full : Looks::IndexOnly, layer.on);
            tags_.text(6, full_ ? "Continuous" : "CONTINUOUS");
            if (full_)
                tags_.text(390, "F");
        }
        end();
    }

    void styles()
    {
        begin("STYLE", 3, 1);
        entry("STYLE", 0x11, "AcDbTextStyleTableRecord", full_ ? "Standard" : "STANDARD");
        tags_.all({{70, "0"}, {40, "0"}, {41, "1"}, {50, "0"}, {71, "0"}, {42, "1"}});
        tags_.all({{3, "txt"}, {4, ""}});
        end();
    }

    void others()
    {
        begin("VIEW", 6, 0);
        end();
        begin("UCS", 7, 0);
        end();
        begin("APPID", 9, 1);
        entry("APPID", 0x12, "AcDbRegAppTableRecord", "ACAD");
        tags_.text(70, "0");
        end();
        begin("DIMSTYLE", 0xa, 1);
        tags_.all({{100, "AcDbDimStyleTable"}, {71, "0"}});
        entry("DIMSTYLE", 0x27, "AcDbDimStyleTableRecord", "Standard", 105);
        tags_.all({{70, "0"}, {340, "11"}});
        end();
        begin("BLOCK_RECORD", 1, 2);
        entry("BLOCK_RECORD", modelSpace, "AcDbBlockTableRecord", "*Model_Space");
        tags_.text(340, "22");
        entry("BLOCK_RECORD", 0x1b, "AcDbBlockTableRecord", "*Paper_Space");
        tags_.text(340, "1E");
        end();
    }

    TagWriter& tags_;
    const Skeleton& skeleton_;
    const bool full_;
    std::uint64_t table_ = 0, next_ = firstHandle;
};

void writeHeader(TagWriter& tags, const Skeleton& skeleton)
{
    const auto& [min, max] = skeleton.extents;
    const bool full = skeleton.version == DxfVersion::R2000;
    beginSection(tags, "HEADER");
    tags.all({{9, "$ACADVER"}, {1, full ? "AC1015" : "AC1009"}});
    if (full)
        tags.all({{9, "$DWGCODEPAGE"}, {3, "ANSI_1252"}});
    tags.all({{9, "$INSBASE"}, {10, "0"}, {20, "0"}, {30, "0"}});
    tags.text(9, "$EXTMIN");
    tags.point(10, min);
    tags.text(9, "$EXTMAX");
    tags.point(10, max);
    tags.text(9, "$LIMMIN");
    tags.flatPoint(10, min);
    tags.text(9, "$LIMMAX");
    tags.flatPoint(10, max);
    tags.all({{9, "$LTSCALE"}, {40, "1"}, {9, "$CLAYER"}, {8, "0"}});
    // R12 has no units, but many programs look for them in any file.
    tags.text(9, "$INSUNITS");
    tags.whole(70, skeleton.unit);
    if (full) {
        const bool isEnglish = skeleton.unit == 1 || skeleton.unit == 2;
        tags.all({{9, "$MEASUREMENT"}, {70, isEnglish ? "0" : "1"}});
        tags.text(9, "$HANDSEED");
        tags.handle(5, skeleton.freeHandle);
    }
    tags.text(0, "ENDSEC");
}

void writeClasses(TagWriter& tags)
{
    using Class = std::pair<std::string_view, std::string_view>;
    beginSection(tags, "CLASSES");
    for (const auto& [type, name] :
         {Class{"ACDBDICTIONARYWDFLT", "AcDbDictionaryWithDefault"},
          Class{"ACDBPLACEHOLDER", "AcDbPlaceHolder"}, Class{"LAYOUT", "AcDbLayout"}}) {
        tags.all({{0, "CLASS"}, {1, type}, {2, name}, {3, "ObjectDBX Classes"}});
        tags.all({{90, "0"}, {280, "0"}, {281, "0"}});
    }
    tags.text(0, "ENDSEC");
}

void writeBlock(TagWriter& tags, std::string_view name, std::uint64_t owner, bool isPaper)
{
    const auto entity = [&](std::string_view type, std::uint64_t handle) {
        tags.text(0, type);
        tags.handle(5, handle);
        tags.handle(330, owner);
        tags.text(100, "AcDbEntity");
        if (isPaper)
            tags.text(67, "1");
        tags.text(8, "0");
    };
    entity("BLOCK", owner + 1);
    tags.all({{100, "AcDbBlockBegin"}, {2, name}, {70, "0"}, {10, "0"}, {20, "0"}, {30, "0"}});
    tags.all({{3, name}, {1, ""}});
    entity("ENDBLK", owner + 2);
    tags.text(100, "AcDbBlockEnd");
}

void writeDictionary(TagWriter& tags, std::string_view handle, std::string_view owner,
                     std::initializer_list<std::pair<std::string_view, std::string_view>> entries,
                     std::string_view type = "DICTIONARY")
{
    tags.all({{0, type}, {5, handle}, {330, owner}, {100, "AcDbDictionary"}, {281, "1"}});
    for (const auto& [name, value] : entries)
        tags.all({{3, name}, {350, value}});
}

void writeLayout(TagWriter& tags, std::string_view handle, std::string_view name, bool isPaper,
                 std::string_view blockRecord)
{
    tags.all({{0, "LAYOUT"}, {5, handle}, {330, "1A"}, {100, "AcDbPlotSettings"}});
    tags.all({{1, ""}, {2, "none_device"}, {4, ""}, {6, ""}});
    for (const int margin : {40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 140, 141})
        tags.text(margin, "0");
    tags.all({{142, "1"}, {143, "1"}, {70, isPaper ? "688" : "1712"}, {72, "0"}, {73, "0"}});
    tags.all({{74, "5"}, {7, ""}, {75, "16"}, {147, "1"}, {148, "0"}, {149, "0"}});
    tags.all({{100, "AcDbLayout"}, {1, name}, {70, "1"}, {71, isPaper ? "1" : "0"}});
    tags.all({{10, "0"}, {20, "0"}, {11, "420"}, {21, "297"}, {12, "0"}, {22, "0"}, {32, "0"}});
    tags.all({{14, "0"}, {24, "0"}, {34, "0"}, {15, "0"}, {25, "0"}, {35, "0"}, {146, "0"}});
    tags.all({{13, "0"}, {23, "0"}, {33, "0"}, {16, "1"}, {26, "0"}, {36, "0"}});
    tags.all({{17, "0"}, {27, "1"}, {37, "0"}, {76, "0"}, {330, blockRecord}});
}

void writeObjects(TagWriter& tags)
{
    beginSection(tags, "OBJECTS");
    writeDictionary(tags, "C", "0",
                    {{"ACAD_GROUP", "D"},
                     {"ACAD_LAYOUT", "1A"},
                     {"ACAD_MLINESTYLE", "17"},
                     {"ACAD_PLOTSTYLENAME", "E"}});
    writeDictionary(tags, "D", "C", {});
    writeDictionary(tags, "1A", "C", {{"Layout1", "1E"}, {"Model", "22"}});
    writeDictionary(tags, "17", "C", {{"Standard", "18"}});
    tags.all({{0, "MLINESTYLE"}, {5, "18"}, {330, "17"}, {100, "AcDbMlineStyle"}});
    tags.all({{2, "Standard"}, {70, "0"}, {3, ""}, {62, "256"}, {51, "90"}, {52, "90"}});
    tags.all({{71, "2"}, {49, "0.5"}, {62, "256"}, {6, "BYLAYER"}});
    tags.all({{49, "-0.5"}, {62, "256"}, {6, "BYLAYER"}});
    writeDictionary(tags, "E", "C", {{"Normal", "F"}}, "ACDBDICTIONARYWDFLT");
    tags.all({{100, "AcDbDictionaryWithDefault"}, {340, "F"}});
    tags.all({{0, "ACDBPLACEHOLDER"}, {5, "F"}, {330, "E"}});
    writeLayout(tags, "22", "Model", false, "1F");
    writeLayout(tags, "1E", "Layout1", true, "1B");
    tags.text(0, "ENDSEC");
}

} // namespace

std::uint64_t writeBeforeEntities(TagWriter& tags, const Skeleton& skeleton)
{
    const bool full = skeleton.version == DxfVersion::R2000;
    writeHeader(tags, skeleton);
    if (full)
        writeClasses(tags);
    const std::uint64_t next = Tables(tags, skeleton).write();
    beginSection(tags, "BLOCKS");
    if (full) {
        writeBlock(tags, "*Model_Space", modelSpace, false);
        writeBlock(tags, "*Paper_Space", 0x1b, true);
    }
    tags.text(0, "ENDSEC");
    beginSection(tags, "ENTITIES");
    return next;
}

void writeAfterEntities(TagWriter& tags, const Skeleton& skeleton)
{
    tags.text(0, "ENDSEC");
    if (skeleton.version == DxfVersion::R2000)
        writeObjects(tags);
    tags.text(0, "EOF");
}

} // namespace app::dxf::writing
