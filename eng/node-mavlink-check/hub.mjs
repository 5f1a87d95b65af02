// Two ground stations of eng/ground-station-check.sh at once, each as a stock one: they connect to UavConsole as if it were the vehicle, and list and
// set the autopilot's parameters, upload and download a mission, a fence and rally points, read its parameter file by MAVLink FTP, ping it.
//   node hub.mjs PORT     where UavConsole takes ground stations
import mavlink from 'node-mavlink'
import { Peer, nameOf } from './peer.mjs'

const { common, minimal } = mavlink
const { MavMissionType, MavMissionResult } = common
const port = Number(process.argv[2])
const stations = [254, 253].map(system => new Peer(system, { system: 1, component: 1 }, { port, address: '127.0.0.1' }))

function itemsOf(peer, missionType) {
  const command = missionType === MavMissionType.FENCE ? 5001 : missionType === MavMissionType.RALLY ? 5100 : 16
  return [0, 1, 2, 3].map(seq => peer.to(common.MissionItemInt, {
    missionType, seq, frame: missionType === MavMissionType.FENCE ? 0 : 3, command, autocontinue: 1, param1: missionType === MavMissionType.FENCE ? 4 : 0,
    x: 473970000 + 9000 * (seq === 1 || seq === 2), y: 85440000 + 9000 * (seq > 1), z: 30,
  }))
}

// Another station's upload may be under way: then it is tried again.
async function upload(peer, missionType) {
  const isOurs = message => message.missionType === missionType && message.targetSystem === peer.protocol.sysid
  const items = itemsOf(peer, missionType)
  for (let tries = 0; tries < 10; tries++) {
    const requests = [common.MissionRequest, common.MissionRequestInt]
      .map(type => ({ type, isMeant: isOurs, take: message => peer.send(items[message.seq]) }))
    peer.waiting.push(...requests)
    const { type } = await peer.ask(peer.to(common.MissionCount, { missionType, count: items.length }), common.MissionAck, isOurs)
    requests.forEach(each => peer.waiting.splice(peer.waiting.indexOf(each), 1))
    if (type === MavMissionResult.ACCEPTED) return null
    await new Promise(resolve => setTimeout(resolve, 1000))
  }
  return 'it was never accepted'
}

// What another station uploads meanwhile ends a download.
async function download(peer, missionType) {
  for (let tries = 0; ; tries++) {
    try {
      return await downloadOnce(peer, missionType)
    } catch (e) {
      if (tries === 9) throw e
    }
  }
}

async function downloadOnce(peer, missionType) {
  const isOurs = message => message.missionType === missionType && message.targetSystem === peer.protocol.sysid
  const { count } = await peer.ask(peer.to(common.MissionRequestList, { missionType }), common.MissionCount, isOurs, 4000)
  const items = itemsOf(peer, missionType)
  if (count !== items.length) return `${count} items`
  for (let seq = 0; seq < count; seq++) {
    const isThis = message => isOurs(message) && message.seq === seq
    const item = await peer.ask(peer.to(common.MissionRequestInt, { missionType, seq }), common.MissionItemInt, isThis, 4000)
    const isHome = missionType === MavMissionType.MISSION && seq === 0
    if (!isHome && (item.x !== items[seq].x || item.command !== items[seq].command)) return `item ${seq} is another`
  }
  peer.send(peer.to(common.MissionAck, { missionType, type: MavMissionResult.ACCEPTED }))
  return null
}

let ftpSequence = 0
async function transfer(peer, opcode, { session = 0, offset = 0, data = Buffer.alloc(0), size = data.length } = {}) {
  const packet = Buffer.alloc(251)
  const sequence = ftpSequence++
  packet.writeUInt16LE(sequence, 0)
  packet.set([session, opcode, size], 2)
  packet.writeUInt32LE(offset, 8)
  data.copy(packet, 12)
  const isAnswer = message => message.targetSystem === peer.protocol.sysid
    && Buffer.from(message.payload).readUInt16LE(0) === ((sequence + 1) & 0xFFFF)
  const request = Object.assign(new common.FileTransferProtocol(), {
    targetNetwork: 0, targetSystem: peer.target.system, targetComponent: peer.target.component, payload: [...packet],
  })
  const answer = Buffer.from((await peer.ask(request, common.FileTransferProtocol, isAnswer)).payload)
  return { isDone: answer[3] === 128, session: answer[2], data: answer.subarray(12, 12 + answer[4]) }
}

async function readParameterFile(peer, count) {
  const { isDone, session, data } = await transfer(peer, 4, { data: Buffer.from('@PARAM/param.pck') })
  if (!isDone) return 'it cannot be opened'
  const file = Buffer.alloc(data.readUInt32LE(0))
  for (let offset = 0; offset < file.length;) {
    const part = await transfer(peer, 5, { session, offset, size: 239 })
    if (!part.isDone) return `it ends at ${offset} of ${file.length}`
    part.data.copy(file, offset)
    offset += part.data.length
  }
  await transfer(peer, 1, { session })
  return file.readUInt16LE(0) === 0x671B && file.readUInt16LE(4) === count ? null : `magic ${file.readUInt16LE(0)}, ${file.readUInt16LE(4)} parameters`
}

async function work(peer, index) {
  const who = `station ${peer.protocol.sysid}`
  const values = new Map()
  await peer.open()
  peer.startHeartbeats()
  await peer.check(`${who}: heartbeat of the autopilot`, async () => { await peer.next(minimal.Heartbeat, () => true, 60_000) })
  await peer.check(`${who}: parameters`, async () => {
    const keep = value => { if (value.paramIndex !== 65535) values.set(value.paramIndex, nameOf(value)); return true }
    const first = await peer.ask(peer.to(common.ParamRequestList, {}), common.ParamValue, keep)
    while (values.size < first.paramCount) await peer.next(common.ParamValue, keep)
    return values.size > 40 ? null : `${values.size} parameters`
  })
  await peer.check(`${who}: parameter set`, async () => {
    const [name, wanted] = [['RTL_LOIT_TIME', 4000], ['DISARM_DELAY', 8]][index]
    const set = peer.to(common.ParamSet, { paramId: name, paramValue: wanted, paramType: 9 })
    const { paramValue } = await peer.ask(set, common.ParamValue, value => nameOf(value) === name && value.paramIndex === 65535)
    return paramValue === wanted ? null : `it is ${paramValue}`
  })
  for (const [name, type] of [['mission', MavMissionType.MISSION], ['fence', MavMissionType.FENCE], ['rally points', MavMissionType.RALLY]]) {
    await peer.check(`${who}: ${name} uploaded`, () => upload(peer, type))
    await peer.check(`${who}: ${name} downloaded`, () => download(peer, type))
  }
  await peer.check(`${who}: parameter file`, () => readParameterFile(peer, values.size))
  await peer.check(`${who}: ping`, async () => {
    const ping = Object.assign(new common.Ping(), { timeUsec: 12345n, seq: index, targetSystem: 0, targetComponent: 0 })
    await peer.ask(ping, common.Ping, answer => answer.targetSystem === peer.protocol.sysid && answer.seq === index)
  })
}

await Promise.all(stations.map(work))
const [passed, failed] = ['passed', 'failed'].map(what => stations.reduce((sum, peer) => sum + peer[what], 0))
console.log(`${passed} passed, ${failed} failed`)
process.exit(failed === 0 ? 0 : 1)
