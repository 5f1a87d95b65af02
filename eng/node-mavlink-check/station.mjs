// The ground station of eng/ground-station-check.sh: node-mavlink, a library that knows nothing of us, asks component 191 for its parameters,
// sets one, commands it and uploads a fence to it.
//   node station.mjs PORT     where the frames of UavConsole come in
import mavlink from 'node-mavlink'
import { Peer, nameOf } from './peer.mjs'

const { common, minimal } = mavlink
const peer = new Peer(255, { system: 1, component: 191 })
const to = (type, fields) => peer.to(type, fields), send = message => peer.send(message), waiting = peer.waiting
const next = (...all) => peer.next(...all), ask = (...all) => peer.ask(...all), check = (...all) => peer.check(...all)
const isOwn = name => value => nameOf(value) === name
const set = (name, value) => ask(to(common.ParamSet, { paramId: name, paramValue: value, paramType: 9 }), common.ParamValue, isOwn(name))
function command(number, parameters) {
  const message = to(common.CommandLong, { command: number })
  parameters.forEach((value, index) => { message[`_param${index + 1}`] = value })
  return ask(message, common.CommandAck, ack => ack.command === number && ack.result !== common.MavResult.IN_PROGRESS)
}

await peer.open(Number(process.argv[2]))
await check('heartbeat of component 191', async () => { await next(minimal.Heartbeat, () => true, 60_000) })
peer.startHeartbeats()

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
console.log(`${peer.passed} passed, ${peer.failed} failed`)
process.exit(peer.failed === 0 ? 0 : 1)
