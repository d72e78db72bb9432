// SPDX-License-Identifier: MIT
/// \file
/// The verdict on a code from its answers and certified values, row by row and as a whole.
#pragma once

#include "touchstone/oracle/baseline.hpp"
#include "touchstone/oracle/error.hpp"
#include "touchstone/table/format.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::oracle {

/// How many of the worst rows are worth a reader's time: those have `forced` in any case.
inline constexpr std::size_t shown_rows = 10;

/// A row asked: exact inputs, and the value the answer is measured against.
struct Question {
    std::vector<double> inputs; ///< in the quantity's order
    std::string value;          ///< the certified value as text
    CertifiedValue truth; ///< the same as a number, with its error
    bool held_out = false;      ///< not from the table: certified at judge time
    std::optional<Forced> forced{}; ///< as the table has it
};
/// A known mistake that explains the answers.
struct MixUp {
    std::string name; ///< as mixup.hpp calls it
    double explains = 0;        ///< share of the telling rows it gives, 0 to 1
    double to = 0;              ///< relative difference up to which they are the same
    std::size_t remains = 0;    ///< telling rows tried that it does not give
    bool ordinary_only = false; ///< of the ordinary rows alone (regime.hpp): the others are wrong in another way
};

/// answer/truth over all rows where both are numbers and the truth is not zero.
struct Ratio {
    std::size_t rows = 0; ///< over how many it is taken
    double median = 0; ///< half of the rows have less
    double lower = 0;  ///< a quarter of the rows has less
    double upper = 0;  ///< a quarter of the rows has more
};

/// What the answers have in common. See mixup.hpp.
struct Diagnosis {
    Ratio ratio; ///< answer over truth
    std::optional<MixUp> mixup; ///< nothing if none explains them
    std::vector<std::string> findings;   ///< a sentence each: single precision, few digits printed
};
/// Within the bound, beyond it, or not decided by what is certified.
enum class Verdict { pass, fail, undecided };
std::string_view to_string(Verdict); ///< its name
/// What an answer may be off by.
struct Bound {
    double ulps = 4;            ///< of error beyond what the rounding of inputs forces
    double relative = 0;        ///< |answer - truth| <= at_least + relative |truth| passes too, as in numpy's allclose
    double at_least = 0; ///< numpy's atol
    bool forgive_inputs = true; ///< false: the bound is for the whole error
    double absolute = 0;        ///< allowed where the true value is zero
    bool keep_order = false;    ///< order and symmetry violations fail too
    /// Replaces `ulps` for the table's rows by what the code reached before. Rows held out have no such figure: beside a baseline
    /// they are judged by `ulps`, and never decide.
    const Baseline* baseline = nullptr;
};
/// One answer, and what is to be said of it.
struct JudgedRow {
    double answer = 0; ///< as the code gave it
    bool special = false;            ///< NaN, or infinite where the truth is not
    Interval error;                  ///< ulps; absolute where the truth is zero; of no meaning if special
    std::optional<Forced> forced;    ///< worked out only where the verdict or the reader needs it
    Verdict verdict = Verdict::pass; ///< by the bound
    std::string why;                 ///< why not passed; else empty
};

/// Two rows whose answers are in the wrong order, or differ where the truth is the same by symmetry.
struct OrderViolation {
    std::size_t first;  ///< number of the one row, as asked
    std::size_t second; ///< number of the other
    std::string what; ///< which rule is broken
};
/// All rows, and what they come to.
struct Judgement {
    Verdict verdict = Verdict::pass; ///< of all rows: fail if one fails, else undecided if one is
    std::vector<JudgedRow> rows; ///< as asked
    Interval ulps;                       ///< worst row: largest least, largest most
    std::size_t failed = 0;              ///< rows beyond the bound
    std::size_t undecided = 0;           ///< rows that the certified digits do not decide
    std::size_t special = 0;             ///< rows answered by nan, or by an infinity where the truth is none
    std::size_t negative_zeros = 0;      ///< rows answered by -0 where the truth is 0
    std::size_t zeros = 0;               ///< rows whose truth is 0
    std::size_t held_out_failed = 0;     ///< rows held out beside a baseline that are beyond `ulps`: said, never counted
    double worst_at_zero = 0;            ///< largest |answer| where the truth is zero
    std::vector<std::size_t> worst;      ///< rows, the worst first
    std::vector<OrderViolation> order; ///< wherever it was found
    Diagnosis diagnosis;                 ///< the mix-up only if rows fail
    bool looked_up = false;              ///< right on the table's rows, wrong off them
};

/// The questions of a stored table.
std::vector<Question> questions(const StoredTable&);

/// The rows that are quickly certified; of the recursion those of one surface, which the seed chooses.
std::vector<std::size_t> quick_rows(const Quantity&, const std::vector<Question>&, unsigned long seed);

/// `count` rows near those of the table but not in it, with freshly certified values. The seed decides
/// which: a subject that looks its answers up cannot know them. For the recursion they are near rows that are quickly certified
/// and keep the surface, so that judging takes seconds.
std::vector<Question> held_out(const Quantity&, const std::vector<Question>&, std::size_t count, unsigned long seed);

/// Certifies stored rows again and compares digit by digit: a table may be well formed, carry the
/// right hash and still lie. Of the recursion, whose every digit costs, what decides a verdict is enough for a verdict: eight digits
/// beyond binary64. \throws CorruptTable
enum class Recheck { every_digit, what_decides };
void recheck(const Quantity&, const StoredTable&, const std::vector<std::size_t>& rows, std::string_view file,
             Recheck = Recheck::every_digit);
/// Of one row only what it says that rounded inputs force. \throws CorruptTable
void recheck_forced(const Quantity&, const StoredTable&, std::size_t row, std::string_view file);

/// answers[i] is the answer to questions[i]. `progress(done, total)` is called now and then.
Judgement judge(const Quantity&, const std::vector<Question>&, const std::vector<double>& answers, const Bound&,
                const std::function<void(std::size_t, std::size_t)>& progress = {});

} // namespace touchstone::oracle
