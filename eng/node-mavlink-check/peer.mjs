// A ground station of node-mavlink, a library that knows nothing of us: frames over UDP, requests that are sent again, checks that are counted.
import dgram from 'node:dgram'
import { PassThrough } from 'node:stream'
import mavlink from 'node-mavlink'

const { MavLinkPacketSplitter, MavLinkPacketParser, MavLinkProtocolV2, minimal } = mavlink
const patience = 20_000

export class Peer {
  constructor(system, target, peer = null) {
    Object.assign(this, { target, peer, protocol: new MavLinkProtocolV2(system, 190), waiting: [], sequence: 0, passed: 0, failed: 0 })
    this.socket = dgram.createSocket('udp4')
    const input = new PassThrough()
    this.socket.on('message', (bytes, from) => { this.peer = from; input.write(bytes) })
    input.pipe(new MavLinkPacketSplitter()).pipe(new MavLinkPacketParser()).on('data', packet => {
      if (packet.header.sysid !== target.system || packet.header.compid !== target.component) return
      for (const each of [...this.waiting]) {
        if (packet.header.msgid !== each.type.MSG_ID) continue
        const message = packet.protocol.data(packet.payload, each.type)
        if (each.isMeant(message)) each.take(message)
      }
    })
  }

  open(port = 0) { return new Promise(resolve => this.socket.bind(port, '127.0.0.1', resolve)) }

  startHeartbeats() {
    const beat = () => this.peer && this.send(Object.assign(new minimal.Heartbeat(), { type: 6, autopilot: 8, systemStatus: 4 }))
    beat()
    setInterval(beat, 1000).unref()
  }

  to(type, fields) {
    return Object.assign(new type(), { targetSystem: this.target.system, targetComponent: this.target.component }, fields)
  }

  send(message) {
    this.socket.send(this.protocol.serialize(message, this.sequence++ & 255), this.peer.port, this.peer.address)
  }

  next(type, isMeant = () => true, ms = patience) {
    return new Promise((resolve, reject) => {
      const entry = { type, isMeant, take: message => { end(); resolve(message) } }
      const timer = setTimeout(() => { end(); reject(new Error(`no ${type.MSG_NAME} came`)) }, ms)
      const end = () => { clearTimeout(timer); this.waiting.splice(this.waiting.indexOf(entry), 1) }
      this.waiting.push(entry)
    })
  }

  // A frame over UDP may be lost: what is not answered within 2 s is sent again.
  async ask(message, type, isMeant, ms = patience) {
    for (let left = ms; ; left -= 2000) {
      const answer = this.next(type, isMeant, Math.min(left, 2000))
      this.send(message)
      try { return await answer } catch (e) { if (left <= 2000) throw e }
    }
  }

  async check(name, work) {
    try {
      const fault = await work()
      if (fault) throw new Error(fault)
      this.passed++
      console.log(`${name}: ok`)
    } catch (e) {
      this.failed++
      console.log(`${name}: ${e.message}: FAILED`)
    }
  }
}

export const nameOf = value => value.paramId.replace(/\0.*$/, '')
