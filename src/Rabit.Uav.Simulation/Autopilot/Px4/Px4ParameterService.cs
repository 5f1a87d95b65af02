using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// PX4's parameters by the parameter protocol's server, one for each link. Every PARAM_SET of a known name is answered
/// by the value that stands; a type that is not the parameter's own changes nothing. An unknown name gets no answer.
/// </summary>
internal sealed class Px4ParameterService : IMavlinkParameterStore
{
    private const int SentInStep = 4;   // about 400 a second, as recorded

    private static readonly MavlinkParameterServerOptions Options = new()
    {
        HandlesBroadcast = true,
        ListInterval = TimeSpan.FromTicks(
            (long)(SimulatedVehicle.StepSeconds * TimeSpan.TicksPerSecond / SentInStep)),
        SendsErrors = false,
        SendsReasons = false,
    };

    private readonly Px4Parameters _parameters;
    private readonly Action _changed;
    private readonly ILinkSink _sink;
    private readonly OwnServer<MavlinkParameterServer>[] _servers;

    /// <param name="parameters">What is stored.</param>
    /// <param name="changed">Called when one was set.</param>
    /// <param name="systemId">Of the autopilot.</param>
    /// <param name="sink">Takes what it sends.</param>
    public Px4ParameterService(Px4Parameters parameters, Action changed, Func<byte> systemId, ILinkSink sink)
    {
        (_parameters, _changed, _sink) = (parameters, changed, sink);
        _servers = new OwnServer<MavlinkParameterServer>[sink.LinkCount];
        for (int link = 0; link < _servers.Length; link++)
        {
            _servers[link] = new OwnServer<MavlinkParameterServer>(
                systemId,
                (sender, _) => new MavlinkParameterServer(sender, this, MavlinkParameterEncoding.Bytewise, Options));
        }
    }

    public int Count => _parameters.Count;

    public MavlinkParameterValue this[int index]
        => new(new Text16(_parameters[index].Name), _parameters[index].Type, _parameters[index].Value);

    public bool TrySet(in MavlinkParameterChange change, out MavlinkParameterRefusal refusal)
    {
        refusal = default;
        _parameters[change.Index].Set(change.Value);
        _changed();
        return true;
    }

    public void Handle(in MavlinkFrame frame, TimeSpan time, int link)
    {
        MavlinkParameterServer server = _servers[link].Value;
        server.Handle(frame, time);
        Send(server, time, link);
    }

    /// <summary>Goes on with the lists.</summary>
    public void Step(TimeSpan time)
    {
        for (int link = 0; link < _servers.Length; link++)
            Send(_servers[link].Value, time, link);
    }

    private void Send(MavlinkParameterServer server, TimeSpan time, int link)
    {
        while (server.TryTakeFrame(time, out MavlinkFrame frame))
            _sink.SendNumbered(link, frame);
    }
}
