using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// What one sender, which may be the vehicle's autopilot, reported: mode changes and the ranges of its positions.
/// </summary>
internal sealed class SourceRecord
{
    private readonly FlightModeNames _modeNames = new();

    public BoundedLog<FlightModeChange> ModeChanges { get; } = new(TelemetryRecord.ListCapacity);

    public PositionRanges Ranges { get; private set; }

    public Heartbeat? LastHeartbeat { get; private set; }

    /// <summary>Of its flight software; null before it reported it.</summary>
    public string? Firmware { get; private set; }

    public void Record(in AutopilotVersion version)
    {
        if (version.FlightSwVersion != 0)
            Firmware = FirmwareText.Of(version.FlightSwVersion);
    }

    public void Record(in GlobalPositionInt position) => Ranges = Ranges.With(position);

    public void Record(in LinkFrame frame, in Heartbeat heartbeat)
    {
        // "INVALID": not a flight controller (MAVLink guide, "Heartbeat/Connection Protocol").
        if (heartbeat.Autopilot == MavAutopilot.Invalid)
            return;
        bool isChange = LastHeartbeat is not { } last
            || last.BaseMode != heartbeat.BaseMode
            || last.CustomMode != heartbeat.CustomMode
            || last.SystemStatus != heartbeat.SystemStatus;
        LastHeartbeat = heartbeat;
        if (isChange)
        {
            ModeChanges.Add(new FlightModeChange(
                new FlightPlace(frame), heartbeat.CustomMode, heartbeat.BaseMode, heartbeat.SystemStatus,
                _modeNames.NameOf(heartbeat)));
        }
    }
}
