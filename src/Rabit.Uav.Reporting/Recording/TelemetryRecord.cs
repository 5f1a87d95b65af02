using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// What the frames of a flight contain, frame by frame and in the integers of the wire: nothing of it comes from
/// latest values, so a replay gives the same record at every speed. An immutable snapshot: see
/// <see cref="FlightRecord.Telemetry"/>.
/// </summary>
/// <remarks>
/// Lists are bounded (<see cref="ListCapacity"/> entries, the first ones); what did not fit is counted.
/// </remarks>
public sealed class TelemetryRecord
{
    /// <summary>How many entries each list holds at most.</summary>
    public const int ListCapacity = 10_000;

    internal TelemetryRecord()
    {
    }

    /// <summary>The kind of autopilot; null when none was received.</summary>
    public MavAutopilot? Autopilot { get; internal init; }

    /// <summary>The kind of vehicle by its last heartbeat; null when none was received.</summary>
    public MavType? VehicleType { get; internal init; }

    /// <summary>
    /// Version of the autopilot's flight software by AUTOPILOT_VERSION, which it sends when it is asked for it; null
    /// when none was received.
    /// </summary>
    public string? Firmware { get; internal init; }

    /// <summary>MAVLink system id of the vehicle; 0 when none was received.</summary>
    public byte SystemId { get; internal init; }

    /// <summary>MAVLink component id of the autopilot; 0 when none was received.</summary>
    public byte ComponentId { get; internal init; }

    /// <summary>Frames that the recorder received, of any source.</summary>
    public long Frames { get; internal init; }

    /// <summary>Frames that are missing in this record, since the recorder's queue was full.</summary>
    public long FramesDropped { get; internal init; }

    /// <summary>Time of the first frame, microseconds since 1970 UTC; null when there was none.</summary>
    public long? FirstUtcMicroseconds { get; internal init; }

    /// <summary>Time of the last frame, microseconds since 1970 UTC; null when there was none.</summary>
    public long? LastUtcMicroseconds { get; internal init; }

    /// <summary>Latitude in GLOBAL_POSITION_INT of the vehicle, 1e-7 degrees; null when there was none.</summary>
    public FlightRange? LatitudeDegE7 { get; internal init; }

    /// <summary>Longitude in GLOBAL_POSITION_INT of the vehicle, 1e-7 degrees; null when there was none.</summary>
    public FlightRange? LongitudeDegE7 { get; internal init; }

    /// <summary>
    /// Altitude above mean sea level in GLOBAL_POSITION_INT of the vehicle, millimetres; null when there was none.
    /// </summary>
    public FlightRange? AltitudeAmslMillimetres { get; internal init; }

    /// <summary>
    /// Height above home in GLOBAL_POSITION_INT of the vehicle, millimetres; null when there was none.
    /// </summary>
    public FlightRange? HeightAboveHomeMillimetres { get; internal init; }

    /// <summary>
    /// Every change of mode, flags or system status in the vehicle's heartbeats; the first heartbeat is the first
    /// entry.
    /// </summary>
    public IReadOnlyList<FlightModeChange> ModeChanges { get; internal init; } = Array.Empty<FlightModeChange>();

    /// <summary>Changes that had no room in <see cref="ModeChanges"/>.</summary>
    public long ModeChangesLeftOut { get; internal init; }

    /// <summary>Every status text, of any source.</summary>
    public IReadOnlyList<FlightStatusText> StatusTexts { get; internal init; } = Array.Empty<FlightStatusText>();

    /// <summary>Texts that had no room in <see cref="StatusTexts"/>.</summary>
    public long StatusTextsLeftOut { get; internal init; }

    /// <summary>Every command acknowledgement, of any source.</summary>
    public IReadOnlyList<FlightAcknowledgement> Acknowledgements { get; internal init; } =
        Array.Empty<FlightAcknowledgement>();

    /// <summary>Acknowledgements that had no room in <see cref="Acknowledgements"/>.</summary>
    public long AcknowledgementsLeftOut { get; internal init; }
}
