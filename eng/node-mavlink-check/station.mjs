// The ground station of eng/ground-station-check.sh: node-mavlink, a library that knows nothing of us, asks component 191 for its parameters,
// sets one, commands it and uploads a fence to it.
//   node station.mjs PORT     where the frames of UavConsole come in
import dgram from 'node:dgram'
import { PassThrough } from 'node:stream'
import mavlink from 'node-mavlink'

const { MavLinkPacketSplitter, MavLinkPacketParser, MavLinkProtocolV2, common, minimal } = mavlink
const vehicle = 1, computer = 191, patience = 20_000
const protocol = new MavLinkProtocolV2(255, 190)
const socket = dgram.createSocket('udp4')
const input = new PassThrough()
const waiting = []
let peer = null, sequence = 0, passed = 0, failed = 0

socket.on('message', (bytes, from) => { peer = from; input.write(bytes) })
input.pipe(new MavLinkPacketSplitter()).pipe(new MavLinkPacketParser()).on('data', packet => {
  if (packet.header.sysid !== vehicle || packet.header.compid !== computer) return
  for (const each of [...waiting]) {
    if (packet.header.msgid !== each.type.MSG_ID) continue
    const message = packet.protocol.data(packet.payload, each.type)
    if (each.isMeant(message)) each.take(message)
  }
})

const to = (type, fields) => Object.assign(new type(), { targetSystem: vehicle, targetComponent: computer }, fields)
const send = message => socket.send(protocol.serialize(message, sequence++ & 255), peer.port, peer.address)

function next(type, isMeant = () => true, ms = patience) {
  return new Promise((resolve, reject) => {
    const entry = { type, isMeant, take: message => { end(); resolve(message) } }
    const timer = setTimeout(() => { end(); reject(new Error(`no ${type.MSG_NAME} came`)) }, ms)
    const end = () => { clearTimeout(timer); waiting.splice(waiting.indexOf(entry), 1) }
    waiting.push(entry)
  })
}

// A frame over UDP may be lost: what is not answered within 2 s is sent again.
async function ask(message, type, isMeant) {
  for (let left = patience; ; left -= 2000) {
    const answer = next(type, isMeant, Math.min(left, 2000))
    send(message)
    try { return await answer } catch (e) { if (left <= 2000) throw e }
  }
}

async function check(name, work) {
  try {
    const fault = await work()
    if (fault) throw new Error(fault)
    passed++
    console.log(`${name}: ok`)
  } catch (e) {
    failed++
    console.log(`${name}: ${e.message}: FAILED`)
  }
}

const nameOf = value => value.paramId.replace(/\0.*$/, '')
const isOwn = name => value => nameOf(value) === name
const set = (name, value) => ask(to(common.ParamSet, { paramId: name, paramValue: value, paramType: 9 }), common.ParamValue, isOwn(name))
function command(number, parameters) {
  const message = to(common.CommandLong, { command: number })
  parameters.forEach((value, index) => { message[`_param${index + 1}`] = value })
  return ask(message, common.CommandAck, ack => ack.command === number && ack.result !== common.MavResult.IN_PROGRESS)
}

await new Promise(resolve => socket.bind(Number(process.argv[2]), '127.0.0.1', resolve))
await check('heartbeat of component 191', async () => { await next(minimal.Heartbeat, () => true, 60_000) })
setInterval(() => peer && send(Object.assign(new minimal.Heartbeat(), { type: 6, autopilot: 8, systemStatus: 4 })), 1000).unref()

await check('parameters listed', async () => {
  const values = new Map()
  const first = await ask(to(common.ParamRequestList, {}), common.ParamValue, value => { values.set(value.paramIndex, nameOf(value)); return true })
  while (values.size < first.paramCount) await next(common.ParamValue, value => { values.set(value.paramIndex, nameOf(value)); return true })
  return [...values.values()].every(name => name.startsWith('RBT_')) && values.size === 9 ? null : [...values.values()].join(' ')
})
await check('parameter set', async () => { const { paramValue } = await set('RBT_SPEED', 4); return paramValue === 4 ? null : `it is ${paramValue}` })
await check('parameter refused', async () => { const { paramValue } = await set('RBT_SPEED', 300); return paramValue === 4 ? null : `it is ${paramValue}` })
await check('unknown command', async () => {
  const { result } = await command(183, [1])
  return result === common.MavResult.UNSUPPORTED ? null : `result ${result}`
})
await check('fence uploaded', async () => {
  const corners = JSON.parse(process.argv[3])
  const fence = { missionType: common.MavMissionType.FENCE }
  const isFence = message => message.missionType === common.MavMissionType.FENCE
  let acknowledged = next(common.MissionAck, isFence, 40_000)
  let request = await ask(to(common.MissionCount, { ...fence, count: corners.length }), common.MissionRequestInt, isFence)
  const items = corners.map(([latitude, longitude], seq) => to(common.MissionItemInt, {
    ...fence, seq, frame: 0, command: 5001, param1: corners.length, x: Math.round(latitude * 1e7), y: Math.round(longitude * 1e7),
  }))
  const requests = { type: common.MissionRequestInt, isMeant: isFence, take: message => send(items[message.seq]) }
  waiting.push(requests)
  send(items[request.seq])
  const { type } = await acknowledged
  waiting.splice(waiting.indexOf(requests), 1)
  return type === common.MavMissionResult.ACCEPTED ? null : `acknowledged with ${type}`
})
await check('hold', async () => {
  const { result } = await command(193, [0])
  return result === common.MavResult.ACCEPTED ? null : `result ${result}`
})
console.log(`${passed} passed, ${failed} failed`)
process.exit(failed === 0 ? 0 : 1)
