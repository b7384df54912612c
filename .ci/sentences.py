#!/usr/bin/env python3
"""Scores the sentences of the manual: how many of a page are likely to be read twice.

    .ci/sentences.py              a line a page: sentences, words, flags, share of flagged sentences
    .ci/sentences.py PAGE         every flagged sentence of a page, with its flags
    .ci/sentences.py --check      fails where a page has a larger share than .ci/sentences.txt allows
    .ci/sentences.py --store      writes the shares into .ci/sentences.txt

A flag is a pattern. It overlooks about as much as it finds too much, so that a share says more than one sentence:
    L  more than 30 words
    P  a solver, a bar or a page that asks, tells, wants, knows, hands or believes
    I  the subject comes last: a sentence that begins with Of, What, Whether, How, Whoever, Beside, or with Where or
       That and a clause of more than eight words
    R  "one a link", "a row a pose": a rate without "per" or "each"
    N  a noun replaced: what it is, what of it, in its place, of what, all that
"""
import os, re, sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
STORED = os.path.join(ROOT, ".ci", "sentences.txt")
PERSONS = r"\b(ask|asks|asked|tell|tells|told|want|wants|wanted|know|knows|hands? (an?|the|over)|believes?d?|refuses to|takes along|say of|says? nothing)\b"
FRONT = r"^(Of|What|Whether|How|Whoever|Beside)\b"
CLAUSE = r"^(Where|That)\b[^,]*"
RATE = r"\b(one|two|three|four|five|six|an?|some|\d+) [a-z]+s? an? (link|pose|joint|group|step|call|page|row|mechanism|machine|input|driver|turn|statement|frame|pin)\b(?! of)"
NOUN = r"\b(what (it|they|is|was|has|can|acts|holds|stands|of)\b(?! (that|this))|in its place|of what|all that|than itself|what of it)"
PAGES = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"]


def pages():
    found = []
    for docs in ("linkage-core/docs", "linkage-core/design/docs"):
        found += sorted(f"{docs}/{f}" for f in os.listdir(os.path.join(ROOT, docs)) if f.endswith(".md"))
    return PAGES + found


def prose(text):
    """The text without code blocks, tables, headings, pictures, links' targets and definitions."""
    text = re.sub(r"(?ms)^( *)```.*?^\1```", "\n\n", text)
    text = re.sub(r"(?s)<!--.*?-->|<[a-z/][^>]*>", " ", text)
    kept = []
    for line in text.split("\n"):
        bare = line.strip()
        if bare.startswith("|") or bare.startswith("#") or re.match(r"^\[[^\]]+\]: ", bare) or bare.startswith("!["):
            kept.append("")
        elif re.match(r"^([-*]|\d+\.) ", bare):
            kept += ["", re.sub(r"^([-*]|\d+\.) ", "", bare)]
        else:
            kept.append(bare)
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", "\n".join(kept))
    text = re.sub(r"\[([^\]]*)\]\[[^\]]*\]", r"\1", text)
    return re.sub(r"`[^`\n]*(\n[^`\n]*)?`", "code", text)


def sentences(text):
    for paragraph in re.split(r"\n\s*\n", prose(text)):
        joined = " ".join(paragraph.split())
        for sentence in re.split(r"(?<=[.!?:])\s+(?=[A-Z\"(]|code)", joined):
            if len(re.findall(r"[A-Za-z]+", sentence)) > 2:
                yield sentence


def flags(sentence):
    words = len(re.findall(r"[A-Za-z0-9'’.%°-]+", sentence))
    front = re.match(CLAUSE, sentence)
    return "".join((
        "L" if words > 30 else "",
        "P" if re.search(PERSONS, sentence) else "",
        "I" if re.search(FRONT, sentence) or front and len(front.group().split()) > 8 else "",
        "R" if re.search(RATE, sentence) else "",
        "N" if re.search(NOUN, sentence) else "",
    )), words


def score(page):
    with open(os.path.join(ROOT, page), encoding="utf-8") as file:
        told = [(sentence, *flags(sentence)) for sentence in sentences(file.read())]
    flagged = [(sentence, found) for sentence, found, _ in told if found]
    return told, flagged


def main():
    arguments = sys.argv[1:]
    if arguments and not arguments[0].startswith("--"):
        for sentence, found in score(arguments[0])[1]:
            print(f"{found:5} {sentence}")
        return
    stored = {}
    if "--check" in arguments:
        with open(STORED, encoding="utf-8") as file:
            stored = {page: int(share) for share, page in (line.split() for line in file)}
    lines, failed = [], False
    if not stored:
        print(f"{'page':36} sent.  words   w/s    L   P   I   R   N  any  share")
    for page in pages():
        told, flagged = score(page)
        words = sum(count for _, _, count in told)
        share = round(100 * len(flagged) / max(1, len(told)))
        lines.append(f"{share} {page}\n")
        if not stored:
            counts = [sum(kind in found for _, found in flagged) for kind in "LPIRN"]
            print(f"{page:36} {len(told):5} {words:6} {words / max(1, len(told)):5.1f} "
                  + "".join(f"{count:4}" for count in counts) + f" {len(flagged):4} {share:4} %")
        elif share > stored.get(page, 15):
            failed = True
            print(f"{page}: {share} % of its sentences are flagged, {stored.get(page, 15)} % allowed; "
                  f"`.ci/sentences.py {page}` prints them")
    if "--store" in arguments:
        with open(STORED, "w", encoding="utf-8") as file:
            file.writelines(lines)
    sys.exit(failed)


main()
