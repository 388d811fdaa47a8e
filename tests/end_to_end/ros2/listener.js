// Listens to a robot's topics of ROS 2 and prints each message as a line of JSON: {topic, userData, message}. Stays on
// this machine: what would go to the multicast address of a domain goes to the ports of its first participants here.
//
//   node listener.js DOMAIN
"use strict";
const { parse } = require("@foxglove/rosmsg");
const { RosNode } = require("@foxglove/ros2");
const { UdpSocketNode } = require("@foxglove/rtps/nodejs");
const dgram = require("dgram");

const loopback = "127.0.0.1";
const participants = 10;
const patience = 3000; // ms until it begins anew, should its only announcement have come too early

const header = `
===
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id`;
const topics = [
  {
    topic: "/joint_states",
    dataType: "sensor_msgs/msg/JointState",
    text: `std_msgs/Header header
string[] name
float64[] position
float64[] velocity
float64[] effort` + header,
  },
  {
    topic: "/diagnostics",
    dataType: "diagnostic_msgs/msg/DiagnosticArray",
    text: `std_msgs/Header header
diagnostic_msgs/DiagnosticStatus[] status` + header + `
===
MSG: diagnostic_msgs/DiagnosticStatus
byte level
string name
string message
string hardware_id
diagnostic_msgs/KeyValue[] values
===
MSG: diagnostic_msgs/KeyValue
string key
string value`,
  },
];

class LoopbackSocket extends UdpSocketNode {
  bind(options) {
    return super.bind({ ...options, address: loopback });
  }
  async addMembership() {}
  async send(data, offset, length, port, address) {
    if (!address.startsWith("239.")) return super.send(data, offset, length, port, address);
    for (let participant = 0; participant < participants; ++participant) {
      await super.send(data, offset, length, port + 10 + 2 * participant, loopback);
    }
  }
}

async function listen(domainId) {
  let heard = false;
  const node = new RosNode({
    name: "listener",
    domainId,
    addresses: [loopback],
    udpSocketCreate: async (options) => new LoopbackSocket(dgram.createSocket({ reuseAddr: true, ...options })),
  });
  for (const { topic, dataType, text } of topics) {
    const subscription = node.subscribe({ topic, dataType, msgDefinition: parse(text, { ros2: true }) });
    subscription.on("message", (_time, message, _data, publisher) => {
      heard = true;
      const line = { topic, userData: publisher.userData, message };
      process.stdout.write(JSON.stringify(line, (_key, value) => (ArrayBuffer.isView(value) ? [...value] : value)) + "\n");
    });
  }
  await node.start();
  setTimeout(async () => {
    if (heard) return;
    await node.shutdown();
    await listen(domainId);
  }, patience);
}

listen(Number(process.argv[2]));
