# SPDX-License-Identifier: MIT
"""What reads and proves certificates under texts that nobody would write: a clear no, never a crash, and never a yes to what cannot be.

Small certificates of each kind are changed at random: bytes, words, numbers, lines, pieces of one put into another; most get the counts and the sha256
that they ought to have. What draws a reason for refusal that was not seen before is changed further. Each text is read, and its lines are held against
one another; where these fit together and are few, they are proved too, but with claims of a negative share, which nothing can prove.
"""
import argparse
import hashlib
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile
import time
import traceback
from fractions import Fraction

parser = argparse.ArgumentParser()
parser.add_argument("--checker", required=True, type=pathlib.Path)
parser.add_argument("--program", required=True)
parser.add_argument("--executions", type=int, default=1500)
parser.add_argument("--seconds", type=int, default=10**6, help="end after so many, whatever was asked")
parser.add_argument("--proved", type=int, default=40, help="one in so many of the texts whose lines fit together is proved; 0: none, so that more texts are tried")
parser.add_argument("--seed", type=int, default=20261124)
parser.add_argument("--finds", type=pathlib.Path, help="directory that finds are kept in")
known = parser.parse_args()
sys.path.insert(0, str(known.checker))
import certificate  # noqa: E402
import certificate_text  # noqa: E402

WRITTEN = [("contact.area", "n=2", "load=1/10", "G=16"), ("contact.area", "n=1", "load=3/2", "G=3/2"), ("contact.exceedance", "n=1", "p=1/2", "load=3/2", "G=3/2"),
           ("limit.area_constant", "G=16"), ("contact.density", "n=2", "p=1", "load=1/10", "G=3"), ("contact.density", "n=2", "p=12", "load=10", "G=10^0.5"), ("limit.force", "p=1/10", "G=16"), ("limit.scale", "load=1/2", "tolerance=1/10", "G=16"), ("limit.gap", "G=1000")]
LONGEST_TIME = 60  # seconds of CPU: a hang
MOST_POOL = 400
NUMBERS = ["0", "1", "-1", "2", "3", "a", "f", "10", "40", "7f", "80", "ff", "100", "800", "801", "ffff", "-0", "00", "01", "+1", " ", "", "1/2", "1/0", "0/1", "2/4", "1/3", "1:0", "0:0", "0:1", "1:-1",
           "-1:-1", "1:16384", "1:-16384", "1:16385", "3:999999999", "1:1:1", "5^1/2", "2^1/64", "4^1/65", "1^1/1", "0-0", "1-1", "2-1", "1-", "-", "999999999", "1e9", "0x1", "1_0", "\u0661", "f" * 600, "f" * 4096,
           "9" * 999, "9" * 1001, "9" * 5000, "=", "==", "\t", "\r", "\0", "\x7f", "\u00e9"]


def whole(text):
    """text with the numbers, counts and sha256 that it ought to have"""
    lines = text.rpartition("sha256 ")[0].split("\n")[:-1]
    head = next((i for i, line in enumerate(lines) if re.match("[0-9]", line)), len(lines))
    body = lines[head:]
    kinds = [line.split(" ")[1] if " " in line else "" for line in body]
    counts = " ".join(f"{name}={kinds.count(kind)}" for kind, name in certificate_text.COUNTED.items() if kind in kinds)
    claims = [line for line in lines[:head] if line.startswith("claim ")]
    claims = [re.sub(r"^claim \S*", f"claim {i}", line) for i, line in enumerate(claims, 1)]
    body = [f"{i} {line.partition(' ')[2]}" for i, line in enumerate(body, 1)]
    return "\n".join([*lines[:2], f"counts claims={len(claims)} sections=1 lines={len(body)}", *claims, f"section 1 span=1-{len(body)} {counts}", *body, "sha256 "])


def signed(text):
    body = text.rpartition("sha256 ")[0]
    return body + f"sha256 {hashlib.sha256(body.encode()).hexdigest()}\n"


def changed(text, pool, chosen):
    lines = text.split("\n")
    i = chosen.randrange(len(lines))
    how = chosen.randrange(9)
    if how == 0:  # a byte
        k = chosen.randrange(len(text) + 1)
        return text[:k] + chosen.choice(["", chr(chosen.randrange(128)), chosen.choice("0123456789abcdef:=-/^, \n")]) + text[k + chosen.randrange(2):]
    if how == 1:  # a line left out, doubled, moved
        line = lines.pop(i)
        for _ in range(chosen.randrange(3)):
            lines.insert(chosen.randrange(len(lines) + 1), line)
    elif how == 2:  # a line of another
        other = chosen.choice(pool).split("\n")
        lines[i:i + chosen.randrange(2)] = [chosen.choice(other)]
    elif how == 3 and i + 1 < len(lines):  # the end of another
        other = chosen.choice(pool).split("\n")
        lines[i:] = other[chosen.randrange(len(other)):]
    else:  # a word, or what is behind its =
        words = lines[i].split(" ")
        w = chosen.randrange(len(words))
        name, mark, value = words[w].rpartition("=")
        if how == 4:
            value = chosen.choice(NUMBERS)
        elif how == 5 and value:
            k = chosen.randrange(len(value))
            value = value[:k] + chosen.choice("0123456789abcdef-") + value[k + chosen.randrange(2):]
        elif how == 6 and re.fullmatch("[0-9]+", value):
            value = str(int(value[:20]) + chosen.choice([-2, -1, 1, 2]))
        elif how == 7:
            other = chosen.choice(chosen.choice(lines).split(" "))
            value = other.rpartition("=")[2]
        else:
            words.insert(w, chosen.choice(words))
            if chosen.randrange(2):
                words.pop(chosen.randrange(len(words)))
        words[min(w, len(words) - 1)] = f"{name}{mark}{value}"
        lines[i] = " ".join(words)
    return "\n".join(lines)


class Hang(BaseException):
    pass


def hang(*_):
    raise Hang(f"more than {LONGEST_TIME} s of CPU, or ten times as many in all")


def quiet():
    signal.setitimer(signal.ITIMER_PROF, 0)
    signal.alarm(0)


def few(read):
    """Whether its lines are proved in some seconds: sizes as they are in what was written, or less."""
    size = 0
    for words in read.lines:
        if words[1] == "grid":
            _, bits, _, points = certificate.fields(words[4:8], certificate.FORMS["grid"], "")
            size += bits * points
        elif words[1] == "mesh":
            _, _, scale, _, bits, kept, accuracy, _ = certificate.fields(words[4:12], certificate.FORMS["mesh"], "")
            size += 40 * len(words) * (1 + (max(bits, kept) // 128) ** 2 + accuracy // 16 + scale // 4)
        elif words[1] in ("piece", "balance"):
            size += 8000 if words[1] == "piece" else 3500
    return size < 40000


def said_of(path, prove):
    """the reason for refusal, 'fits together' or 'refuted'"""
    try:
        read = certificate.Certificate(path)
        certificate.Replay(read, 0, 0)
    except (certificate.Malformed, certificate.Refused) as why:
        return str(why)
    if not (prove and few(read)):
        return "fits together"
    read.claims = {k: (*claim[:-2], Fraction(-1), Fraction(1, 2)) for k, claim in read.claims.items()}
    try:
        certificate.Replay(read, 1, read.count)
    except certificate.Refused as why:
        return "refuted: " + str(why)
    raise AssertionError("a negative share is proved")


def main():
    chosen = random.Random(known.seed)
    for ends in (signal.SIGPROF, signal.SIGALRM):
        signal.signal(ends, hang)
    ended = []
    signal.signal(signal.SIGTERM, lambda *_: ended.append(True))  # what has been made is counted all the same
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "certificate.txt"
        written = []
        for what in WRITTEN:
            subprocess.run([known.program, "certificate", *what, "--digits", "2", "--out", path], check=True)
            written.append(path.read_text())
            said = said_of(path, True)
            assert said.startswith("refuted: "), (what, said)  # what the program writes comes as far as the claim
        pool, reasons, proved, finds = list(written), {}, 0, []
        memory = os.memfd_create("certificate")  # a file that costs no disk
        path = pathlib.Path(f"/proc/self/fd/{memory}")
        began, made = time.process_time(), 0
        while made < known.executions and time.process_time() - began < known.seconds and not ended:
            text = chosen.choice(written if chosen.randrange(3) == 0 else pool[-60:] + written)
            for _ in range(chosen.choice([1, 1, 1, 2, 3])):
                text = changed(text, pool, chosen)
            if chosen.randrange(8):
                text = whole(text)
            if chosen.randrange(50):
                text = signed(text)
            path.write_bytes(text.encode("utf-8"))
            made += 1
            signal.setitimer(signal.ITIMER_PROF, LONGEST_TIME)  # of CPU: on a busy machine a proof waits, too
            signal.alarm(10 * LONGEST_TIME)
            try:
                said = said_of(path, known.proved > 0 and chosen.randrange(known.proved) == 0)
            except BaseException as wrong:  # noqa: BLE001
                quiet()
                if isinstance(wrong, KeyboardInterrupt):
                    raise
                finds.append(f"{type(wrong).__name__}: {wrong}\n{traceback.format_exc()}")
                print(f"execution {made} of seed {known.seed}: {finds[-1]}", flush=True)
                if known.finds:
                    known.finds.mkdir(parents=True, exist_ok=True)
                    (known.finds / hashlib.sha256(text.encode()).hexdigest()[:16]).write_bytes(text.encode())
                if len(finds) == 20:
                    break
                continue
            quiet()
            proved += said.startswith("refuted")
            reason = re.sub(r"'.*?'|[0-9a-f]*[0-9][0-9a-f]*", "#", said, flags=re.S)[:120]
            reasons[reason] = reasons.get(reason, 0) + 1
            if reasons[reason] == 1 or (reason == "fits together" and chosen.randrange(4) == 0):
                pool.append(text)
                del pool[len(written):-MOST_POOL]
        used = time.process_time() - began
    print(f"{made} texts, {made / max(used, 1e-9):.0f} a CPU second, seed {known.seed}: {len(reasons)} reasons, {reasons.get('fits together', 0) + proved} whose lines fit together, "
          f"{proved} of them proved as far as a claim that cannot hold; {len(finds)} crashes, hangs or false answers")
    if len(reasons) < 25 and made >= 1000:
        print("too few reasons were seen", *reasons, sep="\n  ")
        return 1
    return 1 if finds else 0


if __name__ == "__main__":
    sys.exit(main())
