/* Scores of search results: concepts before guides, guides before what the program's reference lists.
   A result is [page, title, anchor, description, score, file, kind]; the highest score comes first. */
var Scorer = {
  score: ([page, , , , score, , kind]) => {
    const found = kind === "text" ? 0 : 1; // in a title, the glossary, or as a name
    if (page === "concepts") return score + 200 * found + 100;
    if (page.startsWith("_generated/gallery")) return score + 20;
    if (page.startsWith("_generated/elements") || page === "_generated/laws") return score + 40 * found;
    if (page.startsWith("_generated/api")) return score >= Scorer.objNameMatch + Scorer.objPrio[1] ? score + 80 : score;
    if (/^(theory|architecture|verification|speed|report)$/.test(page)) return score + 60;
    return score + 100 + 20 * found; // guides, and the systems reproduced
  },
  objNameMatch: 40, // the name itself, as simulate: it comes among the guides
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};
