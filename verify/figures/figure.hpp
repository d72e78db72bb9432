// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A figure as data: curves of certified points in panels, from which its CSV, its SVG and its PDF are made.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <string>
#include <vector>

namespace touchstone::figures {

/// A point of a curve. `value` is what is drawn at `x`; `error` bounds its distance from the true value where
/// `status` is "certified" or "exact".
struct Point {
    double x = 0;
    std::string value;  ///< decimal; every digit proven where the status says so
    std::string error;
    std::string status; ///< exact, certified, estimated, measured; claimed: what the table of methods says it can do
};

/// y, proven to `digits` digits, at x. A ball too wide for them is given the digits it decides.
Point certified(double x, const Ball& y, long digits = 8);

enum class Style { line, dashed, dotted, points, marked_line, steps, cells };

/// The last colour of the palette: for lines that are only there to compare with.
inline constexpr int grey = 7;

/// A row of a map on logarithmic axes: `value` belongs to the cell from x / width to x * width, y / height to y * height.
struct Cells {
    double y = 1, width = 1, height = 1;
};

/// Which marker and colour: the same number is the same in every panel, so that one legend serves all.
struct Curve {
    std::string name;        ///< plain text, as the CSV has it
    std::string legend;      ///< gnuplot's enhanced text; empty: not in the legend
    Style style = Style::line;
    int colour = 0;          ///< index into the palette; 0 is ink
    std::vector<Point> points; ///< none: the curve stands in the legend only
    Cells cells = {};          ///< of Style::cells
};

struct Axis {
    std::string label;       ///< gnuplot's enhanced text, with the unit
    double low = 0, high = 1;
    bool logarithmic = false;
    double step = 0;         ///< between ticks (a factor where logarithmic); 0: gnuplot's own round ticks
    bool reversed = false;
};

/// Words beside a curve, at a place on the axes.
struct Note {
    double x = 0, y = 0;
    std::string text;        ///< gnuplot's enhanced text
    bool centred = false;
};

/// A rectangle behind the curves, over the whole height: where something holds.
struct Band {
    double from = 0, to = 0;
};

struct Panel {
    std::string title;
    std::string name;        ///< plain text, as the CSV has it
    Axis x, y;
    std::vector<Curve> curves;
    std::vector<Note> notes = {};
    std::vector<Band> bands = {};
    std::string key;         ///< where gnuplot places the legend ("bottom left"), or above_all; empty: none in this panel
};

/// The first panel's legend stands above all panels and serves them all.
inline constexpr const char* above_all = "above all";

struct Figure {
    std::string id;          ///< "figure3", "hertz-error"
    std::string title;
    std::string caption;     ///< what is drawn, in sentences
    std::string alternative; ///< what a reader who cannot see it is told
    std::vector<Panel> panels;
    int columns = 1;         ///< of panels on a wide page
    double panel_height = 300;
};

/// How a figure can be had.
struct Recipe {
    std::string id;
    std::string title;
    bool of_paper = true;    ///< one of the paper's own
    Figure (*make)() = nullptr;
};

/// All figures: the paper's first.
const std::vector<Recipe>& recipes();
/// \returns the recipe of that id, or nullptr
const Recipe* find_recipe(const std::string& id);

/// panel,curve,x,value,error,status: a line a point.
std::string csv(const Figure&);
/// The weakest status among the points, with how many points have each: "certified (420 points)".
std::string status_line(const Figure&);

// ---- the recipes, a file for each group
Figure figure_1();
Figure figure_2();
Figure figure_3();
Figure figure_4();
Figure figure_5();
Figure hertz_error();
Figure apparent_dimension();
Figure print_errors();
Figure hertzian_share();
Figure area_laws();
Figure edge_error();
Figure certified_digits();

} // namespace touchstone::figures
