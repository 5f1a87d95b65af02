using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// Where in the stream of frames something was: what all entries of a <see cref="TelemetryRecord"/> have in common.
/// </summary>
internal readonly struct FlightPlace(in LinkFrame frame)
{
    public int Link { get; } = frame.Link;

    public long Record { get; } = frame.Index;

    public long UtcMicroseconds { get; } = frame.UtcMicroseconds;

    public byte SystemId { get; } = frame.Frame.SystemId;

    public byte ComponentId { get; } = frame.Frame.ComponentId;
}
