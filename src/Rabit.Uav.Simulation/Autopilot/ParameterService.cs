using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The parameters by the parameter protocol's server, as ArduPilot has it: an unknown name gets no answer, and what is
/// read by name or set is sent without its index.
/// </summary>
internal sealed class ParameterService(ParameterStore parameters, AutopilotAddress address, IFrameSink sink)
    : IMavlinkParameterStore
{
    // One at a step, so that a slow link is not flooded.
    private static readonly MavlinkParameterServerOptions Options = new()
    {
        HandlesBroadcast = true,
        ListInterval = TimeSpan.FromTicks((long)(SimulatedVehicle.StepSeconds * TimeSpan.TicksPerSecond)),
        OmitsIndex = true,
        SendsErrors = false,
        SendsReasons = false,
    };

    private OwnServer<MavlinkParameterServer>? _server;

    public int Count => parameters.Count;

    private MavlinkParameterServer Server => (_server ??= new(
        () => address.SystemId,
        (sender, _) => new MavlinkParameterServer(sender, this, MavlinkParameterEncoding.CCast, Options))).Value;

    public MavlinkParameterValue this[int index]
        => new(new Text16(parameters[index].Name), parameters[index].Type, parameters[index].Value);

    public bool TrySet(in MavlinkParameterChange change, out MavlinkParameterRefusal refusal)
    {
        refusal = default;
        parameters[change.Index].Set((float)change.Value);
        return true;
    }

    public void Handle(in MavlinkFrame frame, TimeSpan time)
    {
        // No number is no value, and gets no answer.
        if (frame.MessageId == ParamSet.MavlinkId && frame.TryDecode(out ParamSet set)
            && (float.IsNaN(set.ParamValue) || float.IsInfinity(set.ParamValue)))
        {
            return;
        }

        MavlinkParameterServer server = Server;
        server.Handle(frame, time);
        Send(server, time);
    }

    /// <summary>Reports one that has changed by itself.</summary>
    public void Report(Parameter parameter, TimeSpan time)
    {
        Server.Report(parameters.IndexOf(new Text16(parameter.Name)));
        Send(Server, time);
    }

    /// <summary>Goes on with the list.</summary>
    public void Step(TimeSpan time) => Send(Server, time);

    private void Send(MavlinkParameterServer server, TimeSpan time)
    {
        while (server.TryTakeFrame(time, out MavlinkFrame frame))
            sink.SendNumbered(frame);
    }
}
