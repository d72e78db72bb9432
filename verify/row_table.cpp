// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/row_table.hpp"

#include "touchstone/catalogue/named_inputs.hpp"
#include "touchstone/table/format.hpp"
#include "touchstone/table/json_text.hpp"
#include "verify/exit_codes.hpp"
#include "verify/kept_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <openssl/evp.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace touchstone::program {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json description(const RowTableKind& k)
{
    const Quantity& q = *k.quantity;
    return {{"name", "own rows"},
            {"quantity", q.name},
            {"equation", q.equation},
            {"unit", q.unit},
            {"description", q.description},
            {"inputs", k.columns},
            {"input_format", k.binary64 ? "binary64" : "exact"},
            {"digits", k.digits},
            {"rounding", rounding_names()[static_cast<std::size_t>(k.rounding)]}};
}

Failure not_written(const std::string& path)
{
    return Failure(cannot_write, fmt::format("cannot write {}: {}", path, std::strerror(errno)));
}

/// FILE.part, held so that no other run writes FILE meanwhile: a descriptor, to be closed when FILE is there. \throws Failure
int held(const std::string& path)
{
    for (;;) {
        const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (descriptor < 0) throw not_written(path);
        struct stat ours{}, there{};
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
            ::close(descriptor);
            throw Failure(cannot_write, fmt::format("cannot write {}: another run is writing it", path));
        }
        // else it is held; or the file system knows no locks, and two runs at once are the user's to avoid
        const bool same = ::fstat(descriptor, &ours) == 0 && ::stat(path.c_str(), &there) == 0 && ours.st_ino == there.st_ino;
        if (same && S_ISREG(ours.st_mode)) return descriptor;
        ::close(descriptor);
        if (same)
            throw Failure(cannot_write, fmt::format("cannot write {}: is no plain file", path)); // a pipe would be written to without end
        // another run has just finished with it
    }
}

/// A file that was not there: what a dead run left is removed, and no link of anybody's is followed. -1: it cannot be.
int opened_anew(const std::string& path)
{
    ::unlink(path.c_str());
    return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
}

/// A reason names a file as somebody called it: in a table it is one line all the same.
std::string in_one_line(std::string reason)
{
    for (char& c : reason)
        if (static_cast<unsigned char>(c) < 0x20) c = '?';
    return reason;
}

} // namespace

struct RowsHash::Context {
    EVP_MD_CTX* context = EVP_MD_CTX_new();
    Context() = default;
    ~Context() { EVP_MD_CTX_free(context); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
};

RowsHash::RowsHash()
    : context_(std::make_unique<Context>())
{
    EVP_DigestInit_ex(context_->context, EVP_sha256(), nullptr);
}

RowsHash::~RowsHash() = default;

void RowsHash::add(std::string_view bytes) { EVP_DigestUpdate(context_->context, bytes.data(), bytes.size()); }

std::string RowsHash::text() const
{
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned size = 0;
    const Context copy;
    EVP_MD_CTX_copy_ex(copy.context, context_->context);
    EVP_DigestFinal_ex(copy.context, digest.data(), &size);
    std::string hex;
    for (unsigned i = 0; i < size; ++i) hex += fmt::format("{:02x}", digest[i]);
    return hex;
}

std::string row_line(const RowTableKind& k, std::size_t number, const std::vector<std::string>& words, const RowOutcome& o)
{
    const std::string status = o.refusal.empty() ? std::string(to_string(o.result.status)) : "refused";
    const std::string& reason = !o.refusal.empty() ? o.refusal : o.result.note;
    const bool told = status == "refused" || status == "undecided";
    if (k.json) {
        Json inputs = Json::object();
        for (std::size_t i = 0; i < words.size(); ++i) inputs[k.columns[i]] = words[i];
        Json j{{"row", number}, {"quantity", k.quantity->name}, {"inputs", inputs}};
        if (o.refusal.empty()) {
            j["value"] = o.result.value;
            j["error"] = o.result.error_bound;
            j["digits"] = o.result.digits;
        }
        j["status"] = status;
        if (o.refusal.empty() && o.result.binary64) j["binary64"] = hexfloat(*o.result.binary64);
        if (!reason.empty()) j["note"] = reason;
        return j.dump() + "\n";
    }
    const std::string value = o.refusal.empty() ? o.result.value + " " + o.result.error_bound : "nan inf";
    return fmt::format("{} {}{}{}{}\n", fmt::join(words, " "), value, status_mark, status,
                       told ? ": " + in_one_line(reason) : "");
}

bool same_kind(const Json& found, const RowTableKind& k)
{
    if (!found.is_object()) return false;
    const Json right = description(k);
    for (const char* key : {"quantity", "inputs", "input_format", "digits", "rounding"})
        if (!found.contains(key) || found.at(key) != right.at(key)) return false;
    return true;
}

std::string kind_text(const RowTableKind& k) { return description(k).dump(); }

RowTableKind kind_from(const std::string& json)
{
    const Json j = Json::parse(shallow(json), nullptr, false);
    try {
        RowTableKind k;
        k.quantity = find_quantity(j.at("quantity").get<std::string>());
        k.columns = j.at("inputs").get<std::vector<std::string>>();
        k.binary64 = j.at("input_format") == "binary64";
        k.digits = j.at("digits");
        const auto rounding = rounding_named(j.at("rounding").get<std::string>());
        if (k.quantity != nullptr && rounding) {
            k.rounding = *rounding;
            check_keys(*k.quantity, k.columns);
            if (description(k) == j && k.digits >= 1 && k.digits <= any_digits) return k;
        }
    }
    catch (const nlohmann::json::exception&) {
    }
    catch (const WrongKeys&) {
    }
    throw CorruptTable("rows of another program: '" + json.substr(0, 80) + "'");
}

RowTable::RowTable(RowTableKind kind, std::string out, bool resume)
    : kind_(std::move(kind))
    , out_(std::move(out))
{
    std::error_code error;
    stream_ = out_.empty() || (fs::exists(out_, error) && !fs::is_regular_file(out_, error));
    if (stream_) {
        file_ = out_.empty() ? stdout : std::fopen(out_.c_str(), "wb");
        if (file_ == nullptr) throw not_written(out_);
    }
    else {
        if (fs::is_symlink(out_, error)) out_ = fs::canonical(out_, error).string();
        part_ = out_ + ".part";
        if (resume) open_before(table_to_resume(out_));
        held_ = held(out_ + ".part");
        const int descriptor = part_ == out_ + ".part" ? ::dup(held_) : opened_anew(part_);
        file_ = descriptor < 0 || ::ftruncate(descriptor, 0) != 0 ? nullptr : ::fdopen(descriptor, "wb");
        if (file_ == nullptr) throw not_written(part_);
    }
    if (!kind_.json) put(header(""));
    if (before_) next_kept();
}

void RowTable::open_before(const std::string& path)
{
    if (path.empty()) return;
    before_ = std::make_unique<KeptRows>(path, kind_);
    if (path == part_) part_ = out_ + ".part2";
}

RowTable::~RowTable()
{
    if (file_ != stdout && file_ != nullptr) std::fclose(file_);
    if (held_ >= 0) ::close(held_);
}

void RowTable::put(const std::string& bytes)
{
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) throw not_written(place());
}

std::string RowTable::header(const std::string& summary) const
{
    const Quantity& q = *kind_.quantity;
    Json h = description(kind_);
    h["version"] = std::string(version());
    if (!summary.empty()) h.update(Json::parse(summary));
    const char* direction = kind_.rounding == Rounding::nearest ? "to nearest"
                            : kind_.rounding == Rounding::up    ? "up"
                            : kind_.rounding == Rounding::down  ? "down"
                            : kind_.rounding == Rounding::zero  ? "towards zero"
                                                                : "away from zero";
    return fmt::format("# Touchstone values of {}\n"
                       "# {}; equation {}; unit {}\n"
                       "# {}\n"
                       "# value: the true value rounded {}, {} significant digits (fewer if exact). error: bound of |value - true value|. "
                       "After #: the row's status;\n"
                       "# exact and certified are proven, estimated is not (nor is its error), undecided and refused say why.\n"
                       "# {}\n# {} value error\n",
                       q.name, q.description, q.equation, q.unit,
                       kind_.binary64
                           ? "Inputs are binary64 numbers in shortest round-trip decimal: each stands for the binary64 number it rounds to."
                           : "Inputs are exact: 0.1 is 1/10.",
                       direction, kind_.digits, h.dump(), fmt::join(kind_.columns, " "));
}

std::string RowTable::summary(bool complete) const
{
    std::string weakest = "exact";
    for (const auto& s : statuses)
        if (counts_.contains(s)) weakest = s;
    return Json{{"rows", rows_}, {"status", weakest}, {"statuses", counts_}, {"complete", complete}, {"sha256", hash_.text()}}.dump();
}

void RowTable::next_kept()
{
    auto next = before_->next();
    if (!next) return before_.reset();
    kept_line_ = std::move(next->line);
    kept_status_ = std::move(next->row.status);
    kept_words_ = std::move(next->row.words);
}

std::optional<RowSink::Kept> RowTable::kept(const std::vector<std::string>& words)
{
    if (!before_ || kept_words_ != words) return std::nullopt;
    Kept row{kept_line_, kept_status_};
    next_kept();
    return row;
}

void RowTable::add(std::size_t, const std::string& line)
{
    put(line);
    hash_.add(line);
}

void RowTable::flush()
{
    if (std::fflush(file_) != 0) throw not_written(place());
}

void RowTable::finish(bool complete)
{
    const std::string said = summary(complete);
    if (stream_) {
        if (!kind_.json) put("# " + said + "\n");
        flush();
        return;
    }
    if (std::fclose(std::exchange(file_, nullptr)) != 0) throw not_written(part_);
    std::error_code error;
    std::string whole = part_;
    if (!kind_.json) { // the same rows under a first page that knows them
        whole += ".whole";
        std::ifstream rows(part_, std::ios::binary);
        rows.seekg(static_cast<std::streamoff>(header("").size()));
        if (const int descriptor = opened_anew(whole); descriptor < 0 || ::close(descriptor) != 0) throw not_written(whole);
        std::ofstream to(whole, std::ios::binary);
        to << header(said);
        if (rows_ > 0) to << rows.rdbuf();
        to.close();
        if (!to || !rows) {
            const Failure why = not_written(whole);
            fs::remove(whole, error);
            throw why;
        }
    }
    fs::rename(whole, out_, error);
    if (error) throw Failure(cannot_write, fmt::format("cannot write {}: {}", out_, error.message()));
    fs::remove(out_ + ".part2", error);
    if (whole != out_ + ".part") fs::remove(out_ + ".part", error); // else it is FILE now, and one that is there another run's
}

} // namespace touchstone::program
