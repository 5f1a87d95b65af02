using Rabit.Mavlink;

namespace Rabit.Uav.Simulation;

/// <summary>Takes the messages that the autopilot sends.</summary>
internal interface IFrameSink
{
    void Send<T>(in T message)
        where T : struct, IMavlinkMessage;
}
