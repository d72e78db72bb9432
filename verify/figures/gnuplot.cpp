// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/figures/gnuplot.hpp"

#include "verify/exit_codes.hpp"
#include "verify/figures/tool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace touchstone::figures {
namespace {

using program::Failure;

/// Ink, then the palette of Okabe and Ito, which readers with any colour vision tell apart, and grey; on black and on white.
constexpr std::array palette{"black", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#808080"};
static_assert(palette.size() == grey + 1);
/// Circle, square, triangle, inverted triangle, diamond, pentagon: the marker tells the curves apart without colour.
constexpr std::array markers{7, 7, 5, 9, 11, 13, 15, 7};

std::string text(const std::string& s) { return '"' + s + '"'; }

std::string axis_commands(char name, const Axis& a)
{
    std::string c = fmt::format("{} logscale {}\n", a.logarithmic ? "set" : "unset", name);
    c += fmt::format("set {0}label {1}\nset {0}range [{2:.17g}:{3:.17g}]{4}\n", name, text(a.label), a.low, a.high,
                     a.reversed ? " reverse" : "");
    if (a.logarithmic) {
        const double factor = a.step > 0 ? a.step : 10;
        c += fmt::format("set format {0} '10^{{%T}}'\nset {0}tics {1:g} nomirror\nunset m{0}tics\n", name, factor);
    }
    else {
        c += fmt::format("set format {0} '%g'\n", name);
        c += a.step > 0 ? fmt::format("set {0}tics {1:g} nomirror\nunset m{0}tics\n", name, a.step)
                        : fmt::format("set {0}tics autofreq nomirror\nunset m{0}tics\n", name);
    }
    return c;
}

std::string drawn(const Curve& c)
{
    const char* colour = palette[static_cast<std::size_t>(c.colour) % palette.size()];
    const int marker = markers[static_cast<std::size_t>(c.colour) % markers.size()];
    switch (c.style) {
    case Style::cells: return fmt::format("with boxxyerror fillstyle solid 0.45 noborder lc rgb '{}'", colour);
    case Style::line: return fmt::format("with lines lw 1.6 lc rgb '{}'", colour);
    case Style::dashed: return fmt::format("with lines dashtype (9,5) lw 1.3 lc rgb '{}'", colour);
    case Style::dotted: return fmt::format("with lines dashtype (2,4) lw 1.6 lc rgb '{}'", colour);
    case Style::points: return fmt::format("with points pointtype {} pointsize 0.45 lc rgb '{}'", marker, colour);
    case Style::marked_line: return fmt::format("with linespoints pointtype {} pointsize 0.45 lw 1.2 lc rgb '{}'", marker, colour);
    case Style::steps: return fmt::format("with lines lw 1 lc rgb '{}'", colour);
    }
    return "";
}

/// Cells side by side in a row as one rectangle: x y and its edges.
std::string rectangles(const Curve& c)
{
    std::string lines;
    const auto& points = c.points;
    for (std::size_t k = 0; k < points.size();) {
        std::size_t last = k;
        while (last + 1 < points.size() && points[last + 1].x < points[last].x * c.cells.width * c.cells.width * 1.001) ++last;
        const double left = points[k].x / c.cells.width, right = points[last].x * c.cells.width;
        lines += fmt::format("{0:.6g} {1:.6g} {0:.6g} {2:.6g} {3:.6g} {4:.6g}\n", left, c.cells.y, right, c.cells.y / c.cells.height,
                             c.cells.y * c.cells.height);
        k = last + 1;
    }
    return lines;
}

std::string data_of(const Curve& c)
{
    if (c.style == Style::cells) return rectangles(c);
    std::string lines;
    for (const Point& q : c.points) lines += q.value == "gap" ? "\n" : fmt::format("{:.17g} {}\n", q.x, q.value);
    return lines;
}

std::string panel_commands(const Panel& p, std::size_t number)
{
    std::string c = fmt::format("set title {}\n{}{}", text(p.title), axis_commands('x', p.x), axis_commands('y', p.y));
    c += p.key.empty() || p.key == above_all ? "unset key\n"
                                             : fmt::format("set key {} Left reverse samplen 2 spacing 1.1 noopaque\n", p.key);
    c += "unset label\nunset object\n";
    for (const Band& b : p.bands)
        c += fmt::format("set object rectangle from {:.17g}, graph 0 to {:.17g}, graph 1 behind fillstyle solid 0.18 noborder fillcolor "
                         "rgb '#888888'\n", b.from, b.to);
    for (const Note& n : p.notes)
        c += fmt::format("set label {} at {:.17g}, {:.17g} {} front\n", text(n.text), n.x, n.y, n.centred ? "center" : "left");
    std::string plots;
    for (std::size_t k = 0; k < p.curves.size(); ++k) {
        const Curve& curve = p.curves[k];
        if (curve.points.empty()) continue; // for the legend alone
        c += fmt::format("$d{}_{} << END\n{}END\n", number, k, data_of(curve));
        plots += fmt::format("{}$d{}_{} using {} {} {}", plots.empty() ? "plot " : ", \\\n     ", number, k,
                             curve.style == Style::cells ? "1:2:3:4:5:6" : "1:2", drawn(curve),
                             curve.legend.empty() ? "notitle" : "title " + text(curve.legend));
    }
    return c + plots + "\n";
}

/// Pixels of the drawing and of the strip above the panels that holds a legend for all.
struct Size {
    double width, height, legend;
    int columns, rows, legend_columns;
};

/// About how wide a legend's text is: without the markup of enhanced text.
double width_of(const std::string& legend)
{
    constexpr double of_letter = 9, of_sample = 70; // as gnuplot reckons
    std::size_t letters = 0;
    for (std::size_t at = 0; at < legend.size(); ++at) {
        if (legend.compare(at, 9, "{/:Italic") == 0) at += 9;
        else if (std::strchr("{}@_^", legend[at]) == nullptr && (static_cast<unsigned char>(legend[at]) & 0xc0U) != 0x80U) ++letters;
    }
    return of_sample + of_letter * static_cast<double>(letters);
}

Size size_of(const Figure& f, Layout layout)
{
    constexpr double legend_line = 24, wide = 860, narrow = 400, border = 20;
    const int panels = static_cast<int>(f.panels.size());
    const int columns = layout == Layout::wide ? f.columns : 1;
    const int rows = (panels + columns - 1) / columns;
    const double width = layout == Layout::wide ? wide : narrow;
    int entries = 0;
    double widest = 1;
    for (const Curve& c : f.panels.front().curves) {
        if (c.legend.empty()) continue;
        ++entries;
        widest = std::max(widest, width_of(c.legend));
    }
    const int across = std::clamp(static_cast<int>((width - border) / widest), 1, std::max(1, entries));
    const double legend = f.panels.front().key == above_all ? legend_line * ((entries + across - 1) / across) : 0;
    return {width, f.panel_height * rows + legend, legend, columns, rows, across};
}

/// The legend as a panel of its own: nothing is drawn in it but the samples, so that it is as wide as the page.
std::string legend_commands(const Figure& f, const Size& s)
{
    std::string c = fmt::format("set origin 0,{:.6f}\nset size 1,{:.6f}\n", 1 - s.legend / s.height, s.legend / s.height);
    c += "unset border\nunset tics\nunset title\nunset xlabel\nunset ylabel\nunset grid\nunset logscale\nset lmargin 0\nset rmargin "
         "0\nset tmargin 0\nset bmargin 0\n";
    c += fmt::format("set xrange [0:1]\nset yrange [0:1]\nset key at graph 0.5, graph 0.5 center center horizontal Left reverse maxcols "
                     "{} samplen 2 width 0.5\nplot ", s.legend_columns);
    const char* comma = "";
    for (const Curve& curve : f.panels.front().curves) {
        if (curve.legend.empty()) continue;
        c += fmt::format("{}{} {} title {}", comma, curve.style == Style::cells ? "'+' using (2):(2):(2):(2):(2):(2)" : "2", drawn(curve),
                         text(curve.legend));
        comma = ", ";
    }
    return c + "\n";
}

std::string run_gnuplot(const std::string& commands)
{
    const auto answer = run_tool({"gnuplot", "-"}, commands + "unset multiplot\n");
    if (!answer) throw Failure(program::protocol_error, "gnuplot could not be run; it draws the figures (Debian package gnuplot-nox)");
    if (!answer->succeeded || answer->output.empty())
        throw Failure(program::protocol_error, fmt::format("gnuplot refused a figure: {}", answer->complaint.substr(0, 400)));
    return answer->output;
}

/// The paper, white or dark whatever page it lies on, and what becomes light on dark: ink and the two blues. gnuplot writes a colour as a
/// name, or as its three numbers.
std::string dark_mode()
{
    constexpr std::array<std::pair<const char*, const char*>, 4> changes{
        {{"black", "#e6e6e6"}, {"rgb(  0,   0,   0)", "#e6e6e6"}, {"rgb(  0, 114, 178)", "#4aa8e0"}, {"rgb( 86, 180, 233)", "#b8e4ff"}}};
    std::string rules;
    for (const auto& [from, to] : changes)
        for (const char* what : {"fill", "stroke", "color"}) rules += fmt::format(" [{0}='{1}'] {{ {0}: {2} }}", what, from, to);
    return fmt::format(".paper {{ fill: #fff }} @media (prefers-color-scheme: dark) {{ .paper {{ fill: #141618 }}{} }}", rules);
}

/// Titles that a reader hears, colours that follow the page, no second name of a namespace that nothing uses.
std::string dressed(std::string drawing, const Figure& f)
{
    const auto replace = [&drawing](const std::string& from, const std::string& to) {
        if (const auto at = drawing.find(from); at != std::string::npos) drawing.replace(at, from.size(), to);
    };
    const auto cut = [&drawing](const std::string& from, const std::string& to) {
        const auto a = drawing.find(from);
        if (a == std::string::npos) return;
        const auto b = drawing.find(to, a);
        if (b != std::string::npos) drawing.erase(a, b + to.size() - a);
    };
    const auto xml = [](std::string words) {
        for (std::size_t at = 0; (at = words.find_first_of("&<>", at)) != std::string::npos; ++at)
            words.replace(at, 1, words[at] == '&' ? "&amp;" : words[at] == '<' ? "&lt;" : "&gt;");
        return words;
    };
    if (const auto at = drawing.find("<svg"); at != std::string::npos) drawing.erase(0, at); // UTF-8 needs no declaration
    cut("<desc>", "</desc>");
    cut("<title>", "</title>");
    const std::string style = fmt::format("<title>{}</title>\n<desc>{} Drawn from `touchstone paper {} "
                                          "--csv`.</desc>\n<style>{}</style>\n<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n",
                                          xml(f.title), xml(f.alternative), f.id, dark_mode());
    drawing.erase(drawing.find_last_not_of('\n') + 1);
    drawing += '\n';
    replace("<g id=\"gnuplot_canvas\">", style + "<g id=\"gnuplot_canvas\">");
    return drawing;
}

} // namespace

std::string script(const Figure& f, Layout layout)
{
    const Size s = size_of(f, layout);
    std::string c = "set encoding utf8\nset multiplot\n";
    if (s.legend > 0) c += legend_commands(f, s);
    c += "set border 3 lw 0.8\nset tics scale 0.6\nset grid lc rgb '#999999' lw 0.25 dashtype solid\nset lmargin 9.5\nset rmargin "
         "2.5\nset tmargin 2.6\nset bmargin 4\n"; // the same for all panels
    const double width = 1.0 / s.columns, height = (s.height - s.legend) / s.height / s.rows;
    for (std::size_t k = 0; k < f.panels.size(); ++k) {
        const int row = static_cast<int>(k) / s.columns, column = static_cast<int>(k) % s.columns;
        c += fmt::format("set origin {:.6f},{:.6f}\nset size {:.6f},{:.6f}\n", column * width, (s.rows - 1 - row) * height, width, height);
        c += panel_commands(f.panels[k], k);
    }
    return c;
}

std::string svg(const Figure& f, Layout layout)
{
    const Size s = size_of(f, layout);
    const std::string drawing = run_gnuplot(
        fmt::format("set terminal svg size {:.0f},{:.0f} fixed enhanced font 'sans-serif,13'\n{}", s.width, s.height, script(f, layout)));
    return dressed(drawing, f);
}

std::string pdf(const Figure& f)
{
    const Size s = size_of(f, Layout::wide);
    constexpr double per_inch = 110; // a page's width is 7.8 inches of it
    return run_gnuplot(fmt::format("set terminal pdfcairo size {:.2f},{:.2f} enhanced font 'sans,10'\n{}", s.width / per_inch,
                                   s.height / per_inch, script(f, Layout::wide)));
}

} // namespace touchstone::figures
