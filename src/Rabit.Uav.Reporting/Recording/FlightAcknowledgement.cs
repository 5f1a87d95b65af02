using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>One COMMAND_ACK, of any source. A plain value.</summary>
public readonly struct FlightAcknowledgement
{
    internal FlightAcknowledgement(in FlightPlace place, in CommandAck ack)
    {
        Link = place.Link;
        Record = place.Record;
        UtcMicroseconds = place.UtcMicroseconds;
        SystemId = place.SystemId;
        ComponentId = place.ComponentId;
        Command = ack.Command;
        Result = ack.Result;
        Progress = ack.Progress;
        ResultParam2 = ack.ResultParam2;
        TargetSystem = ack.TargetSystem;
        TargetComponent = ack.TargetComponent;
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

    /// <summary>The command that is answered.</summary>
    public MavCmd Command { get; }

    /// <summary>The answer.</summary>
    public MavResult Result { get; }

    /// <summary>Progress in per cent where the result is in progress; 0 where the sender does not report it.</summary>
    public byte Progress { get; }

    /// <summary>More on the result; its meaning depends on the command.</summary>
    public int ResultParam2 { get; }

    /// <summary>System id of the receiver; 0 for all.</summary>
    public byte TargetSystem { get; }

    /// <summary>Component id of the receiver; 0 for all.</summary>
    public byte TargetComponent { get; }
}
