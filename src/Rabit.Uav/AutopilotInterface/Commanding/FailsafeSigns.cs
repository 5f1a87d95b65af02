using System;
using System.Globalization;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Distinguishes a failsafe of the autopilot from a pilot's change of the mode: by its state, its fence, its texts and
/// events. No I/O, one thread.
/// </summary>
internal sealed class FailsafeSigns
{
    /// <summary>How near to the change of the mode, before or after it, a text or an event counts.</summary>
    public static readonly TimeSpan Near = TimeSpan.FromSeconds(5);

    private TimeSpan? _signAt;
    private string? _sign;
    private bool _isFenceBreached;

    /// <summary>Takes a text of the vehicle; ArduPilot names its failsafes in it.</summary>
    public void TakeText(string text, TimeSpan time)
    {
        if ((Contains(text, "failsafe") || Contains(text, "fence breach")) && !Contains(text, "cleared"))
            Note(text, time);
    }

    /// <summary>Takes an event of PX4 (EVENT); it sends no text where it receives no ground station.</summary>
    public void TakeEvent(uint id, TimeSpan time)
    {
        if (Px4FailsafeEvents.NameOf(id) is { } name)
            Note(name, time);
    }

    /// <summary>Takes what the fence of the autopilot reports.</summary>
    public void TakeFence(bool isBreached) => _isFenceBreached = isBreached;

    /// <summary>What failsafe changed the mode; null where none did.</summary>
    /// <param name="vehicle">The state.</param>
    /// <param name="changedAt">When the mode was reported.</param>
    public string? Find(in VehicleState vehicle, TimeSpan changedAt)
    {
        if (_signAt is { } at && (at - changedAt).Duration() <= Near)
            return _sign;
        if (_isFenceBreached)
            return "fence breached";
        return vehicle.SystemStatus is MavState.Critical or MavState.Emergency
            ? "status " + vehicle.SystemStatus
            : null;
    }

    private static bool Contains(string text, string part)
        => CultureInfo.InvariantCulture.CompareInfo.IndexOf(text, part, CompareOptions.OrdinalIgnoreCase) >= 0;

    private void Note(string sign, TimeSpan time) => (_sign, _signAt) = (sign, time);
}
