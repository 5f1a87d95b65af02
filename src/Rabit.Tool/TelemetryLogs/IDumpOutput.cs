using Rabit.Mavlink;

namespace Rabit.Tool.TelemetryLogs;

/// <summary>Takes what was asked for, record by record, and puts it out.</summary>
internal interface IDumpOutput
{
    void Add(in MavlinkFrame frame, in TlogRecord record);

    /// <summary>Called once, after the last record.</summary>
    void Finish(TlogReader log);
}
