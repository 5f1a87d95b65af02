using System;
using System.Globalization;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Distinguishes a failsafe of the autopilot from a pilot's change of the mode: by its state, its fence, its texts and
/// events, and what becomes unhealthy. No I/O, one thread.
/// </summary>
internal sealed class FailsafeSigns
{
    /// <summary>How near to the change of the mode, before or after it, a text or an event counts.</summary>
    public static readonly TimeSpan Near = TimeSpan.FromSeconds(5);

    // What real autopilots set within 0.4 s of the failsafe, and at no other time (ap-battery-*, ap-rc-failsafe,
    // ap-fence-reboot, px4-battery-*). Other bits are set before arming, too, and with other causes.
    private static readonly (MavSysStatusSensor Bit, string Name)[] HealthSigns =
    [
        (MavSysStatusSensor.RcReceiver, "RC_RECEIVER"), (MavSysStatusSensor.Battery, "BATTERY"),
        (MavSysStatusSensor.Geofence, "GEOFENCE"),
    ];

    private MavSysStatusSensor? _unhealthy;
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

    /// <summary>Takes what is present, enabled and not healthy (SYS_STATUS).</summary>
    public void TakeHealth(in SysStatus status, TimeSpan time)
    {
        MavSysStatusSensor unhealthy = status.OnboardControlSensorsPresent & status.OnboardControlSensorsEnabled
            & ~status.OnboardControlSensorsHealth;
        foreach ((MavSysStatusSensor bit, string name) in HealthSigns)
        {
            // What never was healthy, as a transmitter that is not there, is no sign.
            if (_unhealthy is { } before && (unhealthy & ~before & bit) != 0)
                Note($"SYS_STATUS: {name} unhealthy", time);
        }

        _unhealthy = unhealthy;
    }

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
