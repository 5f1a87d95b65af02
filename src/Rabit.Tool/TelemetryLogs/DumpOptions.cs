using System.Collections.Generic;

namespace Rabit.Tool.TelemetryLogs;

/// <summary>What the command line asks for.</summary>
internal sealed class DumpOptions(
    string file, DumpFormat format, IReadOnlyCollection<int> messageIds, byte? systemId, byte? componentId,
    string? eventsFile = null)
{
    /// <summary>The log.</summary>
    public string File => file;

    /// <summary>What comes out.</summary>
    public DumpFormat Format => format;

    /// <summary>Only these messages; empty for all.</summary>
    public IReadOnlyCollection<int> MessageIds => messageIds;

    /// <summary>Only this sender's system; null for all.</summary>
    public byte? SystemId => systemId;

    /// <summary>Only this sender's component; null for all.</summary>
    public byte? ComponentId => componentId;

    /// <summary>The texts of PX4's events; null for none.</summary>
    public string? EventsFile => eventsFile;
}
