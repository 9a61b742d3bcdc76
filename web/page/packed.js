// The site's data, which is compressed JSON. Pages read it, and so does the worker with Python.

export async function packedAt(address) {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address} could not be loaded (${answer.status}). Are you offline?`);
  return new Response(answer.body.pipeThrough(new DecompressionStream("deflate"))).json();
}
