using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>Has parameters of all types, served by <see cref="MavlinkParameterServer"/>.</summary>
internal sealed class ParameterServerVehicle : ScriptedVehicle
{
    private static readonly MavParamType[] Types =
    [
        MavParamType.Real32, MavParamType.Int32, MavParamType.Uint8, MavParamType.Int16, MavParamType.Uint32,
        MavParamType.Int8,
    ];

    private readonly MavlinkParameterServer _server;

    public ParameterServerVehicle(int count, MavlinkParameterEncoding encoding, bool sendsHash)
    {
        for (int i = 0; i < count; i++)
            List.Add($"P{i:D4}_SIXTEEN_CH".Substring(0, 6 + (i % 11)), Types[i % Types.Length], i % 100, -128, 1000);
        _server = new MavlinkParameterServer(
            Sender, List, encoding, new MavlinkParameterServerOptions { SendsHash = sendsHash });
    }

    public MavlinkParameterList List { get; } = new();

    public MavlinkParameterServer Server => _server;

    public override TimeSpan NextDue => _server.NextDue;

    public override void Handle(in MavlinkFrame frame, TimeSpan now) => _server.Handle(frame, now);

    public override void Tick(TimeSpan now)
    {
        while (_server.TryTakeFrame(now, out MavlinkFrame frame))
            Send(frame);
    }
}
