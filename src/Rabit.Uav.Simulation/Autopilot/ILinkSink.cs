using Rabit.Mavlink;

namespace Rabit.Uav.Simulation;

/// <summary>Takes the messages that an autopilot with several links sends.</summary>
internal interface ILinkSink : IFrameSink
{
    int LinkCount { get; }

    /// <summary>Sends over one link.</summary>
    /// <param name="link">Its number, from 0.</param>
    /// <param name="message">What to send.</param>
    void Send<T>(int link, in T message)
        where T : struct, IMavlinkMessage;

    /// <summary>Sends a frame of ours that a protocol server made, with the next sequence number of the link.</summary>
    void SendNumbered(int link, MavlinkFrame frame);
}
