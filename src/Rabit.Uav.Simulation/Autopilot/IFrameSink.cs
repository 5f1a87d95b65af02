using Rabit.Mavlink;

namespace Rabit.Uav.Simulation;

/// <summary>Takes the messages that the autopilot sends.</summary>
internal interface IFrameSink
{
    void Send<T>(in T message)
        where T : struct, IMavlinkMessage;

    /// <summary>Sends a frame of ours that a protocol server made, with the next sequence number.</summary>
    void SendNumbered(in MavlinkFrame frame);

    /// <summary>Passes on a frame that came over another link, as it is.</summary>
    void Forward(in MavlinkFrame frame);
}
