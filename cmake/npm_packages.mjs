// npm_packages.mjs LOCK REGISTRY: of a lock file's packages those that this machine needs, one a line: folder, address,
// SHA-512 in hexadecimal.

import {readFileSync} from 'node:fs';

const [lock, registry] = process.argv.slice(2);
const fits = (wanted, have) => wanted === undefined || wanted.includes(have);
for (const [folder, entry] of Object.entries(JSON.parse(readFileSync(lock, 'utf8')).packages)) {
  if (folder === '' || !fits(entry.os, process.platform) || !fits(entry.cpu, process.arch)) continue;
  const name = folder.slice(folder.lastIndexOf('node_modules/') + 'node_modules/'.length);
  const [algorithm, hash] = entry.integrity.split('-');
  if (algorithm !== 'sha512') throw new Error(`${lock}: ${folder} has no SHA-512`);
  const file = `${name.slice(name.lastIndexOf('/') + 1)}-${entry.version}.tgz`;
  console.log(`${folder} ${registry.replace(/\/?$/, '/')}${name}/-/${file} ${Buffer.from(hash, 'base64').toString('hex')}`);
}
