using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>One STATUSTEXT, of any source. A plain value.</summary>
public readonly struct FlightStatusText
{
    internal FlightStatusText(in FlightPlace place, MavSeverity severity, string text)
    {
        Link = place.Link;
        Record = place.Record;
        UtcMicroseconds = place.UtcMicroseconds;
        SystemId = place.SystemId;
        ComponentId = place.ComponentId;
        Severity = severity;
        Text = text;
    }

    /// <summary>Number of the link that it came from, from 0.</summary>
    public int Link { get; }

    /// <summary>Which frame of its link it is, from 0; in a recorded log the number of its record.</summary>
    public long Record { get; }

    /// <summary>When it came in, microseconds since 1970 UTC; for a recorded log the stamp of its record.</summary>
    public long UtcMicroseconds { get; }

    /// <summary>System id of the sender.</summary>
    public byte SystemId { get; }

    /// <summary>Component id of the sender.</summary>
    public byte ComponentId { get; }

    /// <summary>The severity.</summary>
    public MavSeverity Severity { get; }

    /// <summary>The text of this message; a long text comes in several.</summary>
    public string Text { get; }
}
