// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/figures/gnuplot.hpp"

#include "verify/exit_codes.hpp"
#include "verify/figures/tool.hpp"

#include <fmt/format.h>

#include <array>

namespace touchstone::figures {
namespace {

using program::Failure;

/// Ink, then the palette of Okabe and Ito, which readers with any colour vision tell apart; on black and on white.
constexpr std::array palette{"black", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};
/// Circle, square, triangle, inverted triangle, diamond, pentagon: the marker tells the curves apart without colour.
constexpr std::array markers{7, 7, 5, 9, 11, 13, 15};

std::string text(const std::string& s) { return '"' + s + '"'; }

std::string axis_commands(char name, const Axis& a)
{
    std::string c = fmt::format("{} logscale {}\n", a.logarithmic ? "set" : "unset", name);
    c += fmt::format("set {0}label {1}\nset {0}range [{2:.17g}:{3:.17g}]{4}\n", name, text(a.label), a.low, a.high, a.reversed ? " reverse" : "");
    if (a.logarithmic) {
        const double factor = a.step > 0 ? a.step : 10;
        c += fmt::format("set format {0} '10^{{%T}}'\nset {0}tics {1:g} nomirror\nunset m{0}tics\n", name, factor);
    }
    else {
        c += fmt::format("set format {0} '%g'\n", name);
        c += a.step > 0 ? fmt::format("set {0}tics {1:g} nomirror\nunset m{0}tics\n", name, a.step) : fmt::format("set {0}tics autofreq nomirror\nunset m{0}tics\n", name);
    }
    return c;
}

std::string drawn(const Curve& c)
{
    const char* colour = palette[static_cast<std::size_t>(c.colour) % palette.size()];
    const int marker = markers[static_cast<std::size_t>(c.colour) % markers.size()];
    switch (c.style) {
    case Style::line: return fmt::format("with lines lw 1.6 lc rgb '{}'", colour);
    case Style::dashed: return fmt::format("with lines dashtype (9,5) lw 1.3 lc rgb '{}'", colour);
    case Style::dotted: return fmt::format("with lines dashtype (2,4) lw 1.6 lc rgb '{}'", colour);
    case Style::points: return fmt::format("with points pointtype {} pointsize 0.45 lc rgb '{}'", marker, colour);
    case Style::marked_line: return fmt::format("with linespoints pointtype {} pointsize 0.45 lw 1.2 lc rgb '{}'", marker, colour);
    case Style::steps: return fmt::format("with lines lw 1 lc rgb '{}'", colour);
    }
    return "";
}

std::string panel_commands(const Panel& p, std::size_t number)
{
    std::string c = fmt::format("set title {}\n{}{}", text(p.title), axis_commands('x', p.x), axis_commands('y', p.y));
    c += p.key.empty() || p.key == above_all ? "unset key\n" : fmt::format("set key {} samplen 2 spacing 1.1 noopaque\n", p.key);
    c += "unset label\nunset object\n";
    for (const Band& b : p.bands)
        c += fmt::format("set object rectangle from {:.17g}, graph 0 to {:.17g}, graph 1 behind fillstyle solid 0.18 noborder fillcolor rgb '#888888'\n", b.from, b.to);
    for (const Note& n : p.notes) c += fmt::format("set label {} at {:.17g}, {:.17g} {}\n", text(n.text), n.x, n.y, n.centred ? "center" : "left");
    for (std::size_t k = 0; k < p.curves.size(); ++k) {
        c += fmt::format("$d{}_{} << END\n", number, k);
        for (const Point& q : p.curves[k].points) c += q.value == "gap" ? "\n" : fmt::format("{:.17g} {}\n", q.x, q.value);
        c += "END\n";
    }
    c += "plot ";
    for (std::size_t k = 0; k < p.curves.size(); ++k)
        c += fmt::format("{}$d{}_{} using 1:2 {} {}", k > 0 ? ", \\\n     " : "", number, k, drawn(p.curves[k]),
                         p.curves[k].legend.empty() ? "notitle" : "title " + text(p.curves[k].legend));
    return c + "\n";
}

/// Pixels of the drawing and of the strip above the panels that holds a legend for all.
struct Size {
    double width, height, legend;
    int columns, rows;
};

Size size_of(const Figure& f, Layout layout)
{
    constexpr double legend_line = 24;
    const int panels = static_cast<int>(f.panels.size());
    const int columns = layout == Layout::wide ? f.columns : 1;
    const int rows = (panels + columns - 1) / columns;
    int entries = 0;
    for (const Curve& c : f.panels.front().curves) entries += c.legend.empty() ? 0 : 1;
    const double legend = f.panels.front().key != above_all ? 0 : layout == Layout::wide ? legend_line * (entries > 4 ? 2 : 1) : legend_line * ((entries + 1) / 2);
    return {layout == Layout::wide ? 860.0 : 400.0, f.panel_height * rows + legend, legend, columns, rows};
}

/// The legend as a panel of its own: nothing is drawn in it but the samples, so that it is as wide as the page.
std::string legend_commands(const Figure& f, const Size& s, Layout layout)
{
    std::string c = fmt::format("set origin 0,{:.6f}\nset size 1,{:.6f}\n", 1 - s.legend / s.height, s.legend / s.height);
    c += "unset border\nunset tics\nunset title\nunset xlabel\nunset ylabel\nunset grid\nunset logscale\nset lmargin 0\nset rmargin 0\nset tmargin 0\nset bmargin 0\n";
    c += fmt::format("set xrange [0:1]\nset yrange [0:1]\nset key at graph 0.5, graph 0.5 center center horizontal maxcols {} samplen 2 width 0.5\nplot ", layout == Layout::wide ? 8 : 2);
    const char* comma = "";
    for (const Curve& curve : f.panels.front().curves) {
        if (curve.legend.empty()) continue;
        c += fmt::format("{}2 {} title {}", comma, drawn(curve), text(curve.legend));
        comma = ", ";
    }
    return c + "\nunset tmargin\nunset bmargin\n";
}

std::string run_gnuplot(const std::string& commands)
{
    const auto answer = run_tool({"gnuplot", "-"}, commands + "unset multiplot\n");
    if (!answer) throw Failure(program::protocol_error, "gnuplot could not be run; it draws the figures (Debian package gnuplot-nox)");
    if (!answer->succeeded || answer->output.empty()) throw Failure(program::protocol_error, fmt::format("gnuplot refused a figure: {}", answer->complaint.substr(0, 400)));
    return answer->output;
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
        for (std::size_t at = 0; (at = words.find_first_of("&<>", at)) != std::string::npos; ++at) words.replace(at, 1, words[at] == '&' ? "&amp;" : words[at] == '<' ? "&lt;" : "&gt;");
        return words;
    };
    if (const auto at = drawing.find("<svg"); at != std::string::npos) drawing.erase(0, at); // UTF-8 needs no declaration
    cut("<desc>", "</desc>");
    cut("<title>", "</title>");
    const std::string style = fmt::format("<title>{}</title>\n<desc>{} Drawn from `touchstone paper {} --csv`.</desc>\n"
                                          "<style>@media (prefers-color-scheme: dark) {{ [fill=\"black\"], [fill='black'] {{ fill: #e6e6e6 }} "
                                          "[stroke=\"black\"], [stroke='black'] {{ stroke: #e6e6e6 }} [color=\"black\"] {{ color: #e6e6e6 }} "
                                          "[stroke='rgb(  0,   0,   0)'], [stroke=\"rgb(  0,   0,   0)\"] {{ stroke: #e6e6e6 }} [color='rgb(  0,   0,   0)'] {{ color: #e6e6e6 }} "
                                          "[stroke='rgb(  0, 114, 178)'], [stroke=\"rgb(  0, 114, 178)\"] {{ stroke: #4aa8e0 }} [color='rgb(  0, 114, 178)'], [color=\"rgb(  0, 114, 178)\"] {{ color: #4aa8e0 }} }}</style>\n",
                                          xml(f.title), xml(f.alternative), f.id);
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
    if (s.legend > 0) c += legend_commands(f, s, layout);
    c += "set border 3 lw 0.8\nset tics scale 0.6\nset grid lc rgb '#999999' lw 0.25 dashtype solid\nset lmargin 9.5\nset rmargin 2.5\n";
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
    const std::string drawing = run_gnuplot(fmt::format("set terminal svg size {:.0f},{:.0f} fixed enhanced font 'sans-serif,13'\n{}", s.width, s.height, script(f, layout)));
    return dressed(drawing, f);
}

std::string pdf(const Figure& f)
{
    const Size s = size_of(f, Layout::wide);
    constexpr double per_inch = 110; // a page's width is 7.8 inches of it
    return run_gnuplot(fmt::format("set terminal pdfcairo size {:.2f},{:.2f} enhanced font 'sans,10'\n{}", s.width / per_inch, s.height / per_inch, script(f, Layout::wide)));
}

} // namespace touchstone::figures
