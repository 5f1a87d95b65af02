using System;

namespace Rabit.Uav.Reporting;

/// <summary>One vehicle of a group, for <see cref="GroupFlightSummary"/>. Immutable.</summary>
public sealed class GroupVehicleSummary
{
    /// <summary>Makes it.</summary>
    /// <param name="systemId">MAVLink system id of the vehicle.</param>
    /// <param name="flight">How it flew.</param>
    public GroupVehicleSummary(byte systemId, FlightSummary flight)
        => (SystemId, Flight) = (systemId, flight ?? throw new ArgumentNullException(nameof(flight)));

    /// <summary>MAVLink system id of the vehicle.</summary>
    public byte SystemId { get; }

    /// <summary>How it flew.</summary>
    public FlightSummary Flight { get; }

    /// <summary>The time of the group at which the clock of its own run was zero.</summary>
    public TimeSpan ClockOffset { get; init; }

    /// <summary>What it sent to the others; null where that is not known.</summary>
    public RadioUse? Radio { get; init; }

    /// <summary>
    /// The file of its own report as the report of the group links to it, for example a name in the same folder; empty
    /// for none.
    /// </summary>
    public string ReportFile { get; init; } = string.Empty;
}
