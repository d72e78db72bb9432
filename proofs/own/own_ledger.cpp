// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/own/own_ledger.hpp"

#include "proofs/own/own_fields.hpp"
#include "proofs/own/own_symbols.hpp"
#include "proofs/symbols.hpp"
#include "proofs/symbolic/symbolic.hpp"
#include "proofs/symbolic/units.hpp"
#include "touchstone/table/json_text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

namespace touchstone::proofs {

namespace {

using nlohmann::json;

/// The formula, if it parses and all its symbols are declared.
ex formula(const std::string& t, const Place& at)
{
    static constexpr char characters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_.,+-*/^() "; // no lists { }
    ex e;
    if (std::any_of(t.begin(), t.end(), [](char c) { return !std::strchr(characters, c); })) at.fail("does not parse: '" + t + "'");
    try {
        e = read(t);
    } catch (const std::length_error& wrong) {
        at.fail("'" + t + "': " + wrong.what());
    } catch (const std::domain_error&) { // 0^0, log(0)
        at.fail("has no value: '" + t + "'");
    } catch (const std::overflow_error&) { // 1/0
        at.fail("has no value: '" + t + "'");
    } catch (const std::exception&) {
        at.fail("does not parse: '" + t + "'");
    }
    for (const std::string& name : symbols_of(e))
        if (!alphabet().symbols.count(name)) at.fail("symbol '" + name + "' has no dimension; declare it in \"symbols\"");
    return e;
}

/// The same, with no root of a negative number in it. A print may have one, and is refuted.
ex real_formula(const std::string& t, const Place& at)
{
    const ex e = formula(t, at);
    const std::function<bool(const ex&)> is_real = [&](const ex& part) {
        if (GiNaC::is_a<GiNaC::numeric>(part)) return part.info(GiNaC::info_flags::real);
        for (std::size_t i = 0; i < part.nops(); ++i)
            if (!is_real(part.op(i))) return false;
        return true;
    };
    if (!is_real(e)) at.fail("has no real value: '" + t + "'");
    return e;
}

/// A declared symbol, not a formula.
void must_be_symbol(const std::string& name, const Place& at)
{
    if (!alphabet().symbols.count(name)) at.fail("no symbol '" + name + "' is declared");
}

/// A name that formulas have a meaning for, `Pi` or `sin`, cannot be that of a symbol.
void must_be_free(const std::string& name, const Place& at)
{
    bool is_symbol = false;
    try {
        is_symbol = read(name).is_equal(sym(name));
    } catch (const std::exception&) { // a function of nothing
    }
    if (!is_symbol) at.fail("the name is that of a function or a number in formulas; choose another");
}

/// Roots and moduli are simplified by the sign of what is in them, so that no number against it may be put in.
void must_have_the_sign(const OwnLedger& ledger, const std::string& name, const Rational& value, const Place& at)
{
    if (ledger.symbols.at(name).positive && value < 0)
        at.fail("'" + name + "' is positive, " + value.get_str() + " is not; \"sign\": \"real\" says that it need not be");
}

/// "0 < x <= a": formulas between < and >.
void check_condition(const std::string& where, const Place& at)
{
    for (std::size_t i = 0; i < where.size(); ++i)
        if (where[i] == '=' && (i == 0 || (where[i - 1] != '<' && where[i - 1] != '>')))
            at.fail("a condition is written with < or >, not '" + where + "'; \"with\" puts a value in");
    if (where.find_first_of("<>") == std::string::npos) at.fail("no relation in '" + where + "'; write x < a");
    static const std::regex relation("[<>]=?");
    for (std::sregex_token_iterator side(where.begin(), where.end(), relation, -1), end; side != end; ++side)
        real_formula(side->str(), at); // none is empty
    if (const char last = where[where.find_last_not_of(' ')]; last == '<' || last == '>' || last == '=')
        at.fail("does not parse: '" + where + "'");
}

void must_be_relation(const std::string& relation, const Place& at)
{
    static const std::set<std::string> relations{"=", "~", "<", ">", "<=", ">="};
    if (!relations.count(relation)) at.fail("no relation: '" + relation + "'");
}

/// "A = B <= C" as parts of a print.
void take_chain(Print& p, const std::string& says, const std::string& where, const Place& at)
{
    std::vector<std::string> sides{""}, relations;
    for (std::size_t i = 0; i < says.size(); ++i) {
        const char c = says[i];
        if (c != '<' && c != '>' && c != '=' && c != '~') {
            sides.back() += c;
            continue;
        }
        const bool two = i + 1 < says.size() && says[i + 1] == '=';
        relations.push_back(says.substr(i, two ? 2 : 1));
        i += two ? 1 : 0;
        sides.push_back("");
    }
    if (relations.empty()) at.fail("no relation in '" + says + "'; write A = B, A < B, ...");
    for (const std::string& relation : relations) must_be_relation(relation, at);
    for (std::string& s : sides) {
        const std::size_t from = s.find_first_not_of(' ');
        if (from == std::string::npos) at.fail("does not parse: '" + says + "'");
        s = s.substr(from, s.find_last_not_of(' ') - from + 1);
        formula(s, at);
    }
    for (std::size_t i = 0; i < relations.size(); ++i) {
        const std::string part = std::to_string(i) + ".";
        p.fields[part + "lhs"] = sides[i];
        p.fields[part + "relation"] = relations[i];
        p.fields[part + "rhs"] = sides[i + 1];
        if (!where.empty()) p.fields[part + "condition"] = where;
    }
    if (!where.empty()) check_condition(where, at.in("where"));
}

Alphabet read_alphabet(const json& symbols, OwnLedger& ledger, const Place& file)
{
    static const std::regex symbol_name("[A-Za-z]\\w*");
    Alphabet a;
    std::map<std::string, std::vector<std::string>> of_dimension;
    for (const auto& [name, content] : symbols.items()) {
        const Place at = file.in("symbol '" + name + "'");
        of_some_length(name, file);
        if (!std::regex_match(name, symbol_name)) at.fail("a symbol is a letter, then letters, digits and _");
        only(content, {"dimension", "sign", "is", "range", "means"}, at);
        SymbolKind& kind = a.symbols[name];
        kind.dimension = text(content, "dimension", at);
        if (kind.dimension->empty()) at.fail("has no dimension; \"1\" for a number");
        const std::string sign = text(content, "sign", at, "positive");
        if (sign != "positive" && sign != "real") at.fail("sign is positive or real, not '" + sign + "'");
        kind.real = sign == "real";
        OwnSymbol& s = ledger.symbols[name];
        s.is = text(content, "is", at);
        text(content, "means", at);
        s.positive = !kind.real;
        std::tie(s.low, s.high) = content.contains("range") ? range(content["range"], at) : std::pair{Rational(1, 4), Rational(9, 4)};
        if (!kind.real && s.low < 0) at.fail("is positive, its range is not");
        of_dimension[*kind.dimension].push_back(name);
    }
    for (auto& [dimension, names] : of_dimension)
        if (names.size() > 1) a.alike.push_back(names); // what a typesetter could mistake for one another
    return a;
}

/// What a ledger's folder holds, read whole. A ledger may be a stranger's: no link and no ".." leads out of its folder, and what never ends
/// (a device, a pipe) or is longer than any ledger is not read.
std::string file_in(const std::string& dir, const std::string& name)
{
    namespace fs = std::filesystem;
    constexpr std::uintmax_t longest = std::uintmax_t{64} << 20;
    const std::string path = dir + "/" + name;
    std::error_code error;
    if (!fs::exists(path, error)) throw OwnLedgerError(path + ": no such file", true);
    const fs::path folder = fs::canonical(dir, error), real = fs::canonical(path, error);
    if (std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first != folder.end())
        throw OwnLedgerError(path + ": is outside of the ledger's folder");
    if (!fs::is_regular_file(real, error) || fs::file_size(real, error) > longest)
        throw OwnLedgerError(path + ": is no plain file of at most " + std::to_string(longest) + " bytes");
    std::ifstream in(real, std::ios::binary);
    if (!in) throw OwnLedgerError(path + ": cannot be read");
    return {std::istreambuf_iterator<char>(in), {}};
}

void read_table(const OwnLedger& ledger, OwnEntry& e, const json& t, const std::string& dir, const Place& at)
{
    only(t, {"formula", "columns", "rounding", "rows", "file"}, at);
    OwnTable table;
    table.formula = text(t, "formula", at);
    table.rounding = text(t, "rounding", at, "nearest");
    if (table.rounding != "nearest" && table.rounding != "down") at.fail("rounding is nearest or down, not '" + table.rounding + "'");
    if (!t.contains("columns") || !t["columns"].is_array()) at.fail("'columns' is a list of symbols");
    for (const auto& c : t["columns"]) {
        if (!c.is_string()) at.fail("'columns' is a list of symbols");
        must_be_symbol(c, at);
        if (std::count(table.columns.begin(), table.columns.end(), c) > 0) at.fail("two columns '" + c.get<std::string>() + "'");
        table.columns.push_back(c);
    }
    for (const std::string& n : symbols_of(real_formula(table.formula, at)))
        if (std::find(table.columns.begin(), table.columns.end(), n) == table.columns.end())
            at.fail("the formula asks for '" + n + "', which is no column");
    std::vector<std::vector<std::string>> rows;
    if (t.contains("rows") && t.contains("file")) at.fail("either \"rows\" or \"file\"");
    if (t.contains("rows")) {
        for (const auto& row : list(t, "rows", at)) {
            if (!row.is_array()) at.fail("a row is [\"0.5\", \"0.2764\"], not " + row.dump().substr(0, 40));
            rows.emplace_back();
            for (const auto& cell : row) rows.back().push_back(digits(cell, at.in("row " + std::to_string(rows.size()))));
        }
    } else {
        std::istringstream in(file_in(dir, text(t, "file", at, "table.txt")));
        for (std::string line; std::getline(in, line);) {
            if (line.empty() || line[0] == '#') continue;
            std::istringstream words(line);
            rows.emplace_back();
            for (std::string w; words >> w;) rows.back().push_back(w);
        }
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const Place row = at.in("row " + std::to_string(k + 1));
        if (rows[k].size() != table.columns.size() + 1)
            row.fail("has " + std::to_string(rows[k].size()) + " numbers, " + std::to_string(table.columns.size() + 1) +
                     " are wanted: the columns, then what is printed");
        for (std::size_t c = 0; c < rows[k].size(); ++c) {
            const auto value = parse_rational(rows[k][c]);
            if (!value) row.fail("not a number: " + rows[k][c]);
            if (c < table.columns.size()) must_have_the_sign(ledger, table.columns[c], *value, row);
        }
        static const std::regex decimal(
            R"([-+]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][-+]?[0-9]{1,6})?)"); // its last place says how it was rounded
        if (!std::regex_match(rows[k].back(), decimal))
            row.fail("what is printed is a decimal number such as 0.25 or 2.5e-3, not " + rows[k].back());
        e.print.fields["row" + std::to_string(k + 1) + ".digits"] = rows[k].back();
        rows[k].pop_back();
        table.inputs.push_back(rows[k]);
    }
    if (table.inputs.empty()) at.fail("a table without rows");
    e.table = std::move(table);
}

/// "@H2 + x": the entries named.
std::vector<std::string> references(const std::string& t)
{
    std::vector<std::string> all;
    for (std::sregex_iterator it(t.begin(), t.end(), reference()), end; it != end; ++it) all.push_back((*it)[1]);
    return all;
}

/// What stands between two relations of a chain is the right side of one part and the left side of the next: edits mend both.
std::vector<Edit> with_both_fields(const Print& p, const std::vector<Edit>& edits)
{
    std::vector<Edit> all = edits;
    const auto is_edited = [&](const std::string& field) {
        return std::any_of(edits.begin(), edits.end(), [&](const Edit& e) { return e.field == field; });
    };
    for (std::size_t i = 0; i + 1 < p.parts(); ++i) {
        const std::string left = std::to_string(i) + ".rhs", right = std::to_string(i + 1) + ".lhs";
        const bool is_left = is_edited(left) || (i == 0 && is_edited("rhs"));
        if (is_left == is_edited(right)) continue;
        for (const Edit& e : edits)
            if (e.field == left || e.field == right || (i == 0 && e.field == "rhs")) all.push_back({is_left ? right : left, e.from, e.to});
    }
    return all;
}

/// The corrected form is one that could be printed.
void check_corrected(const Print& print, const std::vector<Edit>& edits, const Place& at)
{
    Print p;
    try {
        p = print.edited(edits);
    } catch (const std::exception& wrong) {
        at.fail(wrong.what());
    }
    for (std::size_t i = 0; i < p.parts(); ++i) {
        const std::string part = std::to_string(i) + ".", relation = p.text(part + "relation");
        for (const char* side : {"lhs", "rhs"}) formula(p.text(part + side), at);
        if (p.has(part + "condition")) check_condition(p.text(part + "condition"), at);
        must_be_relation(relation, at);
    }
}

OwnEntry read_entry(const OwnLedger& ledger, const json& content, const std::string& dir, const Place& file, std::size_t index)
{
    if (!content.is_object() || !content.contains("id") || !content["id"].is_string())
        file.fail("entry " + std::to_string(index + 1) + " has no \"id\"");
    OwnEntry e;
    e.print.id = content["id"];
    static const std::regex name("[\\w.:-]+"); // what "@ID" can name, and not a formula: "@H1+1" is the right side of H1 and 1
    of_some_length(e.print.id, file);
    if (!std::regex_match(e.print.id, name))
        file.fail("entry " + std::to_string(index + 1) + ": an id is of letters, digits, and . _ - :, not " + content["id"].dump());
    const Place at = file.in("entry '" + e.print.id + "'");
    only(content, {"id", "print", "section", "says", "where", "is", "follows", "over", "table", "correction", "excuses", "comment"}, at);
    e.print.tex = text(content, "print", at);
    e.print.section = text(content, "section", at);
    e.print.domain = text(content, "where", at);
    if (const std::string is = text(content, "is", at); is == "definition") e.definition = true;
    else if (!is.empty()) at.fail("\"is\" can be \"definition\", not '" + is + "'");
    text(content, "comment", at);
    for (const char* key : {"says", "where", "is", "follows", "over"})
        if (content.contains("table") && content.contains(key))
            at.fail(std::string("a table has no '") + key + "'; give it an entry of its own");
    if (content.contains("table")) read_table(ledger, e, content["table"], dir, at.in("table"));
    else if (!content.contains("says")) at.fail("\"says\" is missing: the formula as printed");
    if (content.contains("says")) take_chain(e.print, text(content, "says", at), e.print.domain, at);
    if (content.contains("follows")) {
        const json& f = content["follows"];
        only(f, {"equation", "side", "with", "derivative_by"}, at.in("follows"));
        Follows follows;
        follows.equation = text(f, "equation", at);
        follows.side = text(f, "side", at, "rhs");
        if (follows.side != "rhs" && follows.side != "lhs") at.fail("\"side\" is lhs or rhs, not '" + follows.side + "'");
        follows.derivative_by = text(f, "derivative_by", at);
        if (!follows.derivative_by.empty()) must_be_symbol(follows.derivative_by, at.in("derivative_by"));
        e.rests_on.push_back(follows.equation);
        if (f.contains("with")) {
            if (!f["with"].is_object()) at.fail("\"with\" is { symbol: formula, ... }");
            for (const auto& [symbol, by] : f["with"].items()) {
                if (!by.is_string()) at.fail("'" + symbol + "' is replaced by a formula in quotes");
                must_be_symbol(symbol, at.in("with"));
                of_some_length(by.get_ref<const std::string&>(), at.in("with"));
                follows.with.emplace_back(symbol, by);
                real_formula(std::regex_replace(by.get<std::string>(), reference(), "(1)"), at.in("with"));
                for (const std::string& id : references(by)) e.rests_on.push_back(id);
            }
        }
        e.follows = follows;
    }
    if (content.contains("over")) {
        if (!content["over"].is_object() || content["over"].empty()) at.fail("\"over\" is { symbol: [low, high], ... }");
        for (const auto& [symbol, value] : content["over"].items()) {
            must_be_symbol(symbol, at.in("over"));
            const auto [low, high] = range(value, at.in("over " + symbol));
            must_have_the_sign(ledger, symbol, low, at.in("over"));
            e.over.push_back({symbol, low, high});
        }
    }
    if (content.contains("correction")) {
        const json& c = content["correction"];
        only(c, {"wrong", "severity", "edits"}, at.in("correction"));
        OwnCorrection correction{text(c, "wrong", at), text(c, "severity", at, "misprint"), {}};
        for (const auto& edit : list(c, "edits", at.in("correction"))) {
            only(edit, {"field", "from", "to"}, at.in("correction"));
            correction.edits.push_back({text(edit, "field", at, "rhs"), text(edit, "from", at), text(edit, "to", at)});
        }
        correction.edits = with_both_fields(e.print, correction.edits);
        check_corrected(e.print, correction.edits, at.in("correction"));
        e.correction = correction;
    }
    for (const auto& excuse : list(content, "excuses", at)) {
        only(excuse, {"change", "reason"}, at.in("excuses"));
        e.excuses[text(excuse, "change", at)] = text(excuse, "reason", at);
    }
    return e;
}

/// A bound over a range: each symbol it is of needs one, or stands for what has.
void must_have_a_range_each(const OwnLedger& ledger, const OwnEntry& e, const Place& file)
{
    if (e.over.empty()) return;
    bool is_any = false;
    const std::function<void(const ex&)> look = [&](const ex& of) {
        for (const std::string& name : symbols_of(of)) {
            if (std::any_of(e.over.begin(), e.over.end(), [&](const Range& r) { return r.symbol == name; })) continue;
            const std::string& is = ledger.symbols.at(name).is;
            if (is.empty()) file.in("entry '" + e.print.id + "'").fail("\"over\" has no range of '" + name + "'");
            look(read(is));
        }
    };
    for (std::size_t i = 0; i < e.print.parts(); ++i) {
        const std::string part = std::to_string(i) + ".", relation = e.print.text(part + "relation");
        if (relation == "=" || relation == "~") continue; // compared as formulas
        is_any = true;
        look(e.print(part + "lhs"));
        look(e.print(part + "rhs"));
    }
    if (!is_any) file.in("entry '" + e.print.id + "'").fail("\"over\" is of a bound, and nothing here is printed with < or >");
}

/// A name on a way back to itself, with that way; or nothing.
std::string cycle_in(const std::map<std::string, std::vector<std::string>>& next)
{
    std::map<std::string, int> state;
    std::string path;
    const std::function<bool(const std::string&, const std::string&)> visit = [&](const std::string& name, const std::string& way) {
        if (state[name] == 2) return false;
        if (state[name] == 1) {
            path = way + name;
            return true;
        }
        state[name] = 1;
        if (const auto found = next.find(name); found != next.end())
            for (const std::string& other : found->second)
                if (visit(other, way + name + " -> ")) return true;
        state[name] = 2;
        return false;
    };
    for (const auto& [name, others] : next)
        if (visit(name, "")) break;
    return path;
}

/// What stands for something is positive where that is shown; where it is not, it is real, by which no root or modulus is simplified. A
/// symbol keeps the sign that it was first read with: so what it stands for comes first.
void take_signs_that_are_shown(const OwnLedger& ledger, Alphabet a, const Place& file)
{
    std::map<std::string, std::vector<std::string>> stands_for;
    for (const auto& [name, symbol] : ledger.symbols) {
        const std::set<std::string> all = words(symbol.is);
        const auto is_symbol = [&](const std::string& word) { return ledger.symbols.count(word) > 0; };
        std::copy_if(all.begin(), all.end(), std::back_inserter(stands_for[name]), is_symbol);
    }
    if (const std::string path = cycle_in(stands_for); !path.empty())
        file.fail("symbol '" + path.substr(0, path.find(' ')) + "': a cycle: " + path);
    use_alphabet(a);
    std::set<std::string> done;
    const std::function<void(const std::string&)> take = [&](const std::string& name) {
        if (!done.insert(name).second) return;
        for (const std::string& other : stands_for.at(name)) take(other);
        const OwnSymbol& symbol = ledger.symbols.at(name);
        if (symbol.is.empty() || !symbol.positive) return;
        Check shown;
        try {
            const ex is = read(symbol.is);
            shown = is_positive(is) ? Check{Verdict::proved, ""} : not_negative(ledger, is);
        } catch (const std::exception& wrong) { // told where the symbol is read
            shown = {Verdict::undecided, wrong.what()};
        }
        if (shown.verdict == Verdict::refuted)
            file.in("symbol '" + name + "'").fail("is positive, and what it stands for is not: " + shown.detail +
                                                  "; \"sign\": \"real\" says that it need not be, \"range\" where one looks");
        if (shown.verdict == Verdict::proved) return;
        a.symbols.at(name).real = true;
        use_alphabet(a);
    };
    for (const auto& [name, symbol] : ledger.symbols) take(name);
}

} // namespace

const std::regex& reference()
{
    static const std::regex name("@([\\w.:-]+)");
    return name;
}

const OwnEntry& OwnLedger::at(const std::string& id) const
{
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const OwnEntry& e) { return e.print.id == id; });
    if (found == entries.end()) throw OwnLedgerError(file + ": no entry '" + id + "'");
    return *found;
}

bool OwnLedger::has(const std::string& id) const
{
    return std::any_of(entries.begin(), entries.end(), [&](const OwnEntry& e) { return e.print.id == id; });
}

OwnLedger load_ledger(const std::string& dir)
{
    return read_ledger(file_in(dir, "ledger.json"), dir);
}

OwnLedger read_ledger(const std::string& written, const std::string& dir)
{
    OwnLedger ledger;
    ledger.file = dir + "/ledger.json";
    const Place file(ledger.file);
    if (shallow(written).size() < written.size()) file.fail("brackets nest too deep");
    json all;
    try {
        all = json::parse(written, no_key_twice(file), true, true); // comments are allowed
    } catch (const json::exception& e) {
        const std::string what = e.what();
        file.fail("not JSON: " + what.substr(std::min(what.find("parse error"), what.size())));
    }
    only(all, {"title", "symbols", "entries"}, file);
    ledger.title = text(all, "title", file);
    if (!all.contains("symbols") || !all["symbols"].is_object()) file.fail("\"symbols\" is missing: { name: { \"dimension\": ... }, ... }");
    if (!all.contains("entries") || !all["entries"].is_array() || all["entries"].empty()) file.fail("\"entries\" is missing or empty");
    take_signs_that_are_shown(ledger, read_alphabet(all["symbols"], ledger, file), file);
    for (const auto& [name, symbol] : ledger.symbols) {
        const Place at = file.in("symbol '" + name + "'");
        must_be_free(name, at);
        Print p;
        p.id = name;
        p.fields = {{"0.lhs", name}, {"0.relation", "="}, {"0.rhs", symbol.is.empty() ? name : symbol.is}};
        if (!symbol.is.empty()) real_formula(symbol.is, at);
        try {
            if (const Check c = units(p); c.verdict == Verdict::refuted) at.fail(c.detail);
        } catch (const std::invalid_argument& e) {
            at.fail(e.what());
        }
    }
    std::map<std::string, std::vector<std::string>> rests_on;
    for (std::size_t i = 0; i < all["entries"].size(); ++i) {
        OwnEntry e;
        try {
            e = read_entry(ledger, all["entries"][i], dir, file, i);
        } catch (const json::exception& wrong) {
            file.fail("entry " + std::to_string(i + 1) + ": " + wrong.what());
        }
        if (ledger.has(e.print.id)) file.fail("entry '" + e.print.id + "': two entries of that name");
        rests_on[e.print.id] = e.rests_on;
        ledger.entries.push_back(std::move(e));
    }
    for (const OwnEntry& e : ledger.entries) must_have_a_range_each(ledger, e, file);
    for (const OwnEntry& e : ledger.entries)
        for (const std::string& other : e.rests_on)
            if (!ledger.has(other)) file.fail("entry '" + e.print.id + "': no entry '" + other + "' to follow from");
            else if (ledger.at(other).print.parts() == 0) file.fail("entry '" + e.print.id + "': '" + other + "' is a table, no equation");
    if (const std::string path = cycle_in(rests_on); !path.empty())
        file.fail("entry '" + path.substr(0, path.find(' ')) + "': a cycle: " + path);
    return ledger;
}

} // namespace touchstone::proofs
