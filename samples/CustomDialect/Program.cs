using System;
using System.Text;
using Orchard.Messages;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

// Messages of our own (dialects/*.xml) and of the package, out and in again over one stream of bytes.
var wire = new byte[1024];
int length = 0;
Send(
    new Heartbeat
    {
        Type = MavType.Quadrotor,
        Autopilot = MavAutopilot.Px4,
        SystemStatus = MavState.Active,
        MavlinkVersion = 3
    },
    0);
Send(
    new CompanyState
    {
        TimeBootMs = 1500,
        LastCommand = OrchardMavCmd.OrchardPick,
        Mode = CompanyMode.Picking,
        Status = MavState.Active
    },
    1);
Send(
    new OrchardFruit
    {
        Number = 7,
        Position = new FloatArray3([0.5f, -0.25f, 1.5f]),
        Spectrum = new UInt16Array5([10, 20, 30]),
        Flags = OrchardFruitFlags.Ripe | OrchardFruitFlags.BehindLeaves,
        Variety = new Text12("Boskoop"),
        Temperature = 1850,
    },
    2);
// A command of our own is a value of the package's MavCmd.
Send(new CommandLong { TargetSystem = 1, Command = OrchardMavCmd.OrchardPick, Param1 = 12 }, 3);

// One receiver for our dialect and the messages of ArduPilot.
MavlinkDialect dialect = MavlinkDialect.Combine(
    "orchard and ArduPilot", OrchardDialect.Instance, MavlinkDialect.ArduPilotMega);
Console.WriteLine($"{dialect.Name}: {dialect.Count} messages, {OrchardDialect.Instance.Count} of them in "
    + $"{OrchardDialect.Instance.Name}.xml and what it includes");
var reader = new MavlinkFrameReader(dialect);
ReadOnlySpan<byte> bytes = wire.AsSpan(0, length);
while (reader.TryRead(ref bytes, out MavlinkFrame frame, out MavlinkFrameInfo info))
{
    // Known when this was compiled: a struct. Known only to the definitions: printed all the same.
    if (frame.TryDecode(out OrchardFruit fruit))
        Console.WriteLine($"{info.Message.Name}: number {fruit.Number} is {fruit.Position[2]:0.0} m below, "
            + $"{fruit.Temperature / 100.0:0.0} degrees, {fruit.Flags}");
    var text = new StringBuilder();
    dialect.FindDefinition(frame.MessageId)!.AppendTo(text, frame);
    Console.WriteLine(text);
}

void Send<T>(T message, byte sequence)
    where T : struct, IMavlinkMessage
{
    MavlinkFrame frame = MavlinkFrame.Create(message, systemId: 1, componentId: 191, sequence);
    length += frame.WriteTo(wire.AsSpan(length));
}
