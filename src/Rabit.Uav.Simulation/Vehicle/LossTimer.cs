using System;

namespace Rabit.Uav.Simulation;

/// <summary>When something was received last, and whether it has been silent for too long since.</summary>
internal sealed class LossTimer
{
    private TimeSpan? _received;

    /// <summary>Whether it was received at all.</summary>
    public bool HasReceived => _received is not null;

    public void Receive(TimeSpan time) => _received = time;

    /// <summary>Whether it was received, but not for more than a time.</summary>
    public bool IsLost(TimeSpan time, double seconds)
        => _received is { } received && (time - received).ExactSeconds > seconds;
}
