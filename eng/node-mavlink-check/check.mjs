// The other side of eng/node-mavlink-check.sh: node-mavlink reads our frames, writes frames for us, and is timed.
//   node check.mjs FOLDER GOLDEN     the folder holds ours.bin and flight.bin; theirs.bin and node.json are written into it
import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import mavlink from 'node-mavlink'

const { MavLinkPacketSplitter, MavLinkPacketParser, MavLinkPacketSignature, MavLinkProtocolV2 } = mavlink
const [folder, golden] = process.argv.slice(2)
const dialects = ['minimal', 'standard', 'common', 'uavionix', 'icarous', 'ardupilotmega']
const registry = Object.assign({}, ...dialects.map(name => mavlink[name].REGISTRY))
const key = MavLinkPacketSignature.key('a phrase that both sides know')
const half = 500

// The same choice as in Program.cs: lines whose fields both sides know, again from the first when they run out.
const lines = readFileSync(golden, 'utf8').trim().split('\n').map(line => JSON.parse(line)).filter(line => line.peer === 'agree')
const lineOf = index => lines[index % lines.length]

async function packetsOf(bytes, use) {
  const splitter = new MavLinkPacketSplitter()
  const parser = splitter.pipe(new MavLinkPacketParser())
  parser.on('data', use)
  const ended = new Promise((resolve, reject) => parser.on('end', resolve).on('error', reject))
  for (let start = 0; start < bytes.length; start += 65536)
    splitter.write(bytes.subarray(start, start + 65536))
  splitter.end()
  await ended
}

// golden.jsonl writes 64-bit integers, NaN and infinities as texts.
function isSame(actual, expected) {
  if (Array.isArray(expected)) return expected.every((value, index) => isSame(actual[index], value))
  if (typeof actual === 'bigint') return actual === BigInt(expected)
  if (typeof actual === 'number' && typeof expected === 'string')
    return Object.is(actual, { nan: NaN, inf: Infinity, '-inf': -Infinity }[expected] ?? Number(expected))
  return Object.is(actual, expected)
}

async function readOurs() {
  const faults = []
  let index = 0
  await packetsOf(readFileSync(join(folder, 'ours.bin')), packet => {
    const line = lineOf(index)
    const { header } = packet
    const name = `frame ${index} ${line.name} ${line.case}`
    if (header.msgid !== line.id || header.sysid !== 7 || header.compid !== 191 || header.seq !== index % 256) faults.push(`${name}: header ${JSON.stringify(header)}`)
    const isSigned = index >= half
    if (isSigned !== (packet.signature !== null)) faults.push(`${name}: signed ${packet.signature !== null}`)
    else if (isSigned && !(packet.signature.matches(key) && packet.signature.linkId === 3)) faults.push(`${name}: signature`)
    const message = registry[line.id]
    const data = packet.protocol.data(packet.payload, message)
    for (const field of message.FIELDS) {
      if (field.source in line.fields && !isSame(data[field.name], line.fields[field.source])) faults.push(`${name}: ${field.source} is ${data[field.name]}`)
    }
    index++
  })
  return { frames: index, faults }
}

function valueOf(field, value) {
  if (Array.isArray(value)) return value.map(element => valueOf({ ...field, type: field.type.replace('[]', '') }, element))
  if (field.type.includes('int64')) return BigInt(value)
  if (typeof value === 'string' && field.type !== 'char[]' && field.type !== 'char') return { nan: NaN, inf: Infinity, '-inf': -Infinity }[value] ?? Number(value)
  return value
}

function writeTheirs() {
  const parts = []
  for (let index = 0; index < 2 * half; index++) {
    const line = lineOf(index)
    const message = new registry[line.id]()
    for (const field of registry[line.id].FIELDS) {
      if (field.source in line.fields) message[field.name] = valueOf(field, line.fields[field.source])
    }
    const isSigned = index >= half
    const protocol = new MavLinkProtocolV2(9, 190, isSigned ? MavLinkProtocolV2.IFLAG_SIGNED : 0)
    const frame = protocol.serialize(message, index % 256)
    parts.push(isSigned ? protocol.sign(frame, 4, key, Date.UTC(2026, 0, 1) + index) : frame)
  }
  writeFileSync(join(folder, 'theirs.bin'), Buffer.concat(parts))
}

async function timeFlight() {
  const flight = readFileSync(join(folder, 'flight.bin'))
  let framing = Infinity
  let decoding = Infinity
  let frames = 0
  for (let pass = 0; pass < 5; pass++) {
    frames = 0
    let start = process.hrtime.bigint()
    await packetsOf(flight, () => frames++)
    framing = Math.min(framing, Number(process.hrtime.bigint() - start))
    start = process.hrtime.bigint()
    await packetsOf(flight, packet => {
      const message = registry[packet.header.msgid]
      if (message) packet.protocol.data(packet.payload, message)
    })
    decoding = Math.min(decoding, Number(process.hrtime.bigint() - start))
  }
  return { frames, framingNanoseconds: framing, decodingNanoseconds: decoding }
}

writeTheirs()
const ours = await readOurs()
writeFileSync(join(folder, 'node.json'), JSON.stringify({ ours, flight: await timeFlight() }, null, 1))
