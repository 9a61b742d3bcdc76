// How the search splits text into words, both for building the index and for queries.

const COMMON = new Set("a an and are as at be but by for from has have if in is it its not of on or that the then this to was what when which with you your".split(" "));

export const OPTIONS = {
  fields: ["heading", "text"],
  storeFields: [],
  tokenize: (text) => text.match(/[\p{L}\p{N}_]+(?:\.[\p{L}\p{N}]+)*/gu) ?? [], // B6.7 is one word
  // Numbers are indexed only in headings, where they name exercises.
  processTerm(word, field) {
    const plain = word.toLowerCase();
    return COMMON.has(plain) || (field === "text" && /^[\d.]+$/.test(plain)) ? null : plain;
  },
};
