// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <vector>

// What formulas_test does not ask of a row; it fails for a line here that is not needed any more.

namespace app::formulas {

/// A code that is longer than others may be, and why.
struct Long {
    std::string_view key;
    int lines;
    std::string_view reason;
};
inline const std::vector<Long> longer{
    {"nicholl-lee-nicholl", 69, "it is ten procedures, each with a line for each region"},
};

/// Formulas that none of the lines evaluates, and why.
struct NotEvaluated {
    std::string_view key;
    clipping::Form form;
    std::string_view line; ///< its text, without indentation
    std::string_view reason;
};

/// One row each: {"key", clipping::Form::Corrected, "line", "reason"}.
inline const std::vector<NotEvaluated> notEvaluated{};

/// Alterations that none of the lines can tell from the code, and why.
struct NotObservable {
    std::string_view key;
    clipping::Form form;
    std::string_view line, change; ///< as Altered has them
    std::string_view reason;
};

/// A line whose comparisons a run needs fewer of than it shows, and why. No row of the paper has
/// one.
struct ComparesLess {
    std::string_view key;
    clipping::Form form;
    std::string_view line; ///< its text, without indentation
    std::string_view reason;
};

inline constexpr std::string_view threeWays =
    "one comparison of the two numbers says whether they are less, equal or greater";

inline constexpr std::string_view oneSide =
    "it is held at one edge only: by the sign of e, rounding cannot put it beyond the other";

inline const std::vector<ComparesLess> comparesLess{
    {"slater-barsky", clipping::Form::Corrected, "x[a] = xmin,  y[a] = held(yOut + e/dx)", oneSide},
    {"slater-barsky", clipping::Form::Corrected, "x[b] = xmax,  y[b] = held(yOut + e/dx)", oneSide},
    {"slater-barsky", clipping::Form::Corrected, "if (e == 0 ? col == 0 : up ? e < 0 : e > 0)",
     threeWays},
    {"sobkow-pospisil-yang", clipping::Form::Corrected,
     "notL(): if x[i] < xmin or x[i] == xmin and way[i] < xmin-xi: reject", threeWays},
    {"sobkow-pospisil-yang", clipping::Form::Corrected,
     "notR(): if x[i] > xmax or x[i] == xmax and way[i] > xmax-xi: reject", threeWays},
    {"sobkow-pospisil-yang", clipping::Form::Corrected,
     "notB(): if y[i] < ymin or y[i] == ymin and way[i] < ymin-yi: reject", threeWays},
    {"sobkow-pospisil-yang", clipping::Form::Corrected,
     "notT(): if y[i] > ymax or y[i] == ymax and way[i] > ymax-yi: reject", threeWays},
    {"sobkow-pospisil-yang", clipping::Form::Corrected,
     "ifL(): if x[i] < xmin or x[i] == xmin and way[i] < xmin-xi: L()", threeWays},
    {"sobkow-pospisil-yang", clipping::Form::Corrected,
     "ifR(): if x[i] > xmax or x[i] == xmax and way[i] > xmax-xi: R()", threeWays},
    {"sobkow-pospisil-yang", clipping::Form::Corrected,
     "ifB(): if y[i] < ymin or y[i] == ymin and way[i] < ymin-yi: B()", threeWays},
    {"sobkow-pospisil-yang", clipping::Form::Corrected,
     "ifT(): if y[i] > ymax or y[i] == ymax and way[i] > ymax-yi: T()", threeWays},
};

inline constexpr std::string_view onTheEdge =
    "on none of the lines does rounding put an end on this edge whose way leads beyond it";

/// One row each: {"key", clipping::Form::Corrected, "line", "change", "reason"}.
inline const std::vector<NotObservable> notObservable{
    {"cyrus-beck", clipping::Form::Published, "if D > 0", ">= for > at column 6",
     "D is not 0 here"},
    {"cyrus-beck", clipping::Form::Corrected, "if D > 0", ">= for > at column 6",
     "D is not 0 here"},
    {"kodituwakku-wijeweera-chamikara", clipping::Form::Corrected,
     "if y1 < ymin or y1 > ymax: reject", "y2 for y1 at column 4", "the line is horizontal"},
    {"kodituwakku-wijeweera-chamikara", clipping::Form::Corrected,
     "if y1 < ymin or y1 > ymax: reject", "y2 for y1 at column 17", "the line is horizontal"},
    {"kodituwakku-wijeweera-chamikara", clipping::Form::Corrected,
     "if y1 < ymin or y1 > ymax or x1 < xmin or x1 > xmax: reject", "y2 for y1 at column 4",
     "the line is a point"},
    {"kodituwakku-wijeweera-chamikara", clipping::Form::Corrected,
     "if y1 < ymin or y1 > ymax or x1 < xmin or x1 > xmax: reject", "y2 for y1 at column 17",
     "the line is a point"},
    {"kodituwakku-wijeweera-chamikara", clipping::Form::Corrected,
     "if y1 < ymin or y1 > ymax or x1 < xmin or x1 > xmax: reject", "x2 for x1 at column 30",
     "the line is a point"},
    {"kodituwakku-wijeweera-chamikara", clipping::Form::Corrected,
     "if y1 < ymin or y1 > ymax or x1 < xmin or x1 > xmax: reject", "x2 for x1 at column 43",
     "the line is a point"},
    {"kodituwakku-wijeweera-chamikara", clipping::Form::Corrected,
     "if x1 < xmin or x1 > xmax: reject", "x2 for x1 at column 4", "the line is vertical"},
    {"kodituwakku-wijeweera-chamikara", clipping::Form::Corrected,
     "if x1 < xmin or x1 > xmax: reject", "x2 for x1 at column 17", "the line is vertical"},
    {"slater-barsky", clipping::Form::Corrected, "up = s > 0", ">= for > at column 8",
     "s is not 0 here"},
    {"slater-barsky", clipping::Form::Corrected, "if (e == 0 ? col == 0 : up ? e < 0 : e > 0)",
     "<= for < at column 32", "e is not 0 here"},
    {"slater-barsky", clipping::Form::Corrected, "if (e == 0 ? col == 0 : up ? e < 0 : e > 0)",
     ">= for > at column 40", "e is not 0 here"},
    {"sobkow-pospisil-yang", clipping::Form::Corrected,
     "ifL(): if x[i] < xmin or x[i] == xmin and way[i] < xmin-xi: L()", "+ for - at column 56",
     onTheEdge},
    {"sobkow-pospisil-yang", clipping::Form::Corrected,
     "ifR(): if x[i] > xmax or x[i] == xmax and way[i] > xmax-xi: R()", "+ for - at column 56",
     onTheEdge},
    {"skala", clipping::Form::Corrected, "c = dx > 0 ? 1100 : dx < 0 ? 0011 : dy > 0 ? 1001 : 0110",
     ">= for > at column 40", "a point whose ends are not both inside is rejected by its outcodes"},
};

} // namespace app::formulas
